// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

namespace spherewalk::jobs {

/// One of several parts of a job, each done by a process of its own.
struct Shard {
    std::size_t index = 0; ///< from 0
    std::size_t count = 1;

    /// From "i/n", i from 1 to n. Errors: InvalidInput.
    static Shard parse(std::string_view text);

    bool isWhole() const { return count == 1; }

    /// The part's first item, and one beyond its last: parts of about the same size, one after the other.
    std::pair<std::size_t, std::size_t> range(std::size_t items) const {
        return {index * items / count, (index + 1) * items / count};
    }
};

} // namespace spherewalk::jobs
