// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/robot.h"

#include "ui/map/plan_view.h"
#include "ui/panorama/photo_pictures.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
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

void tintByError(QImage& picture, const render::PixelTrust& trust) {
    constexpr double kMostOpaque = 0.7;
    picture.convertTo(QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x) {
            const double share = std::min(1.0, trust.errorPx.at(x, y)[0] / kWorstShownPx);
            const QColor tint = PlanView::heatColour(share);
            const double opaque = kMostOpaque * std::min(1.0, 2 * share);
            const auto mix = [opaque](int below, int above) {
                return static_cast<int>(std::lround(below + opaque * (above - below)));
            };
            row[x] = qRgb(mix(qRed(row[x]), tint.red()), mix(qGreen(row[x]), tint.green()),
                          mix(qBlue(row[x]), tint.blue()));
        }
    }
}

ViewMaker::ViewMaker(render::Renderer renderer, const CameraIntrinsics& camera)
    : m_renderer(std::move(renderer)), m_camera(camera) {
}

render::ViewStream& ViewMaker::stream(std::size_t side) {
    while (m_streams.size() <= side) {
        m_streams.push_back(std::make_unique<render::ViewStream>(
            m_renderer, m_camera, render::StreamOptions{render::LatePolicy::Coarse, 0.4}));
    }
    return *m_streams[side];
}

std::vector<MadeView> ViewMaker::make(const ViewOrder& order) {
    std::vector<render::Overlay> overlays;
    if (order.ball) {
        overlays.push_back(jobs::ballOverlay(*order.ball, m_camera, order.roomFromCamera));
    }
    std::vector<MadeView> made;
    for (std::size_t side = 0; side < order.sides.size(); ++side) {
        render::ViewOptions options;
        options.scene = order.sides[side].scene;
        options.sampling = order.sides[side].sampling;
        options.overlays = overlays;
        options.wantsTrust = order.showsError;
        stream(side).next(order.roomFromCamera, order.timeS, options, m_view);
        made.push_back({qtImage(m_view.picture), m_view.report});
        if (order.showsError) {
            tintByError(made.back().picture, m_view.trust);
        }
    }
    return made;
}

} // namespace spherewalk::ui
