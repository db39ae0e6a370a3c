// SPDX-License-Identifier: Apache-2.0
#include "object_camera.h"

#include "room_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mujoco_example {

using spherewalk::CameraIntrinsics;
using spherewalk::CameraModel;
using spherewalk::DepthImage;
using spherewalk::RgbImage;

namespace {

constexpr int kMostGeoms = 1000;

/// Greatest |x / z| and |y / z| of the rays of the picture's border; objects farther off the axis are not
/// rendered.
Eigen::Vector2d border(const CameraModel& camera) {
    constexpr double kMost = 5.67; // 80 degrees
    Eigen::Vector2d greatest(0, 0);
    const auto look = [&](double x, double y) {
        const auto ray = camera.ray({x, y});
        const bool isAhead = ray && ray->z() > 0;
        const Eigen::Vector2d slope =
            isAhead ? Eigen::Vector2d(ray->head<2>().cwiseAbs() / ray->z()) : Eigen::Vector2d(kMost, kMost);
        greatest = greatest.cwiseMax(slope.cwiseMin(kMost));
    };
    for (double x = -0.5; x < camera.width(); ++x) {
        look(x, -0.5);
        look(x, camera.height() - 0.5);
    }
    for (double y = -0.5; y < camera.height(); ++y) {
        look(-0.5, y);
        look(camera.width() - 0.5, y);
    }
    return greatest;
}

} // namespace

CameraIntrinsics objectCamera(const CameraModel& camera) {
    const CameraIntrinsics& own = camera.intrinsics();
    const bool isCentred = own.cx == (own.width - 1) / 2.0 && own.cy == (own.height - 1) / 2.0;
    if (own.lens == spherewalk::LensModel::Pinhole && own.fx == own.fy && isCentred) {
        return own;
    }
    const Eigen::Vector2d slope = border(camera);
    const double aspect = static_cast<double>(own.width) / own.height;
    return CameraIntrinsics::pinhole(own.width, own.height,
                                     2 * std::atan(std::max(slope.x(), slope.y() * aspect)));
}

struct ObjectRenderer::Rendered {
    RgbImage picture;
    DepthImage depth; ///< z, metres; +infinity where nothing is
};

ObjectRenderer::ObjectRenderer(Simulation& simulation, const CameraIntrinsics& camera)
    : m_simulation(simulation), m_camera(camera) {
    mjv_defaultScene(&m_scene);
    mjr_defaultContext(&m_context);
    mjv_makeScene(&simulation.model(), &m_scene, kMostGeoms);
    mjr_makeContext(&simulation.model(), &m_context, mjFONTSCALE_50);
    mjr_setBuffer(mjFB_OFFSCREEN, &m_context);
    m_scene.flags[mjRND_SHADOW] = 0; // there is no floor that it could fall on
    m_scene.flags[mjRND_SKYBOX] = 0;
}

ObjectRenderer::~ObjectRenderer() {
    mjr_freeContext(&m_context);
    mjv_freeScene(&m_scene);
}

ObjectRenderer::Rendered ObjectRenderer::rendered(bool isRoom) {
    mjvOption options;
    mjv_defaultOption(&options);
    for (int group = 0; group < mjNGROUP; ++group) {
        options.geomgroup[group] = static_cast<mjtByte>((group == kRoomGroup) == isRoom);
    }
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = mj_name2id(&m_simulation.model(), mjOBJ_CAMERA, "eyes");
    mjv_updateScene(&m_simulation.model(), &m_simulation.data(), &options, nullptr, &camera, mjCAT_ALL,
                    &m_scene);

    const auto [width, height] = std::pair(m_camera.width, m_camera.height);
    const mjrRect viewport{0, 0, width, height};
    RgbImage upsideDown(width, height);
    DepthImage buffer(width, height);
    mjr_render(viewport, &m_scene, &m_context);
    mjr_readPixels(upsideDown.values().data(), buffer.values().data(), viewport, &m_context);

    Rendered result{RgbImage(width, height), DepthImage(width, height)};
    const double near = m_scene.camera[0].frustum_near;
    const double far = m_scene.camera[0].frustum_far;
    const auto metres = [&](float depth) { // of what OpenGL keeps: 0 at the near plane, 1 at the far one
        return depth >= 1 ? std::numeric_limits<float>::infinity()
                          : static_cast<float>(near * far / (far - depth * (far - near)));
    };
    for (int y = 0; y < height; ++y) { // OpenGL's first row is the lowest
        std::ranges::copy(upsideDown.row(height - 1 - y), result.picture.row(y).begin());
        std::ranges::transform(buffer.row(height - 1 - y), result.depth.row(y).begin(), metres);
    }
    return result;
}

spherewalk::render::Overlay ObjectRenderer::overlay(bool wantsRoomDepth) {
    const Rendered objects = rendered(false);
    spherewalk::render::Overlay overlay;
    overlay.camera = m_camera;
    overlay.depth = objects.depth;
    overlay.picture = spherewalk::RgbaImage(m_camera.width, m_camera.height);
    for (int y = 0; y < m_camera.height; ++y) {
        for (int x = 0; x < m_camera.width; ++x) {
            std::copy_n(objects.picture.at(x, y), 3, overlay.picture.at(x, y));
            overlay.picture.at(x, y)[3] = std::isfinite(*objects.depth.at(x, y)) ? 255 : 0;
        }
    }
    if (wantsRoomDepth) {
        overlay.roomDepth = rendered(true).depth;
    }
    return overlay;
}

} // namespace mujoco_example
