// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/picture.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::practice {

using std::numbers::pi;

SphericalRays::SphericalRays(const Rigid3& roomFromPhoto, const EquirectSize& size)
    : m_size(size), m_eye(roomFromPhoto.translation), m_pixelAngle(static_cast<float>(pi / size.height)) {
    constexpr int kMaxSide = 32768;
    if (size.width < 1 || size.height < 1 || size.width > kMaxSide || size.height > kMaxSide) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not draw the practice room as a picture of ", size.width, " x ", size.height,
                         " pixels: the sides must be 1 to ", kMaxSide, "."));
    }
    const Eigen::Matrix3d axes = roomFromPhoto.rotation.normalized().toRotationMatrix();
    m_forward = axes.col(0);
    m_left = axes.col(1);
    m_up = axes.col(2);
    for (int x = 0; x < size.width; ++x) {
        m_azimuths.push_back(turn(pi - 2 * pi * (x + 0.5) / size.width));
    }
    for (int y = 0; y < size.height; ++y) {
        m_elevations.push_back(turn(pi / 2 - pi * (y + 0.5) / size.height));
    }
    for (int i = 0; i <= 8; ++i) {
        m_azimuthEighths.push_back(turn(-2 * pi * (i - 4) / 8.0 / size.width));
        m_elevationEighths.push_back(turn(-pi * (i - 4) / 8.0 / size.height));
    }
}

ViewRays::ViewRays(const CameraModel& camera, const Rigid3& roomFromCamera, int threads)
    : m_width(camera.width()), m_height(camera.height()), m_eye(roomFromCamera.translation) {
    const Eigen::Matrix3d axes = roomFromCamera.rotation.normalized().toRotationMatrix();
    m_axis = axes.col(2);
    const std::size_t count = static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
    m_rays.assign(count, Eigen::Vector3d::Zero());
    m_angles.assign(count, 0);
    parallelFor(m_height, 16, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < m_width; ++x) {
                if (const auto ray = camera.ray({x, y})) {
                    m_rays[index(x, y)] = axes * *ray;
                }
            }
        }
    });
    parallelFor(m_height, 16, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < m_width; ++x) {
                m_angles[index(x, y)] = angleOf(x, y);
            }
        }
    });
}

Eigen::Vector3d ViewRays::step(int x, int y, int dx, int dy) const {
    const auto difference = [&](int sx, int sy) -> Eigen::Vector3d {
        const int nx = x + sx;
        const int ny = y + sy;
        if (nx < 0 || ny < 0 || nx >= m_width || ny >= m_height || m_rays[index(nx, ny)].isZero()) {
            return Eigen::Vector3d::Zero();
        }
        return m_rays[index(nx, ny)] - m_rays[index(x, y)];
    };
    const Eigen::Vector3d towards = difference(dx, dy);
    return towards.isZero() ? Eigen::Vector3d(-difference(-dx, -dy)) : towards;
}

float ViewRays::angleOf(int x, int y) const {
    if (m_rays[index(x, y)].isZero()) {
        return 0;
    }
    const double across = step(x, y, 1, 0).norm();
    const double down = step(x, y, 0, 1).norm();
    return static_cast<float>(std::max({across, down, 1e-6}));
}

} // namespace spherewalk::practice
