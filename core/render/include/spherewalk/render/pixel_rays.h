// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/geometry/camera_model.h"

#include <Eigen/Core>

namespace spherewalk::render {

/// The rays through the centres of a camera's pixels, looked up: without distortion they are computed when
/// asked for, through a lens, where that takes a search, they are kept as 12 bytes a pixel. Make it once for
/// a camera, not for each frame. Threads: const, any number.
class PixelRays {
  public:
    /// threads: at most, 0 for all of the pool. Cost: through a lens about a microsecond a pixel.
    PixelRays(const CameraModel& camera, WorkerPool& pool, int threads = 0);

    const CameraModel& camera() const { return m_camera; }

    /// Unit vector of the optical frame, off by less than 1e-7; zero where the lens sees nothing. Range: 0 <=
    /// x < width, 0 <= y < height.
    Eigen::Vector3d ray(int x, int y) const;

  private:
    CameraModel m_camera;
    Image<float, 3> m_rays; ///< empty without distortion
};

} // namespace spherewalk::render
