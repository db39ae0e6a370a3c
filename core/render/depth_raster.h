// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_mesh.h"
#include "depth_pieces.h"
#include "inverse_buffer.h"

#include "spherewalk/base/worker_pool.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <vector>

namespace spherewalk::render {

/// Draws surfaces as a camera sees them. Keeps its memory. The values are the same for any number of threads.
class DepthRaster {
  public:
    /// mesh: seen from where the photo was taken. Cells that are not open may be left out. tolerancePx: by
    /// how much a flat part may be displaced. out: made to fit; cells that are not open may have anything.
    void draw(const DepthMesh& mesh, const Rigid3& cameraFromPhoto, const CameraModel& camera,
              const OpenCells& open, double tolerancePx, WorkerPool& pool, int threads, InverseBuffer& out);

  private:
    class BlockCutter;

    static constexpr int kBand = OpenCells::kCell; ///< rows that one worker draws in turn

    static void clear(int row, const OpenCells& open, InverseBuffer& out);

    std::vector<std::vector<simd::Piece>> m_pieces; ///< of each row of blocks, for each band
};

} // namespace spherewalk::render
