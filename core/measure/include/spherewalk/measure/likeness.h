// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

namespace spherewalk::measure {

/// Structural similarity of two pictures' brightness, in [-1, 1], 1 for equal ones; a Gaussian window of
/// 1.5 pixels. Errors: InvalidInput if the sizes differ or are empty; Internal, for what OpenCV refuses.
/// Source: Wang, Bovik, Sheikh, Simoncelli 2004.
double structuralSimilarity(const RgbImage& a, const RgbImage& b);

} // namespace spherewalk::measure
