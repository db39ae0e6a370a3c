// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/scene_model.h"

#include "enum_names.h"

#include <cmath>

namespace spherewalk::render {

namespace {

constexpr EnumNames<SceneKind, 2> kNames{{{SceneKind::None, "none"}, {SceneKind::Sphere, "sphere"}}};

} // namespace

std::string_view name(SceneKind kind) {
    return nameOf(kNames, kind);
}

SceneKind sceneKind(std::string_view name) {
    return valueOf(kNames, "The scene model", name);
}

namespace {

/// A camera in a sphere of radius 1, and how far one of its rays goes.
struct OnUnitSphere {
    Eigen::Vector3d from;
    double distance;
};

OnUnitSphere onUnitSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius) {
    // In units of the radius, so that neither tiny nor huge rooms lose digits.
    Eigen::Vector3d from = offset / radius;
    const double displacement = from.norm();
    if (displacement > kLargestDisplacement) {
        from *= kLargestDisplacement / displacement;
    }
    const double along = from.dot(ray);
    const double inside = 1 - from.squaredNorm(); // > 0
    const double root = std::sqrt(along * along + inside);
    // The positive root of t^2 + 2 along t - inside = 0, in the form that does not cancel.
    return {from, along > 0 ? inside / (along + root) : root - along};
}

} // namespace

Eigen::Vector3d directionOnSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius) {
    const OnUnitSphere met = onUnitSphere(offset, ray, radius);
    return met.from + met.distance * ray;
}

double distanceOnSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius) {
    return radius * onUnitSphere(offset, ray, radius).distance;
}

} // namespace spherewalk::render
