// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace spherewalk::photo {

/// Of a pixel's red, green and blue, as the eye weighs them. Source: ITU-R BT.601.
inline float brightness(const std::uint8_t* rgb) {
    return 0.299F * static_cast<float>(rgb[0]) + 0.587F * static_cast<float>(rgb[1]) +
           0.114F * static_cast<float>(rgb[2]);
}

} // namespace spherewalk::photo
