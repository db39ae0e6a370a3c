// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/jpeg/region.h"

#include <string_view>

namespace spherewalk::measure {

/// What a result must pass before it is timed: a wrong one may be had in no time. Errors: Internal, with what
/// was compared.

/// Mean absolute difference of the values, in grey levels; infinity for pictures of different sizes.
double meanDifference(const RgbImage& a, const RgbImage& b);

/// The pictures differ by no more than that on average.
void requireAlike(const RgbImage& picture, const RgbImage& expected, double mostGreyLevels,
                  std::string_view what);

void requireSame(const RgbImage& picture, const RgbImage& expected, std::string_view what);

/// The part has the bytes that the whole has there.
void requirePart(const RgbImage& part, const jpeg::PixelRect& region, const RgbImage& whole,
                 std::string_view what);

/// The same for samples as the JPEG stores them; region: beginning and ending
/// between chroma samples.
void requirePart(const jpeg::Planes& part, const jpeg::PixelRect& region, const jpeg::Planes& whole,
                 std::string_view what);

} // namespace spherewalk::measure
