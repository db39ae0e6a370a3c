// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lattice.h"
#include "photo_plane.h"
#include "ray_table.h"

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/sampling.h"

#include <array>
#include <vector>

namespace spherewalk::render {

/// How many photo pixels one view pixel spans at the middle of the picture, along the axis that has more.
double minification(const CameraModel& camera, int photoWidth);

/// Samples along each axis of a pixel: 1, but for the footprint as many as keep them less than 1.5 photo
/// pixels apart, in [2, 8].
int samplesPerAxis(Sampling sampling, double minification);

/// How near a rung comes at worst to the mean over each pixel's area, in decibels (peak signal to noise
/// ratio): measured on pictures full of detail, and no promise for others. Range: any minification; below
/// 0.47 and above 3.82 the nearest one's.
double expectedDb(Sampling sampling, double minification);

/// The sampling itself; for Sampling::Auto the first of Reduced, Bilinear (cheapest first) that is expected
/// to reach this, or Footprint. Nearest and Bicubic are never chosen: they cost more than something better.
Sampling chosenSampling(Sampling sampling, double minification, double toleranceDb);

/// Memory that views are made in, kept from frame to frame. Threads: one view at a time.
class Workspace {
  public:
    /// Room for a view through these rays by so many workers; cheap if it is there.
    void prepare(const RayTable& rays, int workers);

    struct Coordinates {
        AlignedBuffer<std::int32_t> u;
        AlignedBuffer<std::int32_t> v;
    };

    struct Worker {
        LatticeScratch lattice;
        std::array<Coordinates, 2> coordinates; ///< of two neighbouring cells
    };

    Worker& worker(int index) { return m_workers[static_cast<std::size_t>(index)]; }

  private:
    std::size_t m_samples = 0;
    int m_cellsX = 0;
    std::vector<Worker> m_workers;
};

/// What a view is taken from: for Sampling::Reduced, photo is the picture at half its size.
struct ViewSource {
    PlaneView photo;
    Rigid3 roomFromPhoto;
    SceneKind scene = SceneKind::None;
    double sphereRadiusM = 0;
};

/// Renders a view, rows of cells in parallel, and allocates nothing once workspace and picture have their
/// size. The bytes are the same for any number of threads and any processor. sampling: not Auto. rays: with
/// samplesPerAxis() of the sampling. threads: at most, 0 for all of the pool. picture: made to fit; black
/// where the lens sees nothing. Errors: InvalidInput if rays has another number of samples than the sampling
/// needs.
void renderView(const RayTable& rays, const Rigid3& roomFromCamera, const ViewSource& source,
                Sampling sampling, WorkerPool& pool, int threads, Workspace& workspace, RgbImage& picture);

} // namespace spherewalk::render
