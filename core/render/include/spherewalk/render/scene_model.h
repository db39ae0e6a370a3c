// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <string_view>

namespace spherewalk::render {

/// What an in-between position is computed with, cheap to exact.
enum class SceneKind {
    None,   ///< everything is infinitely far: the nearest photo is only turned
    Sphere, ///< everything lies on a sphere about the photo (the displaced camera of Chachula and Stefanczyk)
};

std::string_view name(SceneKind kind);

/// Errors: InvalidInput, listing the names.
SceneKind sceneKind(std::string_view name);

/// The largest share of the sphere's radius by which a camera may leave the photo; farther out it is treated
/// as if it stood there, since outside of the sphere rays miss it.
constexpr double kLargestDisplacement = 0.95;

/// The direction in which the photo sees what the camera's ray meets on a sphere about the photo.
/// Frames: one common frame. offset: camera minus photo position; ray: unit. Shape: not normalised, never
/// zero. Range: radius > 0; offsets beyond kLargestDisplacement * radius are shortened to it.
Eigen::Vector3d directionOnSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius);

/// How far the same ray goes to the same point of the sphere, from where the camera is taken to stand.
/// Units: those of the radius. Range: as for directionOnSphere(); the result is > 0.
double distanceOnSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius);

} // namespace spherewalk::render
