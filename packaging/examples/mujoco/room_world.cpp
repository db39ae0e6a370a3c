// SPDX-License-Identifier: Apache-2.0
#include "room_world.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/angle.h"

#include <cmath>
#include <numbers>

namespace mujoco_example {

using spherewalk::Polygon;
using spherewalk::text;

namespace {

constexpr double kHalfThicknessM = 0.05;
constexpr double kHalfTableM = 0.35;
constexpr double kUsualCeilingM = 2.5;
constexpr double kTiltRad = 0.25; ///< of the camera, down

/// A box along each edge, on the polygon's outer side (or its inner one), as high as the room.
std::string wallsAlong(const Polygon& polygon, bool isOutside, double heightM) {
    const double turn = (spherewalk::signedArea(polygon) > 0) == isOutside ? 1 : -1;
    std::string walls;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d& begin = polygon[i];
        const Eigen::Vector2d along = polygon[(i + 1) % polygon.size()] - begin;
        const Eigen::Vector2d aside = Eigen::Vector2d(along.y(), -along.x()).normalized() * turn;
        const Eigen::Vector2d middle = begin + along / 2 + aside * kHalfThicknessM;
        walls += text("    <geom class=\"room\" type=\"box\" pos=\"", middle.x(), " ", middle.y(), " ",
                      heightM / 2, "\" euler=\"0 0 ", std::atan2(along.y(), along.x()), "\" size=\"",
                      along.norm() / 2, " ", kHalfThicknessM, " ", heightM / 2, "\"/>\n");
    }
    return walls;
}

/// Two driven wheels, two balls that slide, and a mast with the camera, which looks ahead and a little down.
std::string robot(const WorldOptions& options, double fovyDeg) {
    const std::string wheel =
        "type=\"cylinder\" size=\"0.08 0.02\" euler=\"1.5707963267948966 0 0\" mass=\"0.5\"";
    const auto hinge = [&](const char* name, double y) {
        return text("      <body pos=\"0 ", y, " 0.08\"><joint name=\"", name,
                    "\" type=\"hinge\" axis=\"0 1 0\" armature=\"0.02\"/><geom ", wheel, "/></body>\n");
    };
    const auto slider = [](double x) {
        return text("      <geom type=\"sphere\" size=\"0.04\" pos=\"", x,
                    " 0 0.042\" mass=\"0.2\" condim=\"1\" priority=\"1\"/>\n");
    };
    return text(
        "    <body name=\"robot\" pos=\"", options.startM.x(), " ", options.startM.y(), " 0\" euler=\"0 0 ",
        options.startYawRad, "\">\n      <freejoint name=\"robot\"/>\n",
        "      <geom name=\"bumper\" type=\"cylinder\" size=\"0.2 0.04\" pos=\"0 0 0.13\" mass=\"8\"/>\n",
        "      <geom type=\"capsule\" fromto=\"0 0 0.17 0 0 ", options.lensHeightM,
        "\" size=\"0.015\" mass=\"0.1\" contype=\"0\" conaffinity=\"0\"/>\n", hinge("left", 0.17),
        hinge("right", -0.17), slider(0.14), slider(-0.14), "      <camera name=\"eyes\" pos=\"0.1 0 ",
        options.lensHeightM, "\" xyaxes=\"0 -1 0 ", std::sin(kTiltRad), " 0 ", std::cos(kTiltRad),
        "\" fovy=\"", fovyDeg, "\"/>\n    </body>\n");
}

/// A plate that holds the ball where photos show a table.
std::string table(const WorldOptions& options) {
    return options.tableM > 0
               ? text("    <geom class=\"room\" group=\"", kGroundGroup, "\" type=\"box\" pos=\"",
                      options.ballM.x(), " ", options.ballM.y(), " ", options.tableM - kHalfThicknessM,
                      "\" size=\"", kHalfTableM, " ", kHalfTableM, " ", kHalfThicknessM, "\"/>\n")
               : "";
}

std::string ball(const WorldOptions& options) {
    return text(
        "    <body name=\"ball\" pos=\"", options.ballM.x(), " ", options.ballM.y(), " ", options.ballM.z(),
        "\">\n      <freejoint/>\n      <geom name=\"ball\" type=\"sphere\" size=\"", options.ballRadiusM,
        "\" mass=\"0.1\" material=\"ball\" condim=\"6\" friction=\"1 0.005 0.001\"/>\n    </body>\n");
}

} // namespace

std::string roomWorld(const spherewalk::render::DatasetInfo& dataset,
                      const spherewalk::CameraIntrinsics& eyes, const WorldOptions& options) {
    if (dataset.outline.size() < 3) {
        throw spherewalk::Error(
            spherewalk::ErrorKind::InvalidInput,
            "The dataset has no outline of the room, so there are no walls to drive among.");
    }
    const double ceiling = dataset.ceilingM > 0 ? dataset.ceilingM : kUsualCeilingM;
    const double fovyDeg =
        spherewalk::Degrees(spherewalk::Radians(2 * std::atan2(eyes.height / 2.0, eyes.fy))).value();
    std::string walls = wallsAlong(dataset.outline, true, ceiling);
    for (const Polygon& obstacle : dataset.obstacles) {
        const bool isTable = options.tableM > 0 && spherewalk::contains(obstacle, options.ballM.head<2>());
        walls += wallsAlong(obstacle, false, isTable ? options.tableM : ceiling);
    }
    // No multisampling: a pixel's depth is that of one place. znear and zfar are shares of the extent, here
    // metres.
    return text(
        "<mujoco model=\"room\">\n  <compiler angle=\"radian\"/>\n  <option timestep=\"0.002\"/>\n",
        "  <statistic extent=\"1\"/>\n  <visual>\n    <map znear=\"0.05\" zfar=\"50\"/>\n",
        "    <quality offsamples=\"0\"/>\n    <global offwidth=\"", eyes.width, "\" offheight=\"",
        eyes.height, "\"/>\n    <headlight ambient=\"0.3 0.3 0.3\" diffuse=\"0.3 0.3 0.3\"/>\n  </visual>\n",
        "  <default>\n    <default class=\"room\"><geom group=\"", kRoomGroup,
        "\"/></default>\n  </default>\n",
        "  <asset>\n    <texture name=\"stripes\" type=\"2d\" builtin=\"checker\" rgb1=\"0.85 0.15 0.1\" ",
        "rgb2=\"0.95 0.9 0.8\" width=\"256\" height=\"256\"/>\n",
        "    <material name=\"ball\" texture=\"stripes\" texrepeat=\"4 2\"/>\n  </asset>\n  <worldbody>\n",
        "    <light directional=\"true\" pos=\"0 0 3\" dir=\"-0.3 -0.2 -1\" diffuse=\"0.6 0.6 0.6\"/>\n",
        "    <geom class=\"room\" group=\"", kGroundGroup, "\" type=\"plane\" size=\"0 0 1\"/>\n", walls,
        table(options), robot(options, fovyDeg), ball(options), "  </worldbody>\n  <actuator>\n",
        "    <velocity joint=\"left\" kv=\"1\"/>\n    <velocity joint=\"right\" kv=\"1\"/>\n  </actuator>\n",
        "</mujoco>\n");
}

} // namespace mujoco_example
