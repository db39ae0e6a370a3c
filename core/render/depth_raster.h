// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_mesh.h"

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <span>
#include <vector>

namespace spherewalk::render {

/// What a camera sees of a surface, 1 / s a pixel: the point is s times the pixel's ray, which is (x, y, 1)
/// without distortion, so that s is the depth along the axis, and a unit vector through a lens. 0 where it
/// sees none.
using InverseBuffer = Image<float, 1>;

/// Which of a view's cells of 16 x 16 pixels have pixels that nothing covers yet. Threads: const, any number.
class OpenCells {
  public:
    static constexpr int kCell = 16;

    /// All are open.
    OpenCells(int width, int height);

    /// Those are open in which all of these buffers have a pixel of 0.
    void update(std::span<const InverseBuffer> buffers, WorkerPool& pool, int threads);

    bool any() const { return m_sums.back() > 0; }

    /// Whether one is open that meets this part of the view. Units: pixels; any.
    bool anyIn(float left, float top, float right, float bottom) const;

  private:
    int m_width; ///< cells
    int m_height;
    std::vector<int> m_sums; ///< of the open cells above and to the left, with a row and a column of zeros
};

/// Draws surfaces as a camera sees them. Keeps its memory. The values are the same for any number of threads.
class DepthRaster {
  public:
    /// mesh: seen from where the photo was taken. Cells that are not open may be left out. tolerancePx: by
    /// how much a flat part may be displaced. out: made to fit, and cleared.
    void draw(const DepthMesh& mesh, const Rigid3& cameraFromPhoto, const CameraModel& camera,
              const OpenCells& open, double tolerancePx, WorkerPool& pool, int threads, InverseBuffer& out);

  private:
    struct Triangle {
        float x[3], y[3];
        float slopeX, slopeY, base; ///< value = slopeX x + slopeY y + base
        float least, most;
    };

    struct Vertex {
        float x = 0, y = 0;
        float value = 0; ///< 0: not in front of the camera
    };

    /// One block's triangles.
    struct Block {
        std::vector<Triangle> triangles;
        float top = 0, bottom = 0;
    };

    class Projector;
    class BlockDrawer;

    static void drawBand(std::span<const Block> blocks, int begin, int end, InverseBuffer& out);
    static void drawTriangle(const Triangle& triangle, int begin, int end, InverseBuffer& out);

    std::vector<Block> m_blocks;
};

} // namespace spherewalk::render
