// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

namespace spherewalk::scene {

/// Sizes in pixels are for depths of this width.
inline constexpr int kUsualWidth = 1024;

/// Neighbours whose 1 / distance differs by more than this share of the greater are torn apart, as in views.
inline constexpr float kTorn = 0.08F;

/// One value a pixel of an equirectangular picture.
using Plane = Image<float, 1>;

/// Replaces each value by the mean over (2 radius + 1) x (2 radius + 1) pixels. The plane is equirectangular:
/// it wraps at the seam and repeats its first and last rows. Range: radius less than half of the width.
void blur(Plane& plane, int radius, int threads);

/// Blurs planes, though not across the edges of a guide. Source: He, Sun, Tang 2010. Threads: const, any
/// number.
class GuidedFilter {
  public:
    /// guide: values in [0, 1]. Its edges that are higher than about the square root of `smoothness` are
    /// kept.
    GuidedFilter(Plane guide, int radius, float smoothness, int threads);

    void apply(Plane& plane) const;

  private:
    Plane m_guide;
    Plane m_mean;
    Plane m_inverseVariance;
    int m_radius;
    int m_threads;
};

/// The median of the 3 x 3 pixels around each pixel of an equirectangular plane.
Plane median3x3(const Plane& plane, int threads);

/// The least of each value and of the four so many pixels from it along its row and its column of an
/// equirectangular plane. Range: reach at most half of the width.
Plane leastOfCross(const Plane& plane, int reach, int threads);

/// The same with the greatest value.
Plane mostOfCross(const Plane& plane, int reach, int threads);

/// The least known value within about 3 % of the width of each pixel; HUGE_VALF if none is known there.
/// weight: above 0 where a value is known.
Plane leastKnownAbout(const Plane& known, const Plane& weight, int threads);

/// Replaces each value by the value of a plane fitted to the pixels around that belong to the same surface.
/// Where a surface is flat, 1 / distance is about linear in the picture. Values that differ by more than two
/// percent (more at farther pixels) lie on another surface. threads: the result is the same for any number.
Plane smoothedSurfaces(const Plane& inverseM, int threads);

/// Evens the borders of surfaces where nothing is sure. Where values jump by more than 8 % within two pixels,
/// as views tear surfaces, each value becomes the median of the 5 x 5 about it, twice. The first column goes
/// on after the last. threads: the result is the same for any number.
Plane evenedBorders(Plane inverseM, const MaskImage& sure, int threads);

/// What a completed value may be, and is where nothing is known.
struct CompletionRange {
    float usual; ///< Beyond the base.
    float least;
    float most;
};

/// A value for each pixel of an equirectangular picture, where only some are known. A plane's 1 / distance is
/// the product of one vector with the unit direction, whatever the direction. So each pixel gets a vector.
/// Neighbours want the same one, less so across edges of the picture, and a known value pulls with its
/// weight. A plane that is known along its borders is continued over its middle. Far from what is known a
/// plane would go anywhere, so values fade to those that change least from pixel to pixel. Where nothing is
/// known they are `usual`. base: what the vectors' products are added to, as of a room; empty for nothing.
/// Then it is the differences from it that are completed, and far from what is known they are `usual`, too.
/// Shape: all of one size, the width a multiple of 32. weight: in [0, 1]; 0 where nothing is known. Range:
/// the result lies between `least` and `most`. threads: the result is the same for any number. Cost: 0.3 s of
/// one core at 1024 x 512.
Plane completedByPlanes(const Plane& known, const Plane& weight, const RgbImage& picture, const Plane& base,
                        const CompletionRange& range, int threads);

struct PhotoDepth;

/// The depth, and where it is not sure, planes as completedByPlanes() continues them from what is sure.
/// base: as there; what is far from all that is sure. Shape: the picture has any size.
Plane continuedFromSure(const PhotoDepth& depth, const RgbImage& picture, const Plane& base, int threads);

} // namespace spherewalk::scene
