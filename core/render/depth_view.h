// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_mesh.h"
#include "depth_places.h"
#include "depth_raster.h"
#include "photo_plane.h"
#include "tile_grid.h"

#include "spherewalk/render/sampling.h"

#include <memory>
#include <vector>

namespace spherewalk::render {

/// A photo with its depth.
struct DepthPhoto {
    std::size_t photo = 0; ///< index in the dataset
    std::shared_ptr<const DepthMesh> mesh;
    Rigid3 roomFromPhoto;
    TileGrid grid; ///< of the level that is sampled
};

/// A view that is computed from photos with depth: what is hidden is hidden, and what the first photo does
/// not see comes from the next one that does. First place() says which parts of the photos it needs, then
/// sample() makes the picture. Keeps its memory from frame to frame; the bytes are the same for any number of
/// threads. Threads: one at a time.
class DepthView {
  public:
    /// By how much flat parts may be displaced, in pixels of the view.
    static constexpr double kTolerancePx = 0.5;
    static constexpr double kFurtherTolerancePx = 2; ///< the same of what the first photo does not see
    /// Of a view: less is not looked for in a third photo, but filled from beside.
    static constexpr double kLeastOpenShare = 0.01;

    /// photos: in the order in which they are asked, at most 8, at least one. usualDistanceM: of what nobody
    /// sees. Returns the tiles of each photo that sample() reads.
    std::vector<TileSet> place(const PixelRays& rays, const Rigid3& roomFromCamera,
                               std::span<const DepthPhoto> photos, double usualDistanceM, int samplesPerAxis,
                               WorkerPool& pool, int threads);

    /// planes: of the photos of place(), in its order. sampling: not Auto. picture: made to fit.
    void sample(const PixelRays& rays, std::span<const PlaneView> planes, Sampling sampling, WorkerPool& pool,
                int threads, RgbImage& picture) const;

    /// z along the optical axis, of the view that was placed; +infinity where the lens sees nothing or 90
    /// degrees or more off the axis.
    DepthImage depth(const PixelRays& rays) const;

    /// The share of the pixels that the first photo's surface does not cover.
    double filledShare() const { return m_filledShare; }

  private:
    static constexpr int kCell = DepthPlaces::kCell;

    /// A cell of 16 x 16 pixels, cut at the view's edges.
    struct Cell {
        int column = 0, row = 0;
        int width = 0, height = 0;
    };

    struct SampleSpace;

    Cell cell(int column, int row) const;
    void needOfCell(const Cell& at, std::size_t source, TileSet& tiles) const;
    void fillFirst(const Cell& at, const PlaneView& plane, Sampling sampling, SampleSpace& space) const;
    void sampleOthers(const Cell& at, std::span<const PlaneView> planes, Sampling sampling,
                      SampleSpace& space, RgbImage& picture) const;

    /// Sixteen pixels of a cell each.
    struct PixelRows {
        const std::int32_t* u;
        const std::int32_t* v;
        int count;
    };

    void fillPlaces(std::size_t cell, std::size_t source, const PlaneView& plane, Sampling sampling,
                    const PixelRows& rows, SampleSpace& space) const;
    void samplePart(const Cell& at, std::size_t source, const PlaneView& plane, Sampling sampling,
                    SampleSpace& space, RgbImage& picture) const;
    std::vector<PlacedPhoto> drawPhotos(const PixelRays& rays, const Rigid3& roomFromCamera,
                                        std::span<const DepthPhoto> photos, WorkerPool& pool, int threads);

    int m_width = 0;
    int m_height = 0;
    int m_samples = 1;
    OpenCells m_open{0, 0};
    InverseBuffer m_seen; ///< by a photo that is not the first
    DepthRaster m_raster;
    DepthPlaces m_places;
    std::size_t m_photos = 0; ///< that were drawn
    double m_filledShare = 0;
};

} // namespace spherewalk::render
