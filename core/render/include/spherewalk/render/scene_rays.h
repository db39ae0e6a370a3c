// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/scene_model.h"

#include <Eigen/Core>

namespace spherewalk::render {

/// What a camera's rays meet in a scene model: the one place that projection, depth and trust ask, so that
/// they agree. Frames: rays are unit vectors of the camera's optical frame. Threads: const, any number.
class SceneRays {
  public:
    /// roomFromCamera: of the optical frame. sphereRadiusM: for SceneKind::Sphere. Positions are subtracted
    /// before anything else, so a room may lie at 10^6 m.
    SceneRays(const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto, SceneKind scene,
              double sphereRadiusM);

    /// The direction, in the photo's frame, in which the photo sees what the ray meets. Shape: a unit vector,
    /// but for rounding.
    Eigen::Vector3d directionInPhoto(const Eigen::Vector3d& rayInCamera) const;

    /// Metres from the camera, along the ray, to what it meets; +infinity where the scene model knows of
    /// nothing.
    double distanceM(const Eigen::Vector3d& rayInCamera) const;

    /// The camera's position minus the photo's, in the optical frame, metres: all of it, even where the scene
    /// model treats the camera as nearer.
    const Eigen::Vector3d& offsetInCamera() const { return m_offsetInCamera; }

  private:
    Eigen::Matrix3d m_photoFromCamera;
    Eigen::Vector3d m_offsetInCamera;
    SceneKind m_scene;
    double m_sphereRadiusM;
    DisplacedCamera m_inPhoto; ///< for SceneKind::Sphere; the same camera in two frames
    DisplacedCamera m_inCamera;
};

} // namespace spherewalk::render
