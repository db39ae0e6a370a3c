// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/survey/private_region.h"

#include <span>
#include <string_view>

namespace spherewalk::photo {

/// Blurs regions of an equirectangular picture beyond recognition. Nothing is left of a region but the mean
/// colours of kBlurCells x kBlurCells cells, which run smoothly into each other. The cells are even on the
/// sphere, so that poles and seam are blurred like everything else. Returns which pixels were changed: 255
/// where a region is. Range: valid regions. Threads: any, with different pictures.
MaskImage blurRegions(RgbImage& picture, std::span<const survey::PrivateRegion> regions);

/// Cells along each side of a region. A face that fills its region keeps less than eyes and mouth need.
inline constexpr int kBlurCells = 4;

/// The photo with these regions blurred, as it may be given away. The other parts of the picture keep their
/// coefficients, and so does the camera's quality. Exif with the maker note, XMP and colour profile stay.
/// Pictures of the picture are taken out: Exif's thumbnail, those in XMP, further pictures, and all segments
/// that may hold one. A grey photo becomes one in colour. Without regions the bytes are returned as they are.
/// Errors: those of jpeg::decode() and PrivateRegion::validate(); Corrupt for damaged Exif or XMP. Threads:
/// any.
Bytes blurredPhoto(ByteView jpeg, std::span<const survey::PrivateRegion> regions, std::string_view source);

} // namespace spherewalk::photo
