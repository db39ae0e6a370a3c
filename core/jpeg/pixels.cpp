// SPDX-License-Identifier: Apache-2.0
#include "codec.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace spherewalk::jpeg {

namespace {

/// Which minimum coded units hold a place, row by row.
struct UnitsToReplace {
    UnitsToReplace(const jpeg_decompress_struct& info, const MaskImage& where)
        : columns((where.width() + kBlock * info.max_h_samp_factor - 1) / (kBlock * info.max_h_samp_factor)),
          rows((where.height() + kBlock * info.max_v_samp_factor - 1) / (kBlock * info.max_v_samp_factor)),
          replaced(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
        const int unitWidth = kBlock * info.max_h_samp_factor;
        const int unitHeight = kBlock * info.max_v_samp_factor;
        for (int y = 0; y < where.height(); ++y) {
            for (int x = 0; x < where.width(); ++x) {
                if (*where.at(x, y) != 0) {
                    replaced[index(x / unitWidth, y / unitHeight)] = 1;
                }
            }
        }
    }

    static constexpr int kBlock = 8;

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }

    int columns;
    int rows;
    std::vector<std::uint8_t> replaced;
};

/// Writes all pixels with the source's tables and sampling.
void encodeLike(jpeg_decompress_struct* source, const RgbImage& picture, jpeg_compress_struct* to) {
    jpeg_copy_critical_parameters(source, to);
    to->in_color_space = JCS_RGB;
    to->input_components = RgbImage::kChannels;
    jpeg_start_compress(to, TRUE);
    while (to->next_scanline < to->image_height) {
        auto* row = const_cast<JSAMPLE*>(picture.at(0, static_cast<int>(to->next_scanline)));
        jpeg_write_scanlines(to, &row, 1);
    }
    jpeg_finish_compress(to);
}

/// Copies the coefficients of a component's blocks in the units to replace.
void copyBlocks(jpeg_decompress_struct* from, jvirt_barray_ptr source, jpeg_decompress_struct* to,
                jvirt_barray_ptr target, const jpeg_component_info& component, const UnitsToReplace& units) {
    const auto blocks = static_cast<int>(component.width_in_blocks);
    for (JDIMENSION line = 0; line < component.height_in_blocks; ++line) {
        auto* fromLibrary = reinterpret_cast<j_common_ptr>(from);
        auto* toLibrary = reinterpret_cast<j_common_ptr>(to);
        JBLOCKROW in = from->mem->access_virt_barray(fromLibrary, source, line, 1, FALSE)[0];
        JBLOCKROW out = to->mem->access_virt_barray(toLibrary, target, line, 1, TRUE)[0];
        for (int block = 0; block < blocks; ++block) {
            const std::size_t unit = units.index(block / component.h_samp_factor,
                                                 static_cast<int>(line) / component.v_samp_factor);
            if (units.replaced[unit] != 0) {
                std::copy_n(in[block], DCTSIZE2, out[block]);
            }
        }
    }
}

} // namespace

Bytes withPixels(ByteView jpeg, const RgbImage& picture, const MaskImage& where, std::string_view source) {
    const std::string tried = text("replace a part of ", source);
    Decompressor original(jpeg, tried, Decompressor::Keep::AllMarkers);
    const jpeg_decompress_struct& info = *original.get();
    const auto width = static_cast<int>(info.image_width);
    const auto height = static_cast<int>(info.image_height);
    if (picture.width() != width || picture.height() != height || where.width() != width ||
        where.height() != height) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not ", tried, ": its size is ", width, " x ", height,
                         ", and that of the new pixels is ", picture.width(), " x ", picture.height(), "."));
    }
    if (info.num_components != RgbImage::kChannels) {
        throw Error(ErrorKind::Unsupported,
                    text("Could not ", tried, ": it is grey, and colours cannot be put into it."));
    }
    jvirt_barray_ptr* coefficients = nullptr;
    original.trap().guarded([&] { coefficients = jpeg_read_coefficients(original.get()); });
    const UnitsToReplace units(info, where);

    Compressor likeOriginal(tried);
    likeOriginal.trap().guarded([&] { encodeLike(original.get(), picture, likeOriginal.get()); });
    Decompressor replacement(likeOriginal.bytes(), tried);
    replacement.trap().guarded([&] {
        jvirt_barray_ptr* blocks = jpeg_read_coefficients(replacement.get());
        for (int i = 0; i < info.num_components; ++i) {
            copyBlocks(replacement.get(), blocks[i], original.get(), coefficients[i], info.comp_info[i],
                       units);
        }
    });

    Compressor result(tried);
    // Both report into one trap: a jump has one place to land in.
    result.get()->err = original.trap().manager();
    result.get()->client_data = &original.trap();
    const auto interval = static_cast<int>(info.restart_interval);
    original.trap().guarded([&] { writeCoefficients(original.get(), coefficients, result.get(), interval); });
    return std::move(result.bytes());
}

} // namespace spherewalk::jpeg
