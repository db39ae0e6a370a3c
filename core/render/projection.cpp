// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/projection.h"

namespace spherewalk::render {

Projection::Projection(const CameraModel& camera, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
                       EquirectSize photo, SceneKind scene, double sphereRadiusM)
    : m_camera(camera), m_rays(roomFromCamera, roomFromPhoto, scene, sphereRadiusM), m_photo(photo) {
}

std::optional<Eigen::Vector3d> Projection::photoDirection(const Eigen::Vector2d& viewPixel) const {
    const std::optional<Eigen::Vector3d> ray = m_camera.ray(viewPixel);
    return ray ? std::optional(m_rays.directionInPhoto(*ray)) : std::nullopt;
}

std::optional<Eigen::Vector2d> Projection::photoPixel(const Eigen::Vector2d& viewPixel) const {
    const std::optional<Eigen::Vector3d> direction = photoDirection(viewPixel);
    return direction ? std::optional(pixel(m_photo, *direction)) : std::nullopt;
}

} // namespace spherewalk::render
