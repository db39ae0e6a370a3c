// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json.h"
#include "spherewalk/sheet/document.h"

#include <optional>
#include <string>

/// What reports have in common.
namespace spherewalk::jobs {

/// For a screen.
std::string tableText(const sheet::Table& table);

/// "-" if it is not known.
std::string orDash(const std::optional<double>& value, int digits = 2);

/// null if it is not known.
Json orNull(const std::optional<double>& value);

/// What differs, so many times as much, on grey. Range: pictures of one size.
RgbImage difference(const RgbImage& a, const RgbImage& b, int times);

} // namespace spherewalk::jobs
