// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <string_view>

namespace spherewalk::render {

/// What an in-between position is computed with, cheap to exact.
enum class SceneKind {
    None,   ///< everything is infinitely far: the nearest photo is only turned
    Sphere, ///< everything lies on a sphere about the photo (the displaced camera of Chachula and Stefanczyk)
    Room,   ///< there are walls, a floor and a ceiling, and nothing else
    Depth,  ///< how far away each of the photo's pixels is was measured
};

/// Whether a model of this kind gives each photo a surface, so that things hide each other.
constexpr bool hasSurfaces(SceneKind kind) {
    return kind == SceneKind::Room || kind == SceneKind::Depth;
}

std::string_view name(SceneKind kind);

/// Errors: InvalidInput, listing the names.
SceneKind sceneKind(std::string_view name);

/// The largest share of the sphere's radius by which a camera may leave the photo; farther out it is treated
/// as if it stood there, since outside of the sphere rays miss it.
constexpr double kLargestDisplacement = 0.95;

/// A camera in the sphere about a photo. Frames: one common frame, rays are unit vectors. Threads: const, any
/// number.
class DisplacedCamera {
  public:
    /// offset: camera minus photo position; beyond kLargestDisplacement * radius it is shortened to that.
    /// Range: radius > 0.
    DisplacedCamera(const Eigen::Vector3d& offset, double radius);

    /// How far the ray goes to the sphere, in radii. Range: > 0.
    double distance(const Eigen::Vector3d& ray) const {
        const double along = m_from.dot(ray);
        const double root = std::sqrt(along * along + m_inside);
        // The positive root of t^2 + 2 along t - inside = 0, in the form that does not cancel.
        return along > 0 ? m_inside / (along + root) : root - along;
    }

    /// The direction in which the photo sees what the ray meets on the sphere. Shape: a unit vector, but for
    /// rounding.
    Eigen::Vector3d direction(const Eigen::Vector3d& ray) const { return m_from + distance(ray) * ray; }

  private:
    Eigen::Vector3d m_from; ///< in radii, so that neither tiny nor huge rooms lose digits
    double m_inside;        ///< 1 - |from|^2 > 0
};

/// The direction in which the photo sees what the camera's ray meets on a sphere about the photo.
/// Frames: one common frame. offset: camera minus photo position; ray: unit. Shape: not normalised, never
/// zero. Range: radius > 0; offsets beyond kLargestDisplacement * radius are shortened to it.
Eigen::Vector3d directionOnSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius);

} // namespace spherewalk::render
