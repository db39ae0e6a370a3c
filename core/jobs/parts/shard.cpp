// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/shard.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cmath>

namespace spherewalk::jobs {

Shard Shard::parse(std::string_view text) {
    constexpr double kMost = 1e6;
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto index = parseNumber(text.substr(0, slash));
    const auto count = parseNumber(text.substr(std::min(slash + 1, text.size())));
    const bool isSound = index && count && *index == std::floor(*index) && *count == std::floor(*count) &&
                         *index >= 1 && *index <= *count && *count <= kMost;
    if (!isSound) {
        throw Error(ErrorKind::InvalidInput,
                    spherewalk::text("\"", text,
                                     "\" is no part of a job: give \"i/n\", the i-th of n parts, i from 1 "
                                     "to n."));
    }
    return {static_cast<std::size_t>(*index) - 1, static_cast<std::size_t>(*count)};
}

} // namespace spherewalk::jobs
