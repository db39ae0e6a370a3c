// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/scene_model.h"

#include "spherewalk/base/enum_names.h"

namespace spherewalk::render {

namespace {

constexpr EnumNames<SceneKind, 4> kNames{{{SceneKind::None, "none"},
                                          {SceneKind::Sphere, "sphere"},
                                          {SceneKind::Room, "room"},
                                          {SceneKind::Depth, "depth"}}};

} // namespace

std::string_view name(SceneKind kind) {
    return nameOf(kNames, kind);
}

SceneKind sceneKind(std::string_view name) {
    return valueOf(kNames, "The scene model", name);
}

DisplacedCamera::DisplacedCamera(const Eigen::Vector3d& offset, double radius) : m_from(offset / radius) {
    const double displacement = m_from.norm();
    if (displacement > kLargestDisplacement) {
        m_from *= kLargestDisplacement / displacement;
    }
    m_inside = 1 - m_from.squaredNorm();
}

Eigen::Vector3d directionOnSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius) {
    return DisplacedCamera(offset, radius).direction(ray);
}

} // namespace spherewalk::render
