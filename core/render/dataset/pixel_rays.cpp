// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/pixel_rays.h"

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

PixelRays::PixelRays(const CameraModel& camera, WorkerPool& pool, int threads) : m_camera(camera) {
    if (camera.intrinsics().lens == LensModel::Pinhole) {
        return;
    }
    m_rays = Image<float, 3>(camera.width(), camera.height());
    pool.run(camera.height(), threads, [&](int y, int) {
        for (int x = 0; x < camera.width(); ++x) {
            const Vector3d ray = camera.ray(Vector2d(x, y)).value_or(Vector3d::Zero());
            Eigen::Map<Eigen::Vector3f>(m_rays.at(x, y)) = ray.cast<float>();
        }
    });
}

Vector3d PixelRays::ray(int x, int y) const {
    if (m_rays.empty()) {
        const CameraIntrinsics& k = m_camera.intrinsics();
        return Vector3d((x - k.cx) / k.fx, (y - k.cy) / k.fy, 1).normalized();
    }
    return Eigen::Map<const Eigen::Vector3f>(m_rays.at(x, y)).cast<double>().normalized(); // zero stays zero
}

} // namespace spherewalk::render
