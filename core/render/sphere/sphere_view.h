// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/photo_plane.h"
#include "sphere/lattice.h"
#include "sphere/ray_table.h"

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/ladder.h"

#include <array>
#include <vector>

namespace spherewalk::render {

/// Memory that views are made in, kept from frame to frame. Threads: one view at a time.
class Workspace {
  public:
    /// Makes room for a view through these rays by so many workers. Cost: little if there is room already.
    void prepare(const RayTable& rays, int workers);

    struct Coordinates {
        AlignedBuffer<std::int32_t> u;
        AlignedBuffer<std::int32_t> v;
    };

    struct Worker {
        LatticeRow row;
        std::array<Coordinates, 2> coordinates; ///< Two neighbouring cells take them in turns.
    };

    Worker& worker(int index) { return m_workers[static_cast<std::size_t>(index)]; }

  private:
    std::size_t m_samples = 0;
    int m_cellsX = 0;
    std::vector<Worker> m_workers;
};

/// The photo that a view is taken from. For Sampling::Reduced it is the picture at half its size.
struct ViewSource {
    PlaneView photo;
    Rigid3 roomFromPhoto;
    SceneKind scene = SceneKind::None;
    double sphereRadiusM = 0;
};

/// Renders a view, rows of cells in parallel. It allocates nothing once workspace and picture have their
/// size. The bytes are the same for any number of threads and any processor. rays: the table with
/// samplesPerAxis() of the sampling. sampling: not Auto. threads: the most to use, 0 for all of the pool.
/// picture: it gets the view's size, and is black where the lens sees nothing. Errors: InvalidInput for rays
/// with another number of samples.
void renderView(const RayTable& rays, const Rigid3& roomFromCamera, const ViewSource& source,
                Sampling sampling, WorkerPool& pool, int threads, Workspace& workspace, RgbImage& picture);

} // namespace spherewalk::render
