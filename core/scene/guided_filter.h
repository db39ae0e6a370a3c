// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

namespace spherewalk::scene {

using Plane = Image<float, 1>;

/// The mean over (2 radius + 1) x (2 radius + 1) pixels of an equirectangular plane: it wraps at the seam,
/// and repeats its first and last rows. Range: radius less than half of the width.
void blur(Plane& plane, int radius, int threads);

/// Blurs planes, but not across edges of a guide. Source: He, Sun, Tang 2010. Threads: const, any number.
class GuidedFilter {
  public:
    /// guide: in [0, 1]; edges higher than about the root of `smoothness` are kept.
    GuidedFilter(Plane guide, int radius, float smoothness, int threads);

    void apply(Plane& plane) const;

  private:
    Plane m_guide;
    Plane m_mean;
    Plane m_inverseVariance;
    int m_radius;
    int m_threads;
};

} // namespace spherewalk::scene
