// SPDX-License-Identifier: GPL-3.0-or-later
// Input: the length of the pieces, and the bytes of a live preview. However they are cut, the same pictures
// come out, each from a start to an end marker, and none larger than allowed.
#include "spherewalk/camera/live_preview.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace spherewalk;

namespace {

constexpr std::size_t kMostBytes = 2000;

std::vector<Bytes> framesOf(ByteView stream, std::size_t step) {
    camera::PreviewParser parser(kMostBytes);
    std::vector<Bytes> frames;
    for (std::size_t at = 0; at < stream.size(); at += step) {
        parser.feed(stream.subspan(at, std::min(step, stream.size() - at)),
                    [&](camera::PreviewFrame frame) { frames.push_back(std::move(frame.jpeg)); });
    }
    return frames;
}

bool isWhole(const Bytes& frame) {
    return frame.size() <= kMostBytes && frame.size() > 4 && frame[0] == 0xff && frame[1] == 0xd8 &&
           frame[frame.size() - 2] == 0xff && frame.back() == 0xd9;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 1) {
        return 0;
    }
    const ByteView stream(data + 1, size - 1);
    const std::vector<Bytes> frames = framesOf(stream, stream.size() + 1);
    if (frames != framesOf(stream, std::size_t{data[0]} + 1) ||
        !std::all_of(frames.begin(), frames.end(), isWhole)) {
        std::abort();
    }
    return 0;
}
