// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/spherewalk.h"

#include <cstdint>
#include <cstring>
#include <string_view>

/// Pictures in memory of the caller of the C interface.
namespace spherewalk::render {

/// Errors: InvalidInput for memory that cannot hold so many rows of so many bytes, or is NULL; what: it is,
/// for the sentence. Range: height > 0.
void checkRows(const spherewalk_source& source, std::uint64_t rowBytes, int height, std::string_view what);

inline spherewalk_source asSource(const spherewalk_buffer& buffer) {
    return {buffer.data, buffer.size_bytes, buffer.row_stride_bytes};
}

template <class Picture>
constexpr std::uint64_t rowBytes(int width) {
    using Value = typename decltype(Picture().values())::value_type;
    return sizeof(Value) * std::uint64_t{Picture::kChannels} * static_cast<std::uint64_t>(width);
}

/// Copies the picture to memory that checkRows() found fit for it.
template <class Picture>
void copyRows(const Picture& from, const spherewalk_buffer& into) {
    for (int y = 0; y < from.height(); ++y) {
        std::memcpy(static_cast<char*>(into.data) + static_cast<std::uint64_t>(y) * into.row_stride_bytes,
                    from.at(0, y), from.row(y).size_bytes());
    }
}

/// Copies a picture of this size, whose memory is used again if it has it. Errors: as checkRows().
template <class Picture>
void copyRows(const spherewalk_source& from, int width, int height, std::string_view what, Picture& into) {
    checkRows(from, rowBytes<Picture>(width), height, what);
    if (into.width() != width || into.height() != height) {
        into = Picture(width, height);
    }
    for (int y = 0; y < height; ++y) {
        std::memcpy(into.at(0, y),
                    static_cast<const char*>(from.data) +
                        static_cast<std::uint64_t>(y) * from.row_stride_bytes,
                    into.row(y).size_bytes());
    }
}

} // namespace spherewalk::render
