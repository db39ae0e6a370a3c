// SPDX-License-Identifier: GPL-3.0-or-later
#include "extras_bench.h"

#include "contest.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

namespace spherewalk::measure {

namespace {

constexpr const char* kDepth = "view.with_depth";
constexpr const char* kTrust = "view.with_trust";
constexpr const char* kOverlay = "view.with_overlay";
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

CameraIntrinsics wideWithDistortion() {
    CameraIntrinsics camera = CameraIntrinsics::pinhole(640, 480, Radians(Degrees(110)).value());
    camera.lens = LensModel::PlumbBob;
    camera.distortion = {-0.05, 0.01, 0, 0, 0};
    return camera;
}

class ExtrasBench {
  public:
    explicit ExtrasBench(const Subject& subject)
        : m_subject(subject),
          m_camera(standardCamera(90)),
          m_own{disc(m_camera.intrinsics())},
          m_other{disc(wideWithDistortion())} {}

    void fill(Contest& contest) {
        render::ViewOptions options;
        options.threads = 1;
        options.scene = m_subject.scene();
        add(contest, kViewAlone, options);
        options.wantsTrust = true;
        add(contest, kTrust, options);
        if (!m_subject.radiusM()) {
            return;
        }
        options.wantsTrust = false;
        options.wantsDepth = true;
        add(contest, kDepth, options);
        options.wantsDepth = false;
        for (const auto& [name, object] : {std::pair(kOverlay, std::span(m_own)), {kOtherLens, m_other}}) {
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
        m_subject.renderer().render(m_camera, m_subject.roomFromCamera(lookingTo(7.3 * run, 0)), options,
                                    m_view);
    }

    void add(Contest& contest, const std::string& name, const render::ViewOptions& options) {
        m_names.push_back(name);
        contest.add(name, [this, options](int run) { render(run, options); });
    }

    void requireSeen(const render::ViewOptions& options) {
        render(0, options);
        if (*m_view.overlaid.at(m_camera.width() / 2, m_camera.height() / 2) != 255) {
            throw Error(ErrorKind::Internal,
                        "An object half a metre before the camera was hidden by the room while overlays "
                        "were measured; please report this.");
        }
    }

    const Subject& m_subject;
    CameraModel m_camera;
    std::array<render::Overlay, 1> m_own;
    std::array<render::Overlay, 1> m_other;
    render::View m_view;
    std::vector<std::string> m_names;
};

} // namespace

std::vector<BenchRow> measureExtras(const Subject& subject, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop) {
    ExtrasBench extras(subject);
    Contest contest;
    extras.fill(contest);
    contest.run(rounds, std::clamp(rounds / 4, 1, 10), progress, "Timing depth, trust and overlays", stop);
    return extras.rows(contest);
}

} // namespace spherewalk::measure
