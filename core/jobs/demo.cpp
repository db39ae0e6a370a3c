// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/demo.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/store/survey_store.h"
#include "spherewalk/survey/plan_report.h"

#include <cmath>
#include <numbers>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr double kLensHeightM = 1.2;

/// A common robot camera.
CameraIntrinsics robotCamera() {
    return CameraIntrinsics::pinhole(640, 480, Radians(Degrees(69)).value());
}

/// Once round the middle of the stations, looking ahead; poses of the optical frame, 10 a second.
std::vector<TimedPose> roundWalk(const survey::Plan& plan, int frames) {
    Polygon places;
    for (const survey::Station& station : plan.stations) {
        places.emplace_back(station.positionM.head<2>());
    }
    const Bounds2 area = bounds(places);
    const Eigen::Vector2d centre = 0.5 * (area.least + area.greatest);
    const Eigen::Vector2d radii = 0.4 * (area.greatest - area.least);
    std::vector<TimedPose> poses;
    for (int i = 0; i < frames; ++i) {
        const double turn = 2 * std::numbers::pi * i / frames;
        const Radians ahead(std::atan2(radii.y() * std::cos(turn), -radii.x() * std::sin(turn)));
        poses.push_back({0.1 * i,
                         {yawRotation(ahead) * bodyFromOptical(),
                          {centre.x() + radii.x() * std::cos(turn), centre.y() + radii.y() * std::sin(turn),
                           kLensHeightM}}});
    }
    return poses;
}

class Demo {
  public:
    Demo(const fs::path& folder, const DemoOptions& options, ProgressSink& progress,
         const std::stop_token& stop)
        : m_folder(folder),
          m_options(options),
          m_progress(progress),
          m_stop(stop),
          m_practiceRoom(roomOptions()) {}

    DemoReport run() {
        makeFolder();
        m_report.folder = m_folder;
        store::SurveyStore store = newSurvey();
        photograph(store);
        align(store);
        exportMeasured(store);
        walkThrough(store.plan());
        return std::move(m_report);
    }

  private:
    static practice::PracticeRoomOptions roomOptions() { return {}; }

    void makeFolder() const {
        std::error_code failure;
        if (fs::exists(m_folder) || !fs::create_directories(m_folder, failure)) {
            throw Error(ErrorKind::Exists,
                        text("Could not make the folder ", m_folder.string(),
                             " for the demonstration: it exists already, or its place cannot be written."));
        }
    }

    store::SurveyStore newSurvey() {
        store::SurveyStore store = newPracticeSurvey(m_folder / "practice-room.spherewalk", m_options.stepM);
        m_report.placements = static_cast<int>(store.plan().placements.size());
        return store;
    }

    void photograph(store::SurveyStore& store) {
        practice::PracticeCameraOptions options;
        options.width = m_options.photoWidth;
        options.errors.seed = m_options.seed;
        options.truthFile = m_folder / "truth.jsonl";
        options.room = roomOptions();
        practice::PracticeCamera camera(options);
        camera.start();
        constexpr double kTimeScale = 0.01; // the practice camera does not make anybody wait
        const camera::Endpoint endpoint{"127.0.0.1", camera.port()};
        camera::OscClient client(endpoint, camera::OscOptions{}.scaled(kTimeScale), systemClock());
        const CaptureSurveyOptions capture = practiceCaptureOptions(kTimeScale);
        PracticeOperator people(endpoint);
        ProgressStep capturing(m_progress, 0, after(0));
        m_report.capture = captureSurvey(store, client, people, systemClock(), capture, capturing, m_stop);
        if (m_report.capture.remaining > 0) {
            throw Error(ErrorKind::Internal,
                        text("The practice camera did not deliver ", m_report.capture.remaining,
                             " of the photos; see the messages above."));
        }
    }

    void align(store::SurveyStore& store) {
        ProgressStep aligning(m_progress, after(0), after(kAligned));
        m_report.aligned = alignSurvey(store, {}, aligning, m_stop);
        for (const std::string& warning : m_report.aligned.alignment.warnings) {
            m_progress.warning(warning);
        }
        m_report.alignmentError =
            jobs::alignmentError(m_report.aligned, readTruePoses(store, m_folder / "truth.jsonl"));
    }

    void exportMeasured(const store::SurveyStore& store) {
        constexpr int kViews = 12; // tell the scene models apart, and take a few seconds
        const fs::path folder = m_folder / "dataset";
        ExportOptions options;
        options.scene = m_options.scene.value_or(render::SceneKind::Depth);
        ProgressStep exporting(m_progress, after(kAligned), after(kExported));
        m_report.exported = exportDataset(store, folder, options, exporting, m_stop);
        m_report.scene = options.scene;
        if (m_options.scene) {
            return;
        }
        MeasureOptions measure;
        measure.mostViews = kViews;
        measure.samplingViews = kViews / 4;
        ProgressStep measuring(m_progress, after(kExported), after(kMeasured));
        const MeasureReport measured =
            measureDataset(render::Renderer(std::make_shared<const render::Dataset>(
                               render::Dataset::open(folder, render::Verify::Sizes, noProgress(), m_stop))),
                           CameraModel(robotCamera()), measure, measuring, m_stop);
        m_report.choice = measured.choice;
        if (measured.choice.rung) {
            m_report.scene = measured.rungs[*measured.choice.rung].scene;
            storeChoice(folder, measured);
        }
    }

    void walkThrough(const survey::Plan& plan) {
        const CameraModel camera(robotCamera());
        const std::vector<TimedPose> path = roundWalk(plan, m_options.frames);
        writeFile(m_folder / "robot.yaml", bytesOf(render::cameraInfoYaml(camera.intrinsics(), "robot")));
        writeFile(m_folder / "path.tum", bytesOf(tumText(path)));
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(m_folder / "dataset")));
        ProgressStep walking(m_progress, after(kMeasured), after(kWalked));
        m_report.walk = walk(renderer, camera, path, {}, m_folder / "walk", walking, m_stop);
        compare(renderer, camera, path);
    }

    /// Rows of pictures, at photos and between them: with the chosen scene model, with the sphere, and exact.
    void compare(const render::Renderer& renderer, const CameraModel& camera,
                 const std::vector<TimedPose>& path) {
        constexpr std::size_t kPlaces = 4;
        Comparison atPhotos;
        Comparison between;
        const auto& photos = renderer.dataset().info().photos;
        std::vector<RgbImage> pictures;
        std::vector<std::string> captions;
        for (std::size_t i = 0; i < kPlaces; ++i) {
            throwIfStopped(m_stop);
            const Rigid3& onPath = path[i * path.size() / kPlaces].roomFromCamera;
            const std::size_t photo = i * photos.size() / kPlaces;
            addRow(renderer, camera, {onPath.rotation, photos[photo].roomFromPhoto.translation}, "at a photo",
                   atPhotos, pictures, captions);
            addRow(renderer, camera, onPath, "between photos", between, pictures, captions);
            m_progress.progress(after(kWalked + (1 - kWalked) * static_cast<double>(i + 1) / kPlaces),
                                "Comparing with the exact room");
        }
        m_report.atPhotosDb = median(atPhotos.chosenDb);
        m_report.betweenDb = median(between.chosenDb);
        m_report.betweenWithSphereDb = median(between.sphereDb);
        photo::writePng(m_folder / "comparison.png", photo::contactSheet(pictures, 3, 480, captions));
    }

    struct Comparison {
        std::vector<double> chosenDb;
        std::vector<double> sphereDb;
    };

    void addRow(const render::Renderer& renderer, const CameraModel& camera, const Rigid3& pose,
                const std::string& where, Comparison& comparison, std::vector<RgbImage>& pictures,
                std::vector<std::string>& captions) const {
        const RgbImage exact = m_practiceRoom.view(camera, pose);
        const auto likeness = [&](std::optional<render::SceneKind> scene, const std::string& words) {
            render::ViewOptions options;
            options.scene = scene;
            pictures.push_back(renderer.render(camera, pose, options).picture);
            const double db = photo::psnr(pictures.back(), exact);
            captions.push_back(text(where, ", ", words, ": ", fixed(db, 1), " dB"));
            return db;
        };
        comparison.chosenDb.push_back(likeness({}, text(name(m_report.scene))));
        comparison.sphereDb.push_back(likeness(render::SceneKind::Sphere, "sphere"));
        pictures.push_back(exact);
        captions.emplace_back("ray cast directly");
    }

    /// A share of the progress by a share of what follows the capturing. Ray casting takes two thirds of the
    /// time at the camera's own width, and next to nothing at 1024 pixels.
    double after(double share) const {
        const double pixels = std::pow(1.0 * m_options.photoWidth / DemoOptions().photoWidth, 2);
        const double captured = 2 * pixels / (2 * pixels + 1);
        return captured + (1 - captured) * share;
    }

    static constexpr double kAligned = 0.35; ///< Shares of what follows the capturing.
    static constexpr double kExported = 0.7;
    static constexpr double kMeasured = 0.94;
    static constexpr double kWalked = 0.98;

    fs::path m_folder;
    const DemoOptions& m_options;
    ProgressSink& m_progress;
    const std::stop_token& m_stop;
    practice::PracticeRoom m_practiceRoom;
    DemoReport m_report;
};

} // namespace

store::SurveyStore newPracticeSurvey(const fs::path& folder, double stepM) {
    const practice::RoomPlan drawn = practice::PracticeRoom().plan();
    const survey::Room room{drawn.outline, drawn.obstacles, drawn.ceilingM};
    survey::PlanOptions options;
    options.stepM = stepM;
    options.heightsM = {kLensHeightM};
    return store::SurveyStore::create(folder, "practice room", room, options, survey::plan(room, options));
}

DemoReport demo(const fs::path& folder, const DemoOptions& options, ProgressSink& progress,
                const std::stop_token& stop) {
    return Demo(folder, options, progress, stop).run();
}

Json toJson(const DemoReport& report) {
    return {{"folder", report.folder.string()},
            {"placements", report.placements},
            {"capture", toJson(report.capture)},
            {"align", toJson(report.aligned)},
            {"alignment_error", toJson(report.alignmentError)},
            {"export", toJson(report.exported)},
            {"scene", name(report.scene)},
            {"choice", report.choice ? Json(report.choice->reason) : Json()},
            {"walk", toJson(report.walk)},
            {"likeness_at_photos_db", report.atPhotosDb},
            {"likeness_between_photos_db", report.betweenDb},
            {"likeness_between_photos_with_sphere_db", report.betweenWithSphereDb}};
}

} // namespace spherewalk::jobs
