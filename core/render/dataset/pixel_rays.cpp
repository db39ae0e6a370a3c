// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/pixel_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3d;

namespace {

/// The squares that it takes along an axis.
int squares(int pixels) {
    return (pixels + PixelRays::kSquare - 1) / PixelRays::kSquare;
}

} // namespace

PixelRays::PixelRays(const CameraModel& camera, WorkerPool& pool, int threads) : m_camera(camera) {
    const CameraIntrinsics& k = camera.intrinsics();
    // On the plane of (x, y, 1) points lie farther apart than their directions do.
    m_pinholeReach = 0.5 * kSquare * std::hypot(1 / k.fx, 1 / k.fy);
    if (k.lens == LensModel::Pinhole) {
        return;
    }
    m_rays = Image<float, 3>(camera.width(), camera.height());
    pool.run(camera.height(), threads, [&](int y, int) {
        for (int x = 0; x < camera.width(); ++x) {
            const Vector3d ray = camera.ray(Vector2d(x, y)).value_or(Vector3d::Zero());
            Eigen::Map<Eigen::Vector3f>(m_rays.at(x, y)) = ray.cast<float>();
        }
    });
    m_reach = Image<float, 1>(squares(camera.width()), squares(camera.height()));
    pool.run(m_reach.height(), threads, [&](int row, int) {
        for (int column = 0; column < m_reach.width(); ++column) {
            *m_reach.at(column, row) = measuredReach(column, row);
        }
    });
}

Vector2i PixelRays::middle(int column, int row) const {
    return {std::min(column * kSquare + kSquare / 2, m_camera.width() - 1),
            std::min(row * kSquare + kSquare / 2, m_camera.height() - 1)};
}

float PixelRays::measuredReach(int column, int row) const {
    const Vector2i at = middle(column, row);
    const Vector3d centre = ray(at.x(), at.y());
    // A last pixel alone has the one before it beside it.
    const int left = std::min(column * kSquare, std::max(0, m_camera.width() - 2));
    const int top = std::min(row * kSquare, std::max(0, m_camera.height() - 2));
    double reach = 0;
    for (int y = top; y <= std::min((row + 1) * kSquare, m_camera.height() - 1); ++y) {
        for (int x = left; x <= std::min((column + 1) * kSquare, m_camera.width() - 1); ++x) {
            const Vector3d other = ray(x, y);
            if (other.isZero(0)) {
                return std::numeric_limits<float>::infinity();
            }
            reach = std::max(reach, (other - centre).norm());
        }
    }
    constexpr double kRounded = 1.0001; // up
    return static_cast<float>(kRounded * reach);
}

Vector3d PixelRays::ray(int x, int y) const {
    if (m_rays.empty()) {
        const CameraIntrinsics& k = m_camera.intrinsics();
        return Vector3d((x - k.cx) / k.fx, (y - k.cy) / k.fy, 1).normalized();
    }
    return Eigen::Map<const Eigen::Vector3f>(m_rays.at(x, y)).cast<double>().normalized(); // zero stays zero
}

} // namespace spherewalk::render
