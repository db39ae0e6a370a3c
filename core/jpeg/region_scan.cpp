// SPDX-License-Identifier: Apache-2.0
#include "region_scan.h"

#include "codec.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>

namespace spherewalk::jpeg {

namespace {

// What chroma upsampling may look at beyond the part, in pixels of the result.
constexpr int kReach = 2;
constexpr int kRows = 16;

/// Starts decoding, exactly as decode() does, of the columns that the part needs; the column that comes out
/// first is returned. Idle columns are entropy-decoded only.
int startColumns(jpeg_decompress_struct* info, const PixelRect& part, int denominator) {
    info->out_color_space = JCS_RGB;
    info->dct_method = JDCT_ISLOW;
    info->do_fancy_upsampling = TRUE;
    info->do_block_smoothing = FALSE;
    info->scale_num = 1;
    info->scale_denom = static_cast<unsigned>(denominator);
    jpeg_start_decompress(info);
    const int whole = static_cast<int>(info->output_width);
    if (denominator > 1) {
        // jpeg_crop_scanline() of libjpeg-turbo 2.1 forgets that reducing may leave chroma at another scale
        // (4 x 2 sampling at 1/2); and a reduced inverse DCT costs little.
        return 0;
    }
    // libjpeg upsamples pictures of one or two chroma samples in another way; more stay more.
    constexpr int kLeast = 4 * DCTSIZE;
    int left = std::max(0, part.x - kReach);
    const int right = std::min(whole, std::max(part.x + part.width + kReach, left + kLeast));
    left = std::max(0, std::min(left, right - kLeast));
    if (left > 0 || right < whole) {
        auto offset = static_cast<JDIMENSION>(left);
        auto width = static_cast<JDIMENSION>(right - left);
        jpeg_crop_scanline(info, &offset, &width);
        return static_cast<int>(offset);
    }
    return 0;
}

void startSamples(jpeg_decompress_struct* info) {
    info->raw_data_out = TRUE;
    info->dct_method = JDCT_ISLOW;
    info->do_block_smoothing = FALSE;
    jpeg_start_decompress(info);
}

/// Room for one row of MCUs as jpeg_read_raw_data() fills it.
class SampleRows {
  public:
    explicit SampleRows(const jpeg_decompress_struct& info) {
        for (int colour = 0; colour < info.num_components; ++colour) {
            const jpeg_component_info& component = info.comp_info[colour];
            const std::size_t width = std::size_t{component.width_in_blocks} * DCTSIZE;
            const int rows = component.v_samp_factor * DCTSIZE;
            Bytes& bytes = m_bytes[static_cast<std::size_t>(colour)];
            bytes.resize(width * static_cast<std::size_t>(rows));
            for (int row = 0; row < rows; ++row) {
                m_rows[static_cast<std::size_t>(colour)][static_cast<std::size_t>(row)] =
                    &bytes[width * static_cast<std::size_t>(row)];
            }
            m_planes[static_cast<std::size_t>(colour)] = m_rows[static_cast<std::size_t>(colour)].data();
        }
    }

    JSAMPIMAGE image() { return m_planes.data(); }

  private:
    std::array<Bytes, 3> m_bytes;
    std::array<std::array<JSAMPROW, 4 * DCTSIZE>, 3> m_rows{};
    std::array<JSAMPARRAY, 3> m_planes{};
};

void giveSamples(const jpeg_decompress_struct& info, SampleRows& rows, int top, const PixelRect& part,
                 const SampleSink& sink) {
    for (int colour = 0; colour < info.num_components; ++colour) {
        const jpeg_component_info& component = info.comp_info[colour];
        const int horizontal = info.max_h_samp_factor / component.h_samp_factor;
        const int vertical = info.max_v_samp_factor / component.v_samp_factor;
        const int first = part.y / vertical;
        const int end = (part.y + part.height + vertical - 1) / vertical;
        const int at = top / vertical;
        const int last = std::min(at + component.v_samp_factor * DCTSIZE, end);
        for (int y = std::max(first, at); y < last; ++y) {
            sink(colour, y - first, rows.image()[colour][y - at] + part.x / horizontal);
        }
    }
}

} // namespace

void scanRows(ByteView jpeg, const std::string& source, const PixelRect& part, int denominator,
              const RowSink& sink) {
    Decompressor decompressor(jpeg, text("decode a part of ", source));
    jpeg_decompress_struct* info = decompressor.get();
    int left = 0;
    decompressor.trap().guarded([&] { left = startColumns(info, part, denominator); });
    constexpr std::size_t kPixelBytes = 3;
    const std::size_t rowBytes = info->output_width * kPixelBytes;
    Bytes buffer(rowBytes * kRows);
    std::array<JSAMPROW, kRows> rows{};
    for (std::size_t i = 0; i < kRows; ++i) {
        rows[i] = &buffer[i * rowBytes];
    }
    const std::size_t skipped = static_cast<std::size_t>(part.x - left) * kPixelBytes;
    const int end = part.y + part.height;
    for (int y = 0; y < end;) {
        JDIMENSION got = 0;
        decompressor.trap().guarded([&] {
            got = jpeg_read_scanlines(info, rows.data(), static_cast<JDIMENSION>(std::min(kRows, end - y)));
        });
        for (JDIMENSION i = 0; i < got; ++i, ++y) {
            if (y >= part.y) {
                sink(y - part.y, rows[i] + skipped);
            }
        }
    }
}

void scanSamples(ByteView jpeg, const std::string& source, const PixelRect& part, const SampleSink& sink) {
    Decompressor decompressor(jpeg, text("decode a part of ", source));
    jpeg_decompress_struct* info = decompressor.get();
    decompressor.trap().guarded([&] { startSamples(info); });
    SampleRows rows(*info);
    const int mcuHeight = DCTSIZE * (info->num_components == 1 ? 1 : info->max_v_samp_factor);
    for (int top = 0; top < part.y + part.height; top += mcuHeight) {
        decompressor.trap().guarded(
            [&] { jpeg_read_raw_data(info, rows.image(), static_cast<JDIMENSION>(4 * DCTSIZE)); });
        giveSamples(*info, rows, top, part, sink);
    }
}

} // namespace spherewalk::jpeg
