// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/photo_plane.h"

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/ladder.h"

#include <Eigen/Core>

#include <cmath>
#include <optional>

namespace spherewalk::render {

/// The way from a view's pixel to a photo's colour, exactly and in double precision. Faster code is compared
/// with it. Depth and trust of a view use the same rays, so that all agree.

/// The largest share of the sphere's radius by which a camera may leave the photo. A camera farther out is
/// treated as if it stood at that share, since rays from outside miss the sphere.
constexpr double kLargestDisplacement = 0.95;

/// A camera in the sphere about a photo. Frames: one common frame; rays are unit vectors. Threads: const
/// functions may run on any number at a time.
class DisplacedCamera {
  public:
    /// offset: the camera's position minus the photo's. One beyond kLargestDisplacement * radius is shortened
    /// to that. Range: radius > 0.
    DisplacedCamera(const Eigen::Vector3d& offset, double radius);

    /// How far the ray goes to the sphere, in radii. Range: > 0.
    double distance(const Eigen::Vector3d& ray) const {
        const double along = m_from.dot(ray);
        const double root = std::sqrt(along * along + m_inside);
        // The positive root of t^2 + 2 along t - inside = 0, in the form that does not cancel.
        return along > 0 ? m_inside / (along + root) : root - along;
    }

    /// The camera's position minus the photo's, in radii, shortened if need be.
    const Eigen::Vector3d& fromPhoto() const { return m_from; }

    /// 1 - |fromPhoto()|^2. Range: > 0.
    double inside() const { return m_inside; }

    /// The direction in which the photo sees the point where the ray meets the sphere. Shape: a unit vector,
    /// but for rounding.
    Eigen::Vector3d direction(const Eigen::Vector3d& ray) const { return m_from + distance(ray) * ray; }

  private:
    Eigen::Vector3d m_from; ///< Units: radii, so that neither tiny nor huge rooms lose digits.
    double m_inside;        ///< 1 - |from|^2 > 0
};

/// The direction in which the photo sees the point where the camera's ray meets a sphere about the photo.
/// Frames: one common frame. offset: as in DisplacedCamera. Shape: not normalised, never zero.
Eigen::Vector3d directionOnSphere(const Eigen::Vector3d& offset, const Eigen::Vector3d& ray, double radius);

/// The points where a camera's rays meet a scene model. Frames: rays are unit vectors of the camera's optical
/// frame. Threads: const functions may run on any number at a time.
class SceneRays {
  public:
    /// roomFromCamera: the pose of the optical frame. sphereRadiusM: the radius for SceneKind::Sphere.
    /// Positions are subtracted before anything else, so a room may lie at 10^6 m.
    SceneRays(const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto, SceneKind scene,
              double sphereRadiusM);

    /// The direction, in the photo's frame, in which the photo sees the ray's point. Shape: a unit vector,
    /// but for rounding.
    Eigen::Vector3d directionInPhoto(const Eigen::Vector3d& rayInCamera) const;

    /// The distance from the camera along the ray to its point, in metres. It is +infinity where the scene
    /// model has no point.
    double distanceM(const Eigen::Vector3d& rayInCamera) const;

    /// How many times as fast as its ray the direction in the photo turns, at most.
    double mostTurn() const { return m_scene == SceneKind::Sphere ? 1 + m_inPhoto.fromPhoto().norm() : 1; }

    /// The camera in the optical frame, for SceneKind::Sphere.
    const DisplacedCamera& inCamera() const { return m_inCamera; }

    /// The camera's position minus the photo's, in the optical frame, in metres. It is never shortened.
    const Eigen::Vector3d& offsetInCamera() const { return m_offsetInCamera; }

  private:
    Eigen::Matrix3d m_photoFromCamera;
    Eigen::Vector3d m_offsetInCamera;
    SceneKind m_scene;
    double m_sphereRadiusM;
    DisplacedCamera m_inPhoto; ///< The two are the same camera in two frames, for SceneKind::Sphere.
    DisplacedCamera m_inCamera;
};

/// The photo's pixel for each of a view's pixels. Threads: const functions may run on any number at a time.
class Projection {
  public:
    /// camera: it must outlive the projection. The other parameters: as in SceneRays.
    Projection(const CameraModel& camera, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
               EquirectSize photo, SceneKind scene, double sphereRadiusM);

    /// The photo's pixel that the view's pixel shows; nothing where the lens sees nothing.
    std::optional<Eigen::Vector2d> photoPixel(const Eigen::Vector2d& viewPixel) const;

    /// The direction of that pixel in the photo's frame. Shape: not normalised.
    std::optional<Eigen::Vector3d> photoDirection(const Eigen::Vector2d& viewPixel) const;

  private:
    const CameraModel& m_camera;
    SceneRays m_rays;
    EquirectSize m_photo;
};

/// The bilinear value of an equirectangular picture, in [0, 255] per channel. It wraps at the seam. Across a
/// pole it goes on half way round, as the sphere does. Range: pixel coordinates as geometry/equirect.h gives.
Eigen::Vector3d bilinear(const RgbImage& photo, const Eigen::Vector2d& pixel);
Eigen::Vector3d bilinear(const PlaneView& photo, const Eigen::Vector2d& pixel);

/// Draws a view pixel by pixel with bilinear sampling. picture: it gets the camera's size; pixels that the
/// lens does not see are black. threads: the most to use, 0 for all of the pool.
void drawExactly(const CameraModel& camera, const Projection& projection, const PlaneView& photo,
                 WorkerPool& pool, int threads, RgbImage& picture);

} // namespace spherewalk::render
