// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_raster.h"
#include "ray_table.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/pixel_rays.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace spherewalk::render {

/// Which of a view's photos each pixel is taken from, and where in it.
struct DepthPlaces {
    static constexpr std::uint8_t kUnseen = 255;
    static constexpr int kCell = OpenCells::kCell;
    static constexpr std::size_t kCellPixels = std::size_t{kCell} * kCell;

    /// Fits them to a view, all of it taken from the first photo.
    void reset(int width, int height);

    /// Takes what nothing covers yet from a further photo, where its surface covers it.
    void take(const InverseBuffer& seen, std::uint8_t photo, const OpenCells& open, WorkerPool& pool,
              int threads);

    int columns() const { return source.width() / kCell; } ///< cells

    int rows() const { return source.height() / kCell; }

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row * columns() + column);
    }

    MaskImage source;            ///< number of the photo; kUnseen where the lens sees nothing; whole cells
    InverseBuffer inverse;       ///< once the pixels are placed never 0: holes are filled
    std::vector<std::int32_t> u; ///< photo coordinates in the lattice's fixed point, cell after cell
    std::vector<std::int32_t> v;

    /// Of each cell and photo, if they were asked for: placeSlopes() about its middle.
    std::vector<std::array<std::int32_t, 4>> slopes;

    /// Of a cell: a bit for the first photo and each other that a pixel is taken from; kBlind where the lens
    /// sees nothing.
    std::vector<std::uint32_t> sources;
    static constexpr std::uint32_t kBlind = 1U << 31;
};

/// A photo that a view may be taken from.
struct PlacedPhoto {
    Rigid3 roomFromPhoto;
    EquirectSize size; ///< of the level that is sampled
};

/// Places the pixels whose photos are known. What no photo covers is taken for as far as the farther of what
/// lies to its left and to its right, and from the first photo; without either, for `usualDistanceM`. open:
/// the cells that have such pixels. wantsSlopes: of the cells too. placed: called with each row of cells that
/// is placed, by the thread that did it. Arithmetic: single precision, off by less than 0.04 pixels of a
/// photo of 8192.
void placePixels(const PixelRays& rays, const Rigid3& roomFromCamera, std::span<const PlacedPhoto> photos,
                 const OpenCells& open, double usualDistanceM, bool wantsSlopes, WorkerPool& pool,
                 int threads, const std::function<void(int row)>& placed, DepthPlaces& places);

/// How a photo's coordinates change from one pixel of the view to the next about a pixel, in fixed point:
/// du/dx, dv/dx, du/dy, dv/dy. Zero within ten degrees of the photo's poles, and where the lens sees nothing.
std::array<std::int32_t, 4> placeSlopes(const PixelRays& rays, const Rigid3& roomFromCamera,
                                        const PlacedPhoto& photo, int x, int y, float inverse);

} // namespace spherewalk::render
