// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/robot.h"

#include "ui/look/core_words.h"
#include "ui/map/plan_view.h"
#include "ui/panorama/photo_pictures.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace spherewalk::ui {

Rigid3 roomFromOptical(const RobotPlace& robot, const CameraMount& mount) {
    return {rotation({robot.yaw, mount.down, Radians(0)}) * bodyFromOptical(),
            {robot.pInRoom.x(), robot.pInRoom.y(), mount.heightM}};
}

Drive::Drive(Polygon outline, std::vector<Polygon> obstacles)
    : m_outline(std::move(outline)), m_obstacles(std::move(obstacles)) {
}

bool Drive::isFloor(const Eigen::Vector2d& point) const {
    return (m_outline.empty() || contains(m_outline, point)) &&
           std::none_of(m_obstacles.begin(), m_obstacles.end(),
                        [&](const Polygon& obstacle) { return contains(obstacle, point); });
}

RobotPlace Drive::after(const RobotPlace& robot, const DriveWish& wish, double seconds) const {
    RobotPlace next = robot;
    next.yaw = wrapped(robot.yaw + Radians(kTurnPerSecond) * (wish.turnLeft * seconds));
    const double way = kSpeedMps * seconds;
    const Eigen::Vector2d ahead(cos(robot.yaw), sin(robot.yaw));
    const Eigen::Vector2d beside(-ahead.y(), ahead.x());
    const Eigen::Vector2d step = way * (wish.forward * ahead + wish.left * beside);
    for (const Eigen::Vector2d& tried : std::array<Eigen::Vector2d, 3>{step, {step.x(), 0}, {0, step.y()}}) {
        // A robot that was put where no floor is may leave.
        if (isFloor(robot.pInRoom + tried) || !isFloor(robot.pInRoom)) {
            next.pInRoom = robot.pInRoom + tried;
            break;
        }
    }
    return next;
}

namespace {

/// What an error makes of a pixel: a share of its own colour, in 256ths, and something of the tint.
struct Tint {
    int kept = 256;
    std::array<int, 3> added{};
};

constexpr int kTints = 256; ///< From no error to kWorstShownPx.

/// The tints, made once: a picture has a million pixels.
const std::array<Tint, kTints>& tints() {
    static const std::array<Tint, kTints> all = [] {
        constexpr double kMostOpaque = 0.7;
        std::array<Tint, kTints> made;
        for (int i = 0; i < kTints; ++i) {
            const double share = static_cast<double>(i) / (kTints - 1);
            const double opaque = kMostOpaque * std::min(1.0, 2 * share);
            const QColor colour = PlanView::heatColour(share);
            const auto part = [opaque](int channel) {
                return static_cast<int>(std::lround(256 * opaque * channel));
            };
            made[static_cast<std::size_t>(i)] = {
                static_cast<int>(std::lround(256 * (1 - opaque))),
                {part(colour.red()), part(colour.green()), part(colour.blue())}};
        }
        return made;
    }();
    return all;
}

} // namespace

void tintByError(QImage& picture, const render::PixelTrust& trust) {
    constexpr float kTintsAPx = static_cast<float>((kTints - 1) / kWorstShownPx);
    const std::array<Tint, kTints>& all = tints();
    picture.convertTo(QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        const std::span<const float> errors = trust.errorPx.row(y);
        for (std::size_t x = 0; x < errors.size(); ++x) {
            const float step = std::min(static_cast<float>(kTints - 1), kTintsAPx * errors[x]);
            const Tint& tint = all[static_cast<std::size_t>(step)];
            const auto mix = [&](int below, std::size_t channel) {
                return (tint.kept * below + tint.added[channel]) >> 8;
            };
            row[x] = qRgb(mix(qRed(row[x]), 0), mix(qGreen(row[x]), 1), mix(qBlue(row[x]), 2));
        }
    }
}

ViewMaker::ViewMaker(render::Renderer renderer, const CameraIntrinsics& camera)
    : m_renderer(std::move(renderer)), m_camera(camera) {
}

CameraIntrinsics scaled(const CameraIntrinsics& camera, double share) {
    CameraIntrinsics result = camera;
    result.width = std::max(1, static_cast<int>(std::lround(share * camera.width)));
    result.height = std::max(1, static_cast<int>(std::lround(share * camera.height)));
    const double x = static_cast<double>(result.width) / camera.width;
    const double y = static_cast<double>(result.height) / camera.height;
    result.fx *= x;
    result.fy *= y;
    result.cx = (camera.cx + 0.5) * x - 0.5; // the corner of pixel (0, 0) is at (-0.5, -0.5)
    result.cy = (camera.cy + 0.5) * y - 0.5;
    return result;
}

ViewMaker::Eye& ViewMaker::eye(std::size_t side, const CameraIntrinsics& camera, double share) {
    if (m_eyes.size() <= side) {
        m_eyes.resize(side + 1);
    }
    std::unique_ptr<Eye>& eye = m_eyes[side][share < 1 ? 1 : 0];
    if (!eye || !(eye->intrinsics == camera) || eye->share != share) {
        const CameraModel model(scaled(camera, share));
        const render::StreamOptions options{.late = render::LatePolicy::Coarse, .prefetchSeconds = 0.4};
        eye =
            std::make_unique<Eye>(Eye{camera, share, model, render::ViewStream(m_renderer, model, options)});
    }
    return *eye;
}

/// Reads the picture once. One that cannot be read is black, and its caption says why.
const MadeView& ViewMaker::ownPicture(const jobs::RobotPicture& own) {
    if (m_own.picture.isNull() || m_ownFile != own.file) {
        m_ownFile = own.file;
        try {
            m_own.picture = qtImage(jobs::readRobotPicture(own, CameraModel(m_camera)));
            m_own.caption = QString::fromStdString(own.file.filename().string());
        } catch (const Error& error) {
            m_own.picture = QImage(m_camera.width, m_camera.height, QImage::Format_RGB32);
            m_own.picture.fill(Qt::black);
            m_own.caption = coreWords(error.sentence());
        }
    }
    return m_own;
}

std::vector<MadeView> ViewMaker::make(const ViewOrder& order) {
    std::vector<MadeView> made;
    for (std::size_t side = 0; side < order.sides.size(); ++side) {
        const ViewSide& wanted = order.sides[side];
        Eye& own = eye(side, wanted.camera.value_or(m_camera), order.share);
        std::vector<render::Overlay> overlays;
        if (order.object) {
            overlays.push_back(order.object->overlay(own.camera, order.roomFromCamera));
        }
        render::ViewOptions options;
        options.scene = wanted.scene;
        options.sampling = wanted.sampling;
        options.overlays = overlays;
        options.wantsTrust = order.showsError;
        own.stream.next(order.roomFromCamera, order.timeS, options, m_view);
        m_view.report.parallaxPx /= order.share; // in pixels of the robot's camera
        m_view.report.blurPx /= order.share;
        made.push_back({qtImage(m_view.picture), m_view.report, {}, order.share});
        if (order.showsError) {
            for (float& errorPx : m_view.trust.errorPx.values()) {
                errorPx /= static_cast<float>(order.share);
            }
            tintByError(made.back().picture, m_view.trust);
        }
    }
    if (order.own) {
        made.push_back(ownPicture(*order.own));
    }
    return made;
}

} // namespace spherewalk::ui
