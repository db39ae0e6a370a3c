// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace spherewalk::render {

/// What a renderer has decoded, and for whom, since it was made. A request is what one view needs of one
/// photo.
struct LoadCounters {
    std::uint64_t hits = 0;         ///< requests all of whose tiles were in memory
    std::uint64_t late = 0;         ///< the other ones
    std::uint64_t waits = 0;        ///< late ones that waited
    std::uint64_t decodedTiles = 0; ///< for requests that waited
    std::uint64_t prefetchedTiles = 0;
    std::uint64_t droppedTiles = 0;
    std::uint64_t wholeDecodes = 0;   ///< of photos that cannot be decoded in parts
    std::uint64_t prefetchErrors = 0; ///< told again, as an Error, to the view that needs the tile
    double decodeMs = 0;              ///< for requests that waited, the waiting for others included
    double prefetchMs = 0;
    std::uint64_t residentBytes = 0; ///< of decoded pixels, now
};

} // namespace spherewalk::render
