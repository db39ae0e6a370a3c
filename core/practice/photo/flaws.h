// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/practice/practice_options.h"

namespace spherewalk::practice {

/// Joins the pictures of a camera's two lenses. The front lens shows what is less than 90 degrees from the
/// picture's middle. Near the seam the pictures fade into each other over two degrees. Range: both pictures
/// are equirectangular and of one size.
RgbImage stitched(const RgbImage& front, const RgbImage& back);

/// Gives a picture the exposure, the white balance and the noise of this shot, and the robot below the lens.
/// The same flaws and shot always give the same picture. Shape: equirectangular.
void addFlaws(RgbImage& picture, const PhotoFlaws& flaws, int shot);

} // namespace spherewalk::practice
