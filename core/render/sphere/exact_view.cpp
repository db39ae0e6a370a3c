// SPDX-License-Identifier: Apache-2.0
#include "sphere/exact_view.h"

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Vector3d pixelValue(const RgbImage& photo, int x, int y) {
    if (y < 0 || y >= photo.height()) {
        y = y < 0 ? -1 - y : 2 * photo.height() - 1 - y;
        x += photo.width() / 2;
    }
    x %= photo.width();
    const std::uint8_t* rgb = photo.at(x < 0 ? x + photo.width() : x, y);
    return {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])};
}

Vector3d pixelValue(const PlaneView& photo, int x, int y) {
    return Vector3d(photo.stored(x, y, 0), photo.stored(x, y, 1), photo.stored(x, y, 2)).array() + 128;
}

template <class Photo>
Vector3d blend(const Photo& photo, const Vector2d& pixel) {
    const double left = std::floor(pixel.x());
    const double top = std::floor(pixel.y());
    const double a = pixel.x() - left;
    const double b = pixel.y() - top;
    const int x = static_cast<int>(left);
    const int y = static_cast<int>(top);
    return (1 - b) * ((1 - a) * pixelValue(photo, x, y) + a * pixelValue(photo, x + 1, y)) +
           b * ((1 - a) * pixelValue(photo, x, y + 1) + a * pixelValue(photo, x + 1, y + 1));
}

void exactRow(const Projection& projection, const PlaneView& photo, int y, RgbImage& picture) {
    for (int x = 0; x < picture.width(); ++x) {
        const auto at = projection.photoPixel(Vector2d(x, y));
        const Vector3d value = at ? bilinear(photo, *at) : Vector3d(0, 0, 0);
        for (int c = 0; c < 3; ++c) {
            picture.at(x, y)[c] = static_cast<std::uint8_t>(value[c] + 0.5);
        }
    }
}

} // namespace

DisplacedCamera::DisplacedCamera(const Vector3d& offset, double radius) : m_from(offset / radius) {
    const double displacement = m_from.norm();
    if (displacement > kLargestDisplacement) {
        m_from *= kLargestDisplacement / displacement;
    }
    m_inside = 1 - m_from.squaredNorm();
}

Vector3d directionOnSphere(const Vector3d& offset, const Vector3d& ray, double radius) {
    return DisplacedCamera(offset, radius).direction(ray);
}

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

Projection::Projection(const CameraModel& camera, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
                       EquirectSize photo, SceneKind scene, double sphereRadiusM)
    : m_camera(camera), m_rays(roomFromCamera, roomFromPhoto, scene, sphereRadiusM), m_photo(photo) {
}

std::optional<Vector3d> Projection::photoDirection(const Vector2d& viewPixel) const {
    const std::optional<Vector3d> ray = m_camera.ray(viewPixel);
    return ray ? std::optional(m_rays.directionInPhoto(*ray)) : std::nullopt;
}

std::optional<Vector2d> Projection::photoPixel(const Vector2d& viewPixel) const {
    const std::optional<Vector3d> direction = photoDirection(viewPixel);
    return direction ? std::optional(pixel(m_photo, *direction)) : std::nullopt;
}

Vector3d bilinear(const RgbImage& photo, const Vector2d& pixel) {
    return blend(photo, pixel);
}

Vector3d bilinear(const PlaneView& photo, const Vector2d& pixel) {
    return blend(photo, pixel);
}

void drawExactly(const CameraModel& camera, const Projection& projection, const PlaneView& photo,
                 WorkerPool& pool, int threads, RgbImage& picture) {
    if (picture.width() != camera.width() || picture.height() != camera.height()) {
        picture = RgbImage(camera.width(), camera.height());
    }
    pool.run(picture.height(), threads, [&](int y, int) { exactRow(projection, photo, y, picture); });
}

} // namespace spherewalk::render
