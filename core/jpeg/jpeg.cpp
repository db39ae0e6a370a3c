// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/jpeg/jpeg.h"

#include "codec.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <utility>

namespace spherewalk::jpeg {

namespace {

void checkDenominator(int denominator) {
    if (denominator != 1 && denominator != 2 && denominator != 4 && denominator != 8) {
        throw Error(ErrorKind::InvalidInput,
                    text("A JPEG can be reduced by 1, 2, 4 or 8 while decoding, not by ", denominator, "."));
    }
}

void start(jpeg_decompress_struct* info, int denominator) {
    info->out_color_space = JCS_RGB;
    info->dct_method = JDCT_ISLOW;
    info->do_fancy_upsampling = TRUE;
    // Smoothing guesses coefficients that a progressive file left out; the baseline copy could not know.
    info->do_block_smoothing = FALSE;
    info->scale_num = 1;
    info->scale_denom = static_cast<unsigned>(denominator);
    jpeg_start_decompress(info);
}

void readRows(jpeg_decompress_struct* info, RgbImage& picture) {
    constexpr int kRows = 16;
    JSAMPROW rows[kRows];
    while (info->output_scanline < info->output_height) {
        const int first = static_cast<int>(info->output_scanline);
        const int count = std::min(kRows, picture.height() - first);
        for (int i = 0; i < count; ++i) {
            rows[i] = picture.at(0, first + i);
        }
        jpeg_read_scanlines(info, rows, static_cast<JDIMENSION>(count));
    }
    // Reads on up to EOI, so that a file without its end is found out.
    jpeg_finish_decompress(info);
}

void writeRows(jpeg_compress_struct* info, const RgbImage& picture, int quality) {
    info->image_width = static_cast<JDIMENSION>(picture.width());
    info->image_height = static_cast<JDIMENSION>(picture.height());
    info->input_components = 3;
    info->in_color_space = JCS_RGB;
    jpeg_set_defaults(info);
    jpeg_set_quality(info, quality, TRUE);
    info->dct_method = JDCT_ISLOW;
    info->optimize_coding = TRUE;
    jpeg_start_compress(info, TRUE);
    while (info->next_scanline < info->image_height) {
        // libjpeg takes rows that are not const, and does not write to them.
        auto* row = const_cast<JSAMPROW>(picture.at(0, static_cast<int>(info->next_scanline)));
        jpeg_write_scanlines(info, &row, 1);
    }
    jpeg_finish_compress(info);
}

[[noreturn]] void failSegments(std::string_view source, std::string_view what) {
    throw Error(ErrorKind::Corrupt,
                text("Could not read ", source, ": ", what, "; fetch or copy the file again."));
}

bool hasNoContent(std::uint8_t marker) {
    constexpr std::uint8_t kTem = 0x01;
    return marker == kTem || (marker >= kRst0 && marker <= kRst7);
}

/// The segment at the offset, where fill bytes may come first.
Segment segmentAt(ByteView jpeg, std::size_t offset, std::string_view source) {
    if (offset < jpeg.size() && jpeg[offset] != 0xFF) {
        failSegments(source, text("a marker was expected at byte ", offset));
    }
    while (offset + 1 < jpeg.size() && jpeg[offset + 1] == 0xFF) {
        ++offset;
    }
    if (offset + 1 >= jpeg.size()) {
        failSegments(source, "it ends within the JPEG header");
    }
    const std::uint8_t marker = jpeg[offset + 1];
    if (hasNoContent(marker)) {
        return {marker, offset, 2};
    }
    if (marker == 0x00 || marker == kSoi || marker == kEoi) {
        failSegments(source, text("there is no picture before byte ", offset));
    }
    const std::size_t left = jpeg.size() - offset;
    const std::size_t size = left < 4 ? 0 : 2 + (std::size_t{jpeg[offset + 2]} << 8 | jpeg[offset + 3]);
    if (size < 4 || size > left) {
        failSegments(source, text("the segment at byte ", offset, " is cut off or has an impossible length"));
    }
    return {marker, offset, size};
}

} // namespace

Info readInfo(ByteView jpeg, std::string_view source) {
    Decompressor decompressor(jpeg, text("read ", source));
    const jpeg_decompress_struct& header = *decompressor.get();
    Info info;
    info.width = static_cast<int>(header.image_width);
    info.height = static_cast<int>(header.image_height);
    info.components = header.num_components;
    // A scan of one component has MCUs of one block, whatever its sampling factors say.
    info.mcuWidth = DCTSIZE * (info.components == 1 ? 1 : header.max_h_samp_factor);
    info.mcuHeight = DCTSIZE * (info.components == 1 ? 1 : header.max_v_samp_factor);
    info.restartInterval = static_cast<int>(header.restart_interval);
    info.progressive = header.progressive_mode != 0;
    return info;
}

RgbImage decode(ByteView jpeg, std::string_view source, int denominator) {
    checkDenominator(denominator);
    Decompressor decompressor(jpeg, text("decode ", source));
    jpeg_decompress_struct* info = decompressor.get();
    decompressor.trap().guarded([&] { start(info, denominator); });
    RgbImage picture(static_cast<int>(info->output_width), static_cast<int>(info->output_height));
    decompressor.trap().guarded([&] { readRows(info, picture); });
    return picture;
}

RgbImage decodeAtLeast(ByteView jpeg, std::string_view source, int width) {
    const int all = readInfo(jpeg, source).width;
    int denominator = 1;
    while (denominator < 8 && all / (2 * denominator) >= width) {
        denominator *= 2;
    }
    return decode(jpeg, source, denominator);
}

Bytes encode(const RgbImage& picture, int quality) {
    if (picture.empty() || picture.width() > JPEG_MAX_DIMENSION || picture.height() > JPEG_MAX_DIMENSION ||
        quality < 1 || quality > 100) {
        throw Error(ErrorKind::InvalidInput,
                    text("A picture of ", picture.width(), " x ", picture.height(),
                         " pixels cannot be written as a JPEG of quality ", quality, ": sides of 1 to ",
                         JPEG_MAX_DIMENSION, " and qualities of 1 to 100 can."));
    }
    Compressor compressor("encode a picture");
    compressor.trap().guarded([&] { writeRows(compressor.get(), picture, quality); });
    return std::move(compressor.bytes());
}

std::vector<Segment> segments(ByteView jpeg, std::string_view source) {
    if (jpeg.size() < 2 || jpeg[0] != 0xFF || jpeg[1] != kSoi) {
        failSegments(source, "it is not a JPEG");
    }
    std::vector<Segment> found;
    std::size_t offset = 2;
    do {
        found.push_back(segmentAt(jpeg, offset, source));
        offset = found.back().offset + found.back().size;
    } while (found.back().marker != kSos);
    return found;
}

} // namespace spherewalk::jpeg
