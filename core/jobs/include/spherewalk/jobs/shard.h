// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace spherewalk::jobs {

/// One of several parts of a job. A process of its own does each part.
struct Shard {
    std::size_t index = 0; ///< Counted from 0.
    std::size_t count = 1; ///< Number of parts.

    /// Reads "i/n", the i-th of n parts. Range: i from 1 to n, n up to a million. Errors: InvalidInput.
    static Shard parse(std::string_view part) {
        constexpr double kMost = 1e6;
        const std::size_t slash = std::min(part.find('/'), part.size());
        const auto index = parseNumber(part.substr(0, slash));
        const auto count = parseNumber(part.substr(std::min(slash + 1, part.size())));
        const bool isSound = index && count && *index == std::floor(*index) && *count == std::floor(*count) &&
                             *index >= 1 && *index <= *count && *count <= kMost;
        if (!isSound) {
            throw Error(ErrorKind::InvalidInput, text("\"", part,
                                                      "\" is no part of a job: give \"i/n\", the i-th of n "
                                                      "parts, i from 1 to n."));
        }
        return {static_cast<std::size_t>(*index) - 1, static_cast<std::size_t>(*count)};
    }

    bool isWhole() const { return count == 1; }

    /// The part's first item, and one beyond its last. The parts follow each other without gaps; their sizes
    /// differ by one item at most.
    std::pair<std::size_t, std::size_t> range(std::size_t items) const {
        return {index * items / count, (index + 1) * items / count};
    }
};

} // namespace spherewalk::jobs
