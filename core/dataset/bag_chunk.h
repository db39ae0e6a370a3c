// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/byte_writer.h"
#include "spherewalk/dataset/bag.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <vector>

namespace spherewalk::dataset {

/// A chunk with so many bytes is full.
constexpr std::size_t kChunkBytes = 1 << 20;

/// The first and the last time of some messages; firstNs > lastNs without messages.
struct TimeRange {
    std::int64_t firstNs = std::numeric_limits<std::int64_t>::max();
    std::int64_t lastNs = 0;

    void add(std::int64_t timeNs) {
        firstNs = std::min(firstNs, timeNs);
        lastNs = std::max(lastNs, timeNs);
    }
};

/// The place of a message in its chunk.
struct ChunkEntry {
    std::int64_t timeNs = 0;
    std::uint64_t offset = 0; ///< Bytes from the beginning of the chunk's records.
};

/// Messages that are written together and have one index.
struct Chunk {
    ByteWriter records;
    std::map<std::size_t, std::vector<ChunkEntry>> entries; ///< Key: topic.
    TimeRange times;

    /// Notes that the next record is a message of this topic.
    void note(std::size_t topic, std::int64_t timeNs) {
        entries[topic].push_back({timeNs, records.size()});
        times.add(timeNs);
    }
};

std::unique_ptr<Bag> makeRosbag(const std::filesystem::path& file);
std::unique_ptr<Bag> makeMcap(const std::filesystem::path& file);

} // namespace spherewalk::dataset
