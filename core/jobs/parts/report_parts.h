// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json_fwd.h"

#include <optional>
#include <string>

namespace spherewalk::jobs {

/// The value, "-" if it is not known, or "lost" if it is infinite.
std::string orDash(const std::optional<double>& value, int digits = 2);

/// The value, or null if it is not known or infinite.
Json orNull(const std::optional<double>& value);

/// The difference a - b, times a factor, on a grey of 128. Range: pictures of one size.
RgbImage difference(const RgbImage& a, const RgbImage& b, int times);

} // namespace spherewalk::jobs
