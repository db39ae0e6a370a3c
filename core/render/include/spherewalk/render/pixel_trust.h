// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/render/view_geometry.h"

#include <cstdint>

namespace spherewalk::render {

/// What is to be known of a pixel besides its error; bits, so that several may hold.
enum class PixelFlag : std::uint8_t {
    Unseen = 1,    ///< the lens sees nothing there
    Pole = 2,      ///< near the photo's zenith or nadir, where the camera's own foot is in the picture
    Stitching = 4, ///< near the great circle in which the pictures of a camera's two lenses were joined
    Seam = 8,      ///< partly from the photo's left border, partly from its right one
    Coarse = 16,   ///< blurred, since the view was made from a coarser picture than the photo
    Overlay = 32,  ///< at least partly covered by an overlay
};

constexpr bool has(std::uint8_t flags, PixelFlag flag) {
    return (flags & static_cast<std::uint8_t>(flag)) != 0;
}

struct TrustOptions {
    /// How wrong 1 / distance of the scene model may be, as a share of it. 1: things may be at half of the
    /// distance (and at any greater one up to infinity), which is what ViewReport::parallaxPx assumes.
    double distanceResidual = 1;
    /// Photo pixels along one pixel of the picture that the view was made from: 1 for the photo itself, 2 for
    /// its half.
    double coarseness = 1;
    Degrees poleRadius{10}; ///< of PixelFlag::Pole. A choice: cameras stand on feet of different width
    /// Half of the width of the zone of PixelFlag::Stitching, on either side of azimuth +-90 degrees of the
    /// photo, where two-lens cameras join their pictures; 0 for photos of other cameras and for drawn ones. A
    /// choice: the zone's true width depends on the camera, and levelling in the camera turns it by the
    /// camera's tilt.
    Degrees stitchingHalfWidth{5};
    const MaskImage* overlays = nullptr; ///< what Composer::compose() showed, if anything

    /// Errors: InvalidInput with a sentence for values that are not finite, negative, or, for coarseness,
    /// below 1.
    void validate() const;
};

/// Shape: both that of the view.
struct PixelTrust {
    /// By how many pixels of the view what a pixel shows may be off its place; +infinity where the lens sees
    /// nothing. Under an overlay it is that of the photo's pixel.
    Image<float, 1> errorPx;
    MaskImage flags; ///< of PixelFlag
};

/// 1 where there is no error, 0.5 where one pixel is in doubt, 0 where the lens sees nothing; as
/// ViewReport::trust.
constexpr float trust(float errorPx) {
    return 1 / (1 + errorPx);
}

/// How far each pixel of a view can be believed. The error is the sum of two things. Displacement: the
/// offset between camera and photo, as far as it lies across the ray, times the scene model's error of 1 /
/// distance along this ray, in pixels of the view as the lens has them there, in the direction in which
/// things would move; with SceneKind::None, the error of 1 / distance is that of things at the usual
/// distance. At the picture's centre, with an offset across the axis, this is ViewReport::parallaxPx, but for
/// the difference between the sphere's radius and the displaced camera's distance to it. Blur: half of what a
/// pixel of a coarser picture spans beyond a pixel of the view, or of the photo where that is the larger.
///
/// threads: at most, 0 for all of the pool; the values are the same for any number. Errors: those of
/// validate() of the view and the options, and InvalidInput for a mask of another size. Cost: about a third
/// of a microsecond a pixel.
PixelTrust pixelTrust(const ViewGeometry& view, const TrustOptions& options, WorkerPool& pool,
                      int threads = 0);

} // namespace spherewalk::render
