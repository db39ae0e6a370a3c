// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measure_dataset.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/median.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/measure/displacement.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

namespace spherewalk::jobs {

namespace {

using measure::Displacement;

/// A true picture, where it was taken, and what the dataset must not use for it.
struct Subject {
    std::string name;
    Rigid3 roomFromCamera;
    RgbImage picture;
    DepthImage depth; ///< empty: not known
    std::optional<std::size_t> without;
};

/// How many subjects there are, and each when it is its turn: they are large.
struct Subjects {
    std::size_t count = 0;
    std::function<Subject(std::size_t)> get;
};

Subjects robotSubjects(const MeasureOptions& options, const CameraModel& camera) {
    return {options.pictures.size(), [&](std::size_t i) {
                const RobotPicture& picture = options.pictures[i];
                Subject subject{picture.file.filename().string(),
                                picture.roomFromCamera,
                                photo::readPicture(picture.file),
                                {},
                                {}};
                if (!picture.depthFile.empty()) {
                    subject.depth = photo::readDepthPng(picture.depthFile);
                }
                if (subject.picture.width() != camera.width() ||
                    subject.picture.height() != camera.height()) {
                    throw Error(ErrorKind::InvalidInput,
                                text("The picture ", picture.file.string(), " has not the camera's ",
                                     camera.width(), " x ", camera.height(), " pixels."));
                }
                return subject;
            }};
}

Subjects leftOutSubjects(const MeasureOptions& options, const render::Renderer& renderer,
                         const CameraModel& camera) {
    const std::size_t all = renderer.dataset().info().photos.size();
    const std::size_t photos = std::min(all, static_cast<std::size_t>(options.mostPhotos));
    const auto directions = static_cast<std::size_t>(options.directions);
    return {all < 2 ? 0 : photos * directions, [=, &renderer, &camera, &options](std::size_t i) {
                const std::size_t photo = i / directions * all / photos;
                const render::DatasetPhoto& of = renderer.dataset().info().photos[photo];
                const double turn = 2 * std::numbers::pi * static_cast<double>(i % directions) /
                                    static_cast<double>(directions);
                const Rigid3 pose{(yawRotation(Radians(turn)) * bodyFromOptical()).normalized(),
                                  of.roomFromPhoto.translation};
                render::ViewOptions view;
                view.scene = render::SceneKind::None; // from its own place a photo is the truth
                view.sampling = options.sampling;
                view.threads = options.threads;
                return Subject{text(of.file, " ", std::lround(turn * 180 / std::numbers::pi), " deg"),
                               pose,
                               renderer.render(camera, pose, view).picture,
                               {},
                               photo};
            }};
}

/// One scene model's views, and all of their displacements.
class SceneMeasurement {
  public:
    explicit SceneMeasurement(render::SceneKind scene) { m_result.scene = scene; }

    void add(const Subject& subject, const render::Renderer& renderer, const CameraModel& camera,
             const MeasureOptions& options) {
        render::ViewOptions wanted;
        wanted.scene = m_result.scene;
        wanted.sampling = options.sampling;
        wanted.threads = options.threads;
        wanted.without = subject.without;
        wanted.wantsDepth = !subject.depth.empty();
        const render::View view = renderer.render(camera, subject.roomFromCamera, wanted);
        const std::vector<Displacement> matched =
            measure::matchedDisplacements(subject.picture, view.picture);
        ViewLikeness likeness;
        likeness.subject = subject.name;
        likeness.photo = view.report.file;
        likeness.offsetM = view.report.offsetM;
        likeness.psnrDb = photo::psnr(subject.picture, view.picture);
        likeness.ssim = photo::structuralSimilarity(subject.picture, view.picture);
        likeness.medianPx = measure::quantile(matched, 0.5);
        likeness.p95Px = measure::quantile(matched, 0.95);
        likeness.matches = matched.size();
        likeness.renderMs = view.report.renderMs;
        m_matched.insert(m_matched.end(), matched.begin(), matched.end());
        if (!subject.depth.empty()) {
            const Eigen::Vector3d photoAt =
                renderer.dataset().info().photos[view.report.photo].roomFromPhoto.translation;
            const std::vector<Displacement> exact = measure::exactDisplacements(
                camera, subject.roomFromCamera, photoAt, subject.depth, view.depth);
            likeness.exactMedianPx = measure::quantile(exact, 0.5);
            likeness.exactP95Px = measure::quantile(exact, 0.95);
            m_exact.insert(m_exact.end(), exact.begin(), exact.end());
        }
        m_result.views.push_back(std::move(likeness));
    }

    SceneLikeness result() {
        std::vector<double> ms;
        std::vector<double> medians;
        const auto count = static_cast<double>(m_result.views.size());
        m_result.worstPsnrDb = std::numeric_limits<double>::infinity();
        for (const ViewLikeness& view : m_result.views) {
            m_result.meanPsnrDb += view.psnrDb / count;
            m_result.meanSsim += view.ssim / count;
            if (view.medianPx) {
                medians.push_back(*view.medianPx);
            }
            m_result.worstPsnrDb = std::min(m_result.worstPsnrDb, view.psnrDb);
            ms.push_back(view.renderMs);
        }
        if (!medians.empty()) {
            m_result.medianPx =
                std::accumulate(medians.begin(), medians.end(), 0.0) / static_cast<double>(medians.size());
        }
        m_result.p95Px = measure::quantile(m_matched, 0.95);
        m_result.exactMedianPx = measure::quantile(m_exact, 0.5);
        m_result.exactP95Px = measure::quantile(m_exact, 0.95);
        m_result.medianRenderMs = median(ms);
        return std::move(m_result);
    }

  private:
    SceneLikeness m_result;
    std::vector<Displacement> m_matched;
    std::vector<Displacement> m_exact;
};

/// The 95th percentile that counts: the exact one where it is known. Infinity where nothing could be
/// compared.
double errorOf(const SceneLikeness& scene) {
    return scene.exactP95Px.value_or(scene.p95Px.value_or(std::numeric_limits<double>::infinity()));
}

void choose(MeasureReport& report) {
    for (const SceneLikeness& scene : report.scenes) {
        if (!report.choice && !scene.views.empty() && errorOf(scene) <= report.tolerancePx) {
            report.choice = scene.scene;
            report.reason = text("The scene model \"", std::string(name(scene.scene)),
                                 "\" is the cheapest whose 95th percentile, ", fixed(errorOf(scene), 2),
                                 " px, is within ", fixed(report.tolerancePx, 2), " px.");
        }
    }
    if (report.choice || report.scenes.empty()) {
        return;
    }
    const auto best = std::min_element(
        report.scenes.begin(), report.scenes.end(),
        [](const SceneLikeness& a, const SceneLikeness& b) { return errorOf(a) < errorOf(b); });
    if (!std::isfinite(errorOf(*best))) {
        report.reason = "Nothing could be compared: the pictures have too little in common with the views.";
        return;
    }
    report.reason = text("No scene model of this dataset is within ", fixed(report.tolerancePx, 2),
                         " px; the best, \"", std::string(name(best->scene)), "\", reaches ",
                         fixed(errorOf(*best), 2), " px in 95 of 100 places. Take photos closer together.");
}

} // namespace

std::vector<RobotPicture> readRobotPictures(const std::filesystem::path& csv) {
    std::vector<RobotPicture> pictures;
    for (const PhotoPosition& line : readPositions(csv)) {
        if (!line.roomFromPhoto) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not use the robot's pictures ", csv.string(), ": line ", line.line,
                             " states no rotation; give qw,qx,qy,qz of the optical frame."));
        }
        RobotPicture picture;
        picture.file = csv.parent_path() / line.file;
        picture.depthFile = line.depthFile.empty() ? "" : csv.parent_path() / line.depthFile;
        picture.roomFromCamera = {*line.roomFromPhoto, line.positionM};
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

MeasureReport measureDataset(const render::Renderer& renderer, const CameraModel& camera,
                             const MeasureOptions& options, ProgressSink& progress,
                             const std::stop_token& stop) {
    if (options.mostPhotos < 1 || options.directions < 1 || !(options.tolerancePx > 0)) {
        throw Error(
            ErrorKind::InvalidInput,
            "Could not measure: at least one photo, one direction and a tolerance above 0 are needed.");
    }
    const auto begin = std::chrono::steady_clock::now();
    const render::DatasetInfo& info = renderer.dataset().info();
    MeasureReport report;
    report.isLeaveOneOut = options.pictures.empty();
    report.photos = info.photos.size();
    report.sphereRadiusM = info.sphereRadiusM;
    report.tolerancePx = options.tolerancePx;
    const Subjects subjects =
        report.isLeaveOneOut ? leftOutSubjects(options, renderer, camera) : robotSubjects(options, camera);
    if (subjects.count == 0) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not measure: with a single photo there is nothing to compare it with.");
    }
    std::vector<SceneMeasurement> scenes;
    for (const render::SceneKind scene : render::scenesOf(info)) {
        scenes.emplace_back(scene);
    }
    for (std::size_t i = 0; i < subjects.count; ++i) {
        throwIfStopped(stop);
        const Subject subject = subjects.get(i);
        for (SceneMeasurement& scene : scenes) {
            scene.add(subject, renderer, camera, options);
        }
        progress.progress(static_cast<double>(i + 1) / static_cast<double>(subjects.count),
                          text("Comparing view ", i + 1, " of ", subjects.count));
    }
    for (SceneMeasurement& scene : scenes) {
        report.scenes.push_back(scene.result());
    }
    choose(report);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
}

} // namespace spherewalk::jobs
