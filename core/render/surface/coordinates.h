// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/cells.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/pixel_rays.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace spherewalk::render {

/// Which photo each pixel of a view is taken from, and its coordinates in that photo.
struct SurfaceCoordinates {
    static constexpr std::uint8_t kUnseen = 255;
    static constexpr std::size_t kCellPixels = std::size_t{kCell} * kCell;

    /// Takes a view's size. All pixels then come from the first photo.
    void reset(int width, int height);

    /// Takes the pixels that nothing covers yet from a further photo, where its surface covers them.
    void take(const InverseBuffer& seen, std::uint8_t photo, const OpenCells& open, WorkerPool& pool,
              int threads);

    /// Mixes what the second photo sees with what the first one sees, and takes pixels that only the second
    /// one sees. seen: that of the second photo. perFirst: its weight, if the first photo's is 1. Returns how
    /// many pixels the first photo does not see; pixels beyond the view count as seen.
    int mix(const InverseBuffer& seen, float perFirst, WorkerPool& pool, int threads);

    /// Opens pixels again that were taken from a photo and do not fit into a narrow hole. They are nearer
    /// than its nearer side by 10 %, or farther than its farther side by 15 %. A hole is narrow if it is
    /// known to its left and right within 32 pixels, or above and below. What another photo shows there is
    /// mostly wrong, or another room behind a thin wall. Nothing fits into a hole of up to 8 pixels: what
    /// continues its sides looks more like the room than a speck of another photo. width, height: of the
    /// view.
    void reopenNarrow(std::uint8_t photo, int width, int height, WorkerPool& pool, int threads);

    int columns() const { return source.width() / kCell; } ///< The number of cells side by side.

    int rows() const { return source.height() / kCell; }

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row * columns() + column);
    }

    MaskImage source;      ///< The photo's number; kUnseen where the lens sees nothing. Shape: whole cells.
    InverseBuffer inverse; ///< Once coordinates were found this is never 0, as holes are filled.
    std::vector<std::int32_t> u; ///< Coordinates in fixed point, cell after cell.
    std::vector<std::int32_t> v;

    MaskImage share; ///< After mix(): the second photo's share of pixels that two photos see, in 255 parts.
    std::vector<std::int32_t> mixedU; ///< As u, in the second photo. Only cells with kMixed have values.
    std::vector<std::int32_t> mixedV;

    /// coordinateSlopes() about the middle of each cell for each photo, if they were asked for. Those of a
    /// photo in a cell are at [cell * photos + photo].
    std::vector<std::array<std::int32_t, 4>> slopes;

    /// The photos of each cell as bits. The first photo's bit is always set.
    std::vector<std::uint32_t> sources;
    static constexpr std::uint32_t kBlind = 1U << 31; ///< The lens sees nothing in some pixel.
    static constexpr std::uint32_t kMixed = 1U << 30; ///< The second photo has a share in some pixel.
    static constexpr std::uint32_t kRims = 1U << 29;  ///< In a mixed cell: some pixel may show a rim.
    static constexpr std::uint32_t kPhotos = kRims - 1;

    /// Whether coordinates in a photo are wanted for a cell.
    bool wants(std::size_t cell, std::size_t photo) const {
        return (sources[cell] & (1U << photo | (photo == 1 ? kMixed : 0U))) != 0;
    }
};

/// A photo that a view may be taken from.
struct SourcePhoto {
    Rigid3 roomFromPhoto;
    EquirectSize size; ///< The size of the level that is sampled.
    LensPair lenses = {};
};

/// Finds the coordinates of the pixels, whose photos are known. A pixel that no photo covers comes from the
/// first photo. Its 1 / s is the lesser one of the nearest covered pixels to its left and right. Without
/// these it is 1 / `usualDistanceM`. A pixel that the lens does not see counts as covered with that value.
/// open: the cells with uncovered pixels. wantsSlopes: whether slopes are computed. found: the thread that
/// finished a row of cells calls it with the row; calls may overlap. Arithmetic: single precision, with an
/// error below 0.04 pixels of a photo of 8192.
void findCoordinates(const PixelRays& rays, const Rigid3& roomFromCamera, std::span<const SourcePhoto> photos,
                     const OpenCells& open, double usualDistanceM, bool wantsSlopes, WorkerPool& pool,
                     int threads, const std::function<void(int row)>& found, SurfaceCoordinates& coordinates);

/// How a photo's coordinates change from one pixel of the view to the next about a pixel: du/dx, dv/dx,
/// du/dy, dv/dy in fixed point. They are zero within ten degrees of the photo's poles and where the lens sees
/// nothing. inverse: 1 / s of the pixel.
std::array<std::int32_t, 4> coordinateSlopes(const PixelRays& rays, const Rigid3& roomFromCamera,
                                             const SourcePhoto& photo, int x, int y, float inverse);

} // namespace spherewalk::render

/// The photo coordinates of a view's pixels with known distances: each by itself, or a cell at a time as
/// polynomials. Coordinates are in the fixed point of pixels/fixed_point.h. The bytes are the same on every
/// processor.
namespace spherewalk::render::simd {

/// What coordinates in a photo are computed with. The direction in the photo is m * ray + inverse * offset,
/// less what its lens stands aside (LensPair).
struct PhotoTarget {
    std::array<float, 9> m;      ///< Photo from optical frame, row after row.
    std::array<float, 3> offset; ///< The camera minus the photo, in the photo's frame. Units: metres.
    float aheadM;                ///< LensPair::aheadM.
    float perRadian;             ///< Pixels per radian.
    float lastU;                 ///< The greatest coordinates, guard included.
    float lastV;
};

/// One component of the rays of a cell of 16 x 16 pixels. Frames: optical. Values of a row are contiguous.
struct CellRays {
    const float* first;
    std::ptrdiff_t pitch; ///< Values from one row to the next.
};

/// Computes the coordinates of a cell's pixels, row after row. inverse: as InverseBuffer. pitch: values of
/// `inverse` from one row to the next. u, v: 16 values for each row.
void locate(const PhotoTarget& target, const std::array<CellRays, 3>& rays, const float* inverse,
            std::ptrdiff_t pitch, std::int32_t* u, std::int32_t* v);

/// The rays (x, y, 1) of a row of cells of a view without distortion. Frames: optical. Cells have nodes at
/// their pixels 0, 7 and 14 along each axis.
struct NodeRays {
    static constexpr std::array<int, 3> kNodes{0, 7, 14};

    std::array<const float*, 3> x; ///< One array a node, one value a cell, with room for 16 more.
    std::array<float, 3> y;
    float stepX; ///< The step from one pixel to the next.
    float stepY;
};

/// The coordinates of a row of cells as polynomials. They are of second degree in x, y and the inverse depth
/// w, through 3 x 3 x 3 nodes each. Directions are linear in each variable, so that along a line through a
/// variable the direction moves on a great circle. With g its speed at the nearest point, the acceleration is
/// at most g^2 and the jerk 2 g^3. The bounds (2) of resources/docs/render.md, "The bound", turn these into
/// third derivatives. The error is at most
///     h^3 / (9 sqrt 3) (max|d3f/dx3| + 1.61 max|d3f/dy3| + 1.61^2 max|d3f/dw3|),
/// where h is half of what the nodes span, and 1.61 the factor by which interpolation up to pixel 15
/// enlarges.
struct CellFits {
    static constexpr std::size_t kTerms = 27;
    static constexpr float kTolerancePx = 0.03F;

    explicit CellFits(int cells);

    std::size_t pitch; ///< Values from one coefficient to the next: the cells, and room for 16 more.
    /// The coefficient of x^i y^j w^k is at [(9 k + 3 j + i) * pitch + cell]. Each variable is -1 at its
    /// first node and 1 at its last. Units: 2^-16 pixels.
    std::vector<float> u;
    std::vector<float> v;
    std::vector<std::int32_t> middleU; ///< The polynomials are relative to these.
    std::vector<std::int32_t> middleV;
    std::vector<float> errorPx; ///< The bound, in pixels at the photo's equator. It may be infinite or NaN.
    std::vector<float> inverse; ///< The inverse depth at w = 0, in 1/m.
    std::vector<float> perSpan; ///< The change of w for 1/m of inverse depth.
};

/// Fits the cells of a row for which isWanted is 1. least, greatest: the inverse depths of each cell, with
/// room for 16 more.
void fit(const PhotoTarget& target, const NodeRays& rays, const float* least, const float* greatest,
         std::span<const std::uint8_t> isWanted, CellFits& fits);

/// The coordinates of the pixels of a cell that was fitted, row after row. u may lie beyond the seam.
/// inverse, pitch: as for the other locate(). Range: errorPx of the cell is small enough; `inverse` lies
/// between the cell's least and greatest.
void locate(const CellFits& fits, int cell, const float* inverse, std::ptrdiff_t pitch, std::int32_t* u,
            std::int32_t* v);

/// How coordinates change from one pixel to the next about pixel (7, 7), where the inverse depth is that:
/// du/dx, dv/dx, du/dy, dv/dy in fixed point.
std::array<std::int32_t, 4> slopes(const CellFits& fits, int cell, float inverse);

} // namespace spherewalk::render::simd
