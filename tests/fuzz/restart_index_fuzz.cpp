// SPDX-License-Identifier: Apache-2.0
// Input: the size of an index file (two bytes, little-endian), the index file, and the JPEG it is said to be
// of. Whatever they hold: an Error of the kinds that the headers name, or pixels.
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/region.h"
#include "spherewalk/jpeg/restart.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

using namespace spherewalk;

namespace {

void readParts(ByteView file, const jpeg::RestartIndex& index) {
    const jpeg::RegionDecoder decoder(std::make_shared<MemorySource>(file, "input"), index);
    const jpeg::PixelRect region{index.width / 2, index.height / 2,
                                 std::min(64, index.width - index.width / 2),
                                 std::min(64, index.height - index.height / 2)};
    decoder.decode(region);
    decoder.decodePlanes(region);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) {
        return 0;
    }
    const ByteView input(data + 2, size - 2);
    const std::size_t split = std::min(input.size(), std::size_t{data[0]} | std::size_t{data[1]} << 8);
    try {
        const jpeg::RestartIndex index = jpeg::parseRestartIndex(input.first(split), "input");
        const Bytes again = jpeg::serialised(index);
        if (!std::equal(again.begin(), again.end(), input.begin(),
                        input.begin() + static_cast<std::ptrdiff_t>(split))) {
            std::abort(); // what is accepted must be what would be written
        }
        readParts(input.subspan(split), index);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt && error.kind() != ErrorKind::Unsupported) {
            std::abort();
        }
    }
    return 0;
}
