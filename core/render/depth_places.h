// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_raster.h"
#include "ray_table.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/pixel_rays.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk::render {

/// Which of a view's photos each pixel is taken from, and where in it.
struct DepthPlaces {
    /// Fits them to a view.
    void resize(int width, int height);

    static constexpr std::uint8_t kUnseen = 255;

    MaskImage source;         ///< number of the photo; kUnseen where the lens sees nothing
    Image<float, 1> inverse;  ///< 1 / s as InverseBuffer, never 0: holes are filled
    Image<std::int32_t, 1> u; ///< photo coordinates in the lattice's fixed point
    Image<std::int32_t, 1> v;
};

/// A photo that a view may be taken from.
struct PlacedPhoto {
    Rigid3 roomFromPhoto;
    EquirectSize size;                   ///< of the level that is sampled
    const InverseBuffer* seen = nullptr; ///< its surface
};

/// Takes each pixel from the first photo whose surface covers it. What none covers is taken for as far as the
/// farther of what lies to its left and to its right, and from the first photo; without either, for
/// `usualDistanceM`. Arithmetic: single precision, off by less than 0.01 pixels of a photo of 8192.
void placePixels(const PixelRays& rays, const Rigid3& roomFromCamera, std::span<const PlacedPhoto> photos,
                 double usualDistanceM, WorkerPool& pool, int threads, DepthPlaces& places);

/// How a photo's coordinates change from one pixel of the view to the next about a pixel, in fixed point:
/// du/dx, dv/dx, du/dy, dv/dy. Zero within ten degrees of the photo's poles, and where the lens sees nothing.
std::array<std::int32_t, 4> placeSlopes(const PixelRays& rays, const Rigid3& roomFromCamera,
                                        const PlacedPhoto& photo, int x, int y, float inverse);

} // namespace spherewalk::render
