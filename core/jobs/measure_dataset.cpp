// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measure_dataset.h"

#include "csv.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/median.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/measure/displacement.h"
#include "spherewalk/measure/likeness.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <limits>
#include <numbers>

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

std::vector<render::SceneKind> scenesOf(const render::DatasetInfo& info) {
    std::vector<render::SceneKind> scenes{render::SceneKind::None};
    if (info.sphereRadiusM) {
        scenes.push_back(render::SceneKind::Sphere);
    }
    if (info.roomShape) {
        scenes.push_back(render::SceneKind::Room);
    }
    if (std::any_of(info.photos.begin(), info.photos.end(),
                    [](const render::DatasetPhoto& photo) { return !photo.depth.empty(); })) {
        scenes.push_back(render::SceneKind::Depth);
    }
    return scenes;
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
        likeness.ssim = measure::structuralSimilarity(subject.picture, view.picture);
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
        const auto count = static_cast<double>(m_result.views.size());
        m_result.worstPsnrDb = std::numeric_limits<double>::infinity();
        for (const ViewLikeness& view : m_result.views) {
            m_result.meanPsnrDb += view.psnrDb / count;
            m_result.meanSsim += view.ssim / count;
            m_result.medianPx += view.medianPx / count;
            m_result.worstPsnrDb = std::min(m_result.worstPsnrDb, view.psnrDb);
            ms.push_back(view.renderMs);
        }
        m_result.p95Px = measure::quantile(m_matched, 0.95);
        if (!m_exact.empty()) {
            m_result.exactMedianPx = measure::quantile(m_exact, 0.5);
            m_result.exactP95Px = measure::quantile(m_exact, 0.95);
        }
        m_result.medianRenderMs = median(ms);
        return std::move(m_result);
    }

  private:
    SceneLikeness m_result;
    std::vector<Displacement> m_matched;
    std::vector<Displacement> m_exact;
};

/// The 95th percentile that counts: the exact one where it is known.
double errorOf(const SceneLikeness& scene) {
    return scene.exactP95Px.value_or(scene.p95Px);
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
    report.reason = text("No scene model of this dataset is within ", fixed(report.tolerancePx, 2),
                         " px; the best, \"", std::string(name(best->scene)), "\", reaches ",
                         fixed(errorOf(*best), 2), " px in 95 of 100 places. Take photos closer together.");
}

} // namespace

std::vector<RobotPicture> readRobotPictures(const std::filesystem::path& csv) {
    const std::string source = csv.string();
    const std::vector<CsvLine> lines = parseCsv(readTextFile(csv, 16 << 20), source);
    const auto refuse = [&](int line, const std::string& what) -> Error {
        return {ErrorKind::InvalidInput,
                text("Could not read the robot's pictures ", source, ": line ", line, ": ", what, ".")};
    };
    constexpr std::array<std::string_view, 8> kColumns{"file", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"};
    std::vector<RobotPicture> pictures;
    std::array<std::size_t, 8> at{};
    std::optional<std::size_t> depth;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::vector<std::string>& fields = lines[i].fields;
        if (i == 0) {
            for (std::size_t k = 0; k < kColumns.size(); ++k) {
                const auto found = std::find(fields.begin(), fields.end(), kColumns[k]);
                if (found == fields.end()) {
                    throw refuse(1, text("the column ", std::string(kColumns[k]), " is missing"));
                }
                at[k] = static_cast<std::size_t>(found - fields.begin());
            }
            const auto found = std::find(fields.begin(), fields.end(), "depth");
            if (found != fields.end()) {
                depth = static_cast<std::size_t>(found - fields.begin());
            }
            continue;
        }
        std::array<double, 8> values{};
        for (std::size_t k = 1; k < kColumns.size(); ++k) {
            const auto value = at[k] < fields.size() ? parseNumber(fields[at[k]]) : std::nullopt;
            if (!value) {
                throw refuse(lines[i].number, text(std::string(kColumns[k]), " is not a number"));
            }
            values[k] = *value;
        }
        RobotPicture picture;
        picture.file = csv.parent_path() / fields[at[0]];
        if (depth && *depth < fields.size() && !fields[*depth].empty()) {
            picture.depthFile = csv.parent_path() / fields[*depth];
        }
        picture.roomFromCamera = {checkedQuaternion(values[7], values[4], values[5], values[6],
                                                    text("line ", lines[i].number, " of ", source)),
                                  {values[1], values[2], values[3]}};
        pictures.push_back(std::move(picture));
    }
    if (pictures.empty()) {
        throw refuse(1, "it lists no pictures");
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
    for (const render::SceneKind scene : scenesOf(info)) {
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
