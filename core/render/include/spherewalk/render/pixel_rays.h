// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/camera_model.h"

#include <Eigen/Core>

namespace spherewalk::render {

/// The rays through the centres of a camera's pixels. Without distortion they are computed when asked for.
/// Through a lens a ray takes a search, so they are kept as 12 bytes a pixel. Make it once for a camera, not
/// for each frame. Threads: const functions may run on any number at a time.
class PixelRays {
  public:
    /// threads: the most to use, 0 for all of the pool. Cost: through a lens about a microsecond a pixel.
    PixelRays(const CameraModel& camera, WorkerPool& pool, int threads = 0);

    const CameraModel& camera() const { return m_camera; }

    /// A unit vector of the optical frame, with an error below 1e-7. It is zero where the lens sees nothing.
    /// Range: 0 <= x < width, 0 <= y < height.
    Eigen::Vector3d ray(int x, int y) const;

    static constexpr int kSquare = 8; ///< Pixels along an axis of the squares of reach().

    /// How far the rays of a square of pixels, and of the pixels to its right and below, are from the ray in
    /// its middle at most: chords of unit vectors. It is +infinity where the lens sees nothing in some pixel.
    /// column, row: squares are counted from the view's upper left one.
    double reach(int column, int row) const {
        return m_rays.empty() ? m_pinholeReach : *m_reach.at(column, row);
    }

    /// The pixel in the middle of a square.
    Eigen::Vector2i middle(int column, int row) const;

  private:
    float measuredReach(int column, int row) const;

    CameraModel m_camera;
    Image<float, 3> m_rays; ///< This is empty without distortion.
    double m_pinholeReach;
    Image<float, 1> m_reach; ///< One value a square. This is empty without distortion.
};

} // namespace spherewalk::render
