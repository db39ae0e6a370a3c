// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/render/scene_rays.h"

#include <Eigen/Core>

#include <optional>

namespace spherewalk::render {

/// Where each pixel of a view comes from in a photo, computed exactly in double precision: the reference that
/// faster code is compared with. Threads: const, any number.
class Projection {
  public:
    /// roomFromCamera: of the camera's optical frame. sphereRadiusM: used by SceneKind::Sphere only.
    /// Positions are subtracted before anything else, so a room may lie at 10^6 m.
    Projection(const CameraModel& camera, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
               EquirectSize photo, SceneKind scene, double sphereRadiusM);

    /// The photo's pixel that the view's pixel shows; nothing where the lens sees nothing.
    std::optional<Eigen::Vector2d> photoPixel(const Eigen::Vector2d& viewPixel) const;

    /// The direction, in the photo's frame, of that pixel; not normalised.
    std::optional<Eigen::Vector3d> photoDirection(const Eigen::Vector2d& viewPixel) const;

  private:
    const CameraModel& m_camera;
    SceneRays m_rays;
    EquirectSize m_photo;
};

} // namespace spherewalk::render
