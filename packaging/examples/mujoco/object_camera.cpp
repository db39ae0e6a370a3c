// SPDX-License-Identifier: Apache-2.0
#include "object_camera.h"

#include "room_world.h"

#include "spherewalk/render/colour_correction.h"

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
constexpr int kLights = 128; ///< That a soft shadow is made of.
constexpr float kSameSurface = 0.99F;

bool isShown(int group, bool wantsRoom, bool wantsGround) {
    return group == kRoomGroup ? wantsRoom : group == kGroundGroup ? wantsGround : !wantsRoom && !wantsGround;
}

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
    m_scene.flags[mjRND_SHADOW] = 0; // the floor is in the photos: see shadow()
    m_scene.flags[mjRND_SKYBOX] = 0;
}

ObjectRenderer::~ObjectRenderer() {
    mjr_freeContext(&m_context);
    mjv_freeScene(&m_scene);
}

void ObjectRenderer::light(const spherewalk::render::LightProbe& probe) {
    m_light = dominantLight(spherewalk::render::lightHarmonics(probe.radiance));
    m_lights = spherewalk::render::directionalLights(probe.radiance, kLights);
}

/// MuJoCo multiplies colours as they are stored, so light is encoded first.
void ObjectRenderer::putLight() {
    if (m_lights.empty()) {
        return;
    }
    const auto stored = [](const Eigen::Vector3d& light) {
        return Eigen::Vector3f(light.cwiseMax(0).unaryExpr(&spherewalk::render::storedValue).cast<float>());
    };
    const Eigen::Vector3f ambient = stored(m_light.ambient);
    const Eigen::Vector3f facing = stored(m_light.ambient + m_light.irradiance / std::numbers::pi);
    mjvLight lamp{};
    lamp.directional = 1;
    lamp.attenuation[0] = 1;
    lamp.cutoff = 45; // OpenGL wants one
    for (int i = 0; i < 3; ++i) {
        lamp.dir[i] = -static_cast<float>(m_light.towards[i]);
        lamp.ambient[i] = ambient[i];
        lamp.diffuse[i] = facing[i] - ambient[i];
    }
    m_scene.nlight = 1;
    m_scene.lights[0] = lamp;
}

/// What the ball leaves of the light on the ground that a pixel shows.
spherewalk::Image<float, 1> ObjectRenderer::shadow(const DepthImage& ground, const DepthImage& room) const {
    const Eigen::Vector3d ball = m_simulation.roomFromBody("ball").translation;
    const double radius =
        m_simulation.model().geom_size[3 * mj_name2id(&m_simulation.model(), mjOBJ_GEOM, "ball")];
    const spherewalk::Rigid3 pose = m_simulation.roomFromCamera();
    const CameraModel camera(m_camera);
    spherewalk::Image<float, 1> result(ground.width(), ground.height());
    std::ranges::fill(result.values(), 1.0F);
    for (int y = 0; y < ground.height(); ++y) {
        for (int x = 0; x < ground.width(); ++x) {
            const float z = *ground.at(x, y);
            if (!std::isfinite(z) || *room.at(x, y) < kSameSurface * z) {
                continue; // something stands in front of the ground
            }
            const Eigen::Vector3d ray = *camera.ray({x, y});
            const Eigen::Vector3d to = ball - pose * Eigen::Vector3d(ray * (z / ray.z()));
            if (to.norm() > 8 * radius) { // it hides less than 2 % of the light
                continue;
            }
            *result.at(x, y) = spherewalk::render::lightLeft(
                m_lights, Eigen::Vector3d::UnitZ(), [&](const Eigen::Vector3d& towards) {
                    const double along = to.dot(towards);
                    return along > 0 && (to - along * towards).squaredNorm() < radius * radius;
                });
        }
    }
    return result;
}

ObjectRenderer::Rendered ObjectRenderer::rendered(Part part) {
    mjvOption options;
    mjv_defaultOption(&options);
    for (int group = 0; group < mjNGROUP; ++group) {
        options.geomgroup[group] =
            static_cast<mjtByte>(isShown(group, part == Part::Room, part != Part::Objects));
    }
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = mj_name2id(&m_simulation.model(), mjOBJ_CAMERA, "eyes");
    mjv_updateScene(&m_simulation.model(), &m_simulation.data(), &options, nullptr, &camera, mjCAT_ALL,
                    &m_scene);
    putLight();

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
    const Rendered objects = rendered(Part::Objects);
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
    const bool castsShadow = !m_lights.empty();
    const DepthImage room = wantsRoomDepth || castsShadow ? rendered(Part::Room).depth : DepthImage();
    if (castsShadow) {
        overlay.shadow = shadow(rendered(Part::Ground).depth, room);
    }
    if (wantsRoomDepth) {
        overlay.roomDepth = room;
    }
    return overlay;
}

} // namespace mujoco_example
