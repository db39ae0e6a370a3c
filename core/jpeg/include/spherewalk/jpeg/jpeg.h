// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace spherewalk::jpeg {

/// The facts that the headers of a JPEG state.
struct Info {
    int width = 0;
    int height = 0;
    int components = 0;
    int mcuWidth = 0; ///< Pixels of a minimum coded unit (MCU): 16 for 4:2:0.
    int mcuHeight = 0;
    int restartInterval = 0; ///< MCUs between restart markers; 0 without markers.
    bool progressive = false;
};

/// The facts of a JPEG, without decoding it. `source` names the bytes in sentences, for example by a file's
/// name. Errors: Corrupt; Unsupported for more than 2^28 pixels, CMYK, or arithmetic coding.
Info readInfo(ByteView jpeg, std::string_view source);

/// All pixels in RGB, also of a grey picture. They come from libjpeg's accurate integer IDCT and fancy
/// upsampling, so that all our decoders give the same bytes. The picture is reduced by `denominator` (1, 2, 4
/// or 8) while it is decoded. Threads: any. Cost: about 5 ns a pixel on one core.
/// Errors: InvalidInput for another denominator; Unsupported as readInfo(). Corrupt for everything that makes
/// libjpeg warn: a truncated file is an error, not a grey area.
RgbImage decode(ByteView jpeg, std::string_view source, int denominator = 1);

/// The pixels at the least size that decode() has and that is at least this wide, or else as they are.
/// Errors: those of decode().
RgbImage decodeAtLeast(ByteView jpeg, std::string_view source, int width);

/// The picture as a baseline JPEG, 4:2:0, with optimised Huffman tables. Range: quality 1 to 100.
/// Errors: InvalidInput for another quality, or sides outside [1, 65500].
Bytes encode(const RgbImage& picture, int quality);

/// The JPEG with other pixels in some places. Minimum coded units that hold none of these places keep their
/// coefficients, and so their pixels but for colours next to a replaced unit. All segments stay. picture: all
/// pixels of the JPEG in its size; only those in replaced units count. where: other than 0 at the places.
/// Errors: Corrupt; Unsupported for a grey picture and as readInfo(); InvalidInput if sizes differ.
Bytes withPixels(ByteView jpeg, const RgbImage& picture, const MaskImage& where, std::string_view source);

/// The second bytes of JPEG markers. Source: ITU-T T.81, table B.1.
enum Marker : std::uint8_t {
    kSof0 = 0xC0,
    kSof1 = 0xC1,
    kSof2 = 0xC2,
    kRst0 = 0xD0,
    kRst7 = 0xD7,
    kSoi = 0xD8,
    kEoi = 0xD9,
    kSos = 0xDA,
    kDri = 0xDD,
    kApp0 = 0xE0,
    kApp1 = 0xE1,
    kApp15 = 0xEF,
    kCom = 0xFE,
};

/// One marker segment of a JPEG's header. The bytes stay in the file that it was found in.
struct Segment {
    std::uint8_t marker = 0;
    std::size_t offset = 0; ///< Where the marker's 0xFF stands, from the file's start.
    std::size_t size = 0;   ///< Marker, length field and content; 2 for a marker without content.

    /// The whole segment. Range: the bytes of the same file.
    ByteView whole(ByteView jpeg) const { return jpeg.subspan(offset, size); }

    /// The bytes after the length field; empty for a marker without content.
    ByteView content(ByteView jpeg) const { return size < 4 ? ByteView() : whole(jpeg).subspan(4); }

    bool operator==(const Segment&) const = default;
};

/// The segments after SOI up to the first SOS, which is the last one. Entropy-coded data follow it. All
/// segments lie within the bytes. Fill bytes (0xFF before a marker) belong to no segment.
/// Errors: Corrupt if the bytes do not begin with SOI, if a segment is cut off, or if no marker follows one.
std::vector<Segment> segments(ByteView jpeg, std::string_view source);

} // namespace spherewalk::jpeg
