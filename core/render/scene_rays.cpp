// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/scene_rays.h"

#include <cmath>

namespace spherewalk::render {

using Eigen::Vector3d;

SceneRays::SceneRays(const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto, SceneKind scene,
                     double sphereRadiusM)
    : m_photoFromCamera((roomFromPhoto.rotation.conjugate() * roomFromCamera.rotation).toRotationMatrix()),
      m_offsetInCamera(roomFromCamera.rotation.conjugate() *
                       (roomFromCamera.translation - roomFromPhoto.translation)),
      m_scene(scene),
      m_sphereRadiusM(sphereRadiusM),
      m_inPhoto(roomFromPhoto.rotation.conjugate() * (roomFromCamera.translation - roomFromPhoto.translation),
                sphereRadiusM),
      m_inCamera(m_offsetInCamera, sphereRadiusM) {
}

Vector3d SceneRays::directionInPhoto(const Vector3d& rayInCamera) const {
    const Vector3d ray = m_photoFromCamera * rayInCamera;
    return m_scene == SceneKind::Sphere ? m_inPhoto.direction(ray) : ray;
}

double SceneRays::distanceM(const Vector3d& rayInCamera) const {
    return m_scene == SceneKind::Sphere ? m_sphereRadiusM * m_inCamera.distance(rayInCamera) : HUGE_VAL;
}

} // namespace spherewalk::render
