// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/report_parts.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

std::string orDash(const std::optional<double>& value, int digits) {
    return !value ? "-" : std::isinf(*value) ? "lost" : fixed(*value, digits);
}

Json orNull(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json();
}

RgbImage difference(const RgbImage& a, const RgbImage& b, int times) {
    constexpr int kGrey = 128;
    RgbImage result(a.width(), a.height());
    for (std::size_t i = 0; i < result.values().size(); ++i) {
        result.values()[i] = static_cast<std::uint8_t>(
            std::clamp(kGrey + times * (int{a.values()[i]} - int{b.values()[i]}), 0, 255));
    }
    return result;
}

} // namespace spherewalk::jobs
