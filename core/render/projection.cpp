// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/projection.h"

namespace spherewalk::render {

Projection::Projection(const CameraModel& camera, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
                       EquirectSize photo, SceneKind scene, double sphereRadiusM)
    : m_camera(camera),
      m_photoFromCamera((roomFromPhoto.rotation.conjugate() * roomFromCamera.rotation).toRotationMatrix()),
      m_offsetInPhoto(roomFromPhoto.rotation.conjugate() *
                      (roomFromCamera.translation - roomFromPhoto.translation)),
      m_photo(photo),
      m_scene(scene),
      m_sphereRadiusM(sphereRadiusM) {
}

std::optional<Eigen::Vector2d> Projection::photoPixel(const Eigen::Vector2d& viewPixel) const {
    const std::optional<Eigen::Vector3d> rayInCamera = m_camera.ray(viewPixel);
    if (!rayInCamera) {
        return std::nullopt;
    }
    const Eigen::Vector3d ray = m_photoFromCamera * *rayInCamera;
    return pixel(m_photo, m_scene == SceneKind::Sphere
                              ? directionOnSphere(m_offsetInPhoto, ray, m_sphereRadiusM)
                              : ray);
}

} // namespace spherewalk::render
