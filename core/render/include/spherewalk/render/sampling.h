// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace spherewalk::render {

/// How a view's pixel is made from the photo's, cheap to exact. What each costs and how far it is off stands
/// in resources/docs/render.md.
enum class Sampling {
    Nearest,   ///< the nearest pixel
    Bilinear,  ///< between the four nearest pixels: right where the view has as many pixels per degree as the
               ///< photo; where it has fewer, details flicker
    Reduced,   ///< bilinear, on the photo at half its size: no flicker up to a minification of about two,
               ///< softer
    Footprint, ///< the mean of n x n bilinear samples spread over the view's pixel, n at least 2 and such
               ///< that they are less than 1.5 photo pixels apart at the picture's centre: right when
               ///< minifying
    Bicubic,   ///< between sixteen pixels: right where the view has more pixels per degree than the photo
    Auto,      ///< the cheapest of Reduced, Bilinear and Footprint that is expected to be within a tolerance
};

std::string_view name(Sampling sampling);

/// Errors: InvalidInput, listing the names.
Sampling sampling(std::string_view name);

} // namespace spherewalk::render
