// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "contest.h"
#include "measurements.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/render/sensor.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace spherewalk::bench {

namespace {

constexpr const char* kDepth = "view.with_depth";
constexpr const char* kTrust = "view.with_trust";
constexpr const char* kOverlay = "view.with_overlay";
constexpr const char* kShadow = "view.with_overlay.shadow";
constexpr const char* kOtherLens = "view.with_overlay.other_lens";

/// A disc with a soft rim in the middle, half as high as the picture, nearer than anything in a room.
render::Overlay disc(const CameraIntrinsics& camera) {
    render::Overlay overlay;
    overlay.camera = camera;
    overlay.picture = RgbaImage(camera.width, camera.height);
    overlay.depth = DepthImage(camera.width, camera.height);
    const double radius = 0.35 * camera.height;
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            const double out =
                Eigen::Vector2d(x - 0.5 * camera.width, y - 0.5 * camera.height).norm() - radius;
            const double alpha = std::clamp(0.5 - out, 0.0, 1.0);
            const std::array<std::uint8_t, 4> pixel{200, 40, 40, static_cast<std::uint8_t>(255 * alpha)};
            std::copy(pixel.begin(), pixel.end(), overlay.picture.at(x, y));
            *overlay.depth.at(x, y) = alpha > 0 ? 0.5F : 0.0F;
        }
    }
    return overlay;
}

/// The same disc with a shadow that darkens all of the picture, by half in the middle.
render::Overlay discWithShadow(const CameraIntrinsics& camera) {
    render::Overlay overlay = disc(camera);
    overlay.shadow = Image<float, 1>(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            const double out = Eigen::Vector2d(x - 0.5 * camera.width, y - 0.5 * camera.height).norm();
            *overlay.shadow.at(x, y) = static_cast<float>(1 - 0.5 / (1 + out / (0.5 * camera.height)));
        }
    }
    return overlay;
}

struct NamedSensor {
    const char* name;
    render::SensorModel model;
};

/// Each effect of a sensor alone, and all of them together.
std::vector<NamedSensor> sensors() {
    std::vector<NamedSensor> sensors;
    const auto add = [&](const char* name) -> render::SensorModel& {
        sensors.push_back({name, {}});
        return sensors.back().model;
    };
    render::SensorModel all;
    add("view.with_sensor.exposure").exposure.gainDb = all.exposure.gainDb = 3;
    add("view.with_sensor.noise").noise = all.noise = {10000, 5};
    add("view.with_sensor.vignetting").vignetting = all.vignetting = {1, {-0.1, 0, 0}};
    add("view.with_sensor.defocus").defocus.diameterPx = all.defocus.diameterPx = 3;
    add("view.with_sensor.jpeg").jpegQuality = all.jpegQuality = 80;
    add("view.with_sensor.motion_blur").exposure.timeS = all.exposure.timeS = 0.01;
    add("view.with_sensor.rolling_shutter").shutter.lineDelayS = all.shutter.lineDelayS = 3e-5;
    add("view.with_sensor.all") = all;
    return sensors;
}

CameraIntrinsics wideWithDistortion() {
    CameraIntrinsics camera = CameraIntrinsics::pinhole(640, 480, Radians(Degrees(110)).value());
    camera.lens = LensModel::PlumbBob;
    camera.distortion = {-0.05, 0.01, 0, 0, 0};
    return camera;
}

class ExtrasBench {
  public:
    explicit ExtrasBench(const BenchPhoto& photo)
        : m_photo(photo),
          m_camera(standardCamera(90)),
          m_own{disc(m_camera.intrinsics())},
          m_shadowed{discWithShadow(m_camera.intrinsics())},
          m_other{disc(wideWithDistortion())} {}

    void fill(Contest& contest) {
        render::ViewOptions options;
        options.threads = 1;
        options.scene = m_photo.scene();
        add(contest, kViewAlone, options);
        options.wantsTrust = true;
        add(contest, kTrust, options);
        options.wantsTrust = false;
        for (const NamedSensor& sensor : sensors()) {
            addSensor(contest, sensor, options);
        }
        if (!m_photo.radiusM()) {
            return;
        }
        options.wantsDepth = true;
        add(contest, kDepth, options);
        options.wantsDepth = false;
        for (const auto& [name, object] :
             {std::pair(kOverlay, std::span(m_own)), {kShadow, m_shadowed}, {kOtherLens, m_other}}) {
            options.overlays = object;
            requireSeen(options);
            add(contest, name, options);
        }
    }

    std::vector<BenchRow> rows(const Contest& contest) const {
        std::vector<BenchRow> rows;
        for (const std::string& name : m_names) {
            if (name != kViewAlone) {
                BenchRow row;
                row.name = name;
                row.own = contest.of(name);
                row.peer = {kViewAlone, contest.of(kViewAlone).medianMs};
                row.view = ViewSetting{};
                rows.push_back(std::move(row));
            }
        }
        return rows;
    }

  private:
    void render(int run, const render::ViewOptions& options) {
        m_photo.renderer().render(m_camera, m_photo.roomFromCamera(lookingTo(7.3 * run, 0)), options, m_view);
    }

    void add(Contest& contest, const std::string& name, const render::ViewOptions& options) {
        m_names.push_back(name);
        contest.add(name, [this, options](int run) { render(run, options); });
    }

    /// Takes a frame while the camera turns by 60 degrees a second.
    void take(render::Sensor& sensor, int run, const render::ViewOptions& options) {
        constexpr double kDegreesPerS = 60;
        sensor.take(
            [&](const Rigid3& pose, double, bool, render::View& view) {
                m_photo.renderer().render(m_camera, m_photo.roomFromCamera(pose), options, view);
            },
            [run](double timeS) { return lookingTo(7.3 * run + kDegreesPerS * timeS, 0); }, 0,
            static_cast<std::uint64_t>(run), m_view);
    }

    void addSensor(Contest& contest, const NamedSensor& sensor, const render::ViewOptions& options) {
        const auto one = std::make_shared<render::Sensor>(sensor.model, m_camera, 1);
        render::Sensor two(sensor.model, m_camera, 2);
        take(*one, 0, options);
        const RgbImage picture = m_view.picture;
        render(0, options);
        const RgbImage alone = m_view.picture;
        take(two, 0, options);
        if (m_view.picture != picture || picture == alone) {
            throw Error(ErrorKind::Internal, text("The sensor of ", sensor.name,
                                                  " depends on threads, or does nothing; please report "
                                                  "this."));
        }
        m_names.emplace_back(sensor.name);
        contest.add(sensor.name, [this, one, options](int run) { take(*one, run, options); });
    }

    void requireSeen(const render::ViewOptions& options) {
        render(0, options);
        if (*m_view.overlaid.at(m_camera.width() / 2, m_camera.height() / 2) != 255) {
            throw Error(ErrorKind::Internal,
                        "An object half a metre before the camera was hidden by the room while overlays "
                        "were measured; please report this.");
        }
    }

    const BenchPhoto& m_photo;
    CameraModel m_camera;
    std::array<render::Overlay, 1> m_own;
    std::array<render::Overlay, 1> m_shadowed;
    std::array<render::Overlay, 1> m_other;
    render::View m_view;
    std::vector<std::string> m_names;
};

std::string sceneRowName(render::SceneKind scene, render::Sampling sampling) {
    return text("scene.", name(scene), ".", name(sampling));
}

void addViews(const BenchPhoto& photo, render::SceneKind scene, render::Sampling sampling,
              const CameraModel& camera, render::View& view, Contest& contest) {
    constexpr int kDirections = 120;
    render::ViewOptions options;
    options.threads = 1;
    options.scene = scene;
    options.sampling = sampling;
    const double asideM = std::min(0.5 * photo.freeM(), 0.5);
    const auto look = [&, options, asideM](int run) {
        const Rigid3 pose = lookingTo(360.0 / kDirections * run, 0, {0.8 * asideM, 0.6 * asideM, 0});
        photo.renderer().render(camera, photo.roomFromCamera(pose), options, view);
    };
    for (int run = 0; run < kDirections; ++run) { // what is read and decoded once does not count
        look(run);
    }
    contest.add(sceneRowName(scene, sampling), look);
}

} // namespace

std::vector<BenchRow> measureExtras(const BenchPhoto& photo, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop) {
    ExtrasBench extras(photo);
    Contest contest;
    extras.fill(contest);
    contest.run(rounds, std::clamp(rounds / 4, 1, 10), progress, "Timing depth, trust and overlays", stop);
    return extras.rows(contest);
}

std::vector<BenchRow> measureScenes(const BenchPhoto& photo, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop) {
    std::vector<BenchRow> rows;
    const std::vector<render::SceneKind> scenes = scenesOf(photo.dataset().info());
    if (!photo.radiusM() || std::none_of(scenes.begin(), scenes.end(), render::hasSurfaces)) {
        return rows;
    }
    const CameraModel camera = standardCamera(57);
    for (const render::Sampling sampling : {render::Sampling::Bilinear, render::Sampling::Footprint}) {
        Contest contest;
        render::View view;
        for (const render::SceneKind scene : scenes) {
            if (scene != render::SceneKind::None) {
                addViews(photo, scene, sampling, camera, view, contest);
            }
        }
        contest.run(rounds, std::clamp(rounds / 4, 1, 10), progress, "Timing scene models", stop);
        const Measured sphere = contest.of(sceneRowName(render::SceneKind::Sphere, sampling));
        for (const render::SceneKind scene : scenes) {
            if (render::hasSurfaces(scene)) {
                BenchRow row;
                row.name = sceneRowName(scene, sampling);
                row.own = contest.of(row.name);
                row.peer = {kSphereView, sphere.medianMs};
                row.view = ViewSetting{57, 0};
                rows.push_back(std::move(row));
            }
        }
    }
    return rows;
}

} // namespace spherewalk::bench
