// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "byte_writer.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace spherewalk::dataset {

constexpr std::size_t kChunkBytes = 1 << 20; ///< after which a chunk is full

/// The times of some messages.
struct TimeRange {
    std::int64_t firstNs = std::numeric_limits<std::int64_t>::max();
    std::int64_t lastNs = 0;

    void add(std::int64_t timeNs) {
        firstNs = std::min(firstNs, timeNs);
        lastNs = std::max(lastNs, timeNs);
    }
};

/// Where a message is in its chunk.
struct ChunkEntry {
    std::int64_t timeNs = 0;
    std::uint64_t offset = 0;
};

/// Messages that are written and found together.
struct Chunk {
    ByteWriter records;
    std::map<std::size_t, std::vector<ChunkEntry>> entries; ///< by topic
    TimeRange times;

    void note(std::size_t topic, std::int64_t timeNs) {
        entries[topic].push_back({timeNs, records.size()});
        times.add(timeNs);
    }
};

} // namespace spherewalk::dataset
