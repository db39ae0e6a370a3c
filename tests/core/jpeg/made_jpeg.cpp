// SPDX-License-Identifier: Apache-2.0
#include "made_jpeg.h"

#include "random.h"

#include <jpeglib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace spherewalk::test {

namespace {

jpeg_scan_info scanOf(int colour, int first, int last, int high, int low) {
    jpeg_scan_info scan{};
    scan.comps_in_scan = 1;
    scan.component_index[0] = colour;
    scan.Ss = first;
    scan.Se = last;
    scan.Ah = high;
    scan.Al = low;
    return scan;
}

void setScans(jpeg_compress_struct& info, const std::vector<jpeg_scan_info>& scans) {
    info.scan_info = scans.data();
    info.num_scans = static_cast<int>(scans.size());
}

void setForm(jpeg_compress_struct& info, const JpegForm& form, std::vector<jpeg_scan_info>& scans) {
    jpeg_set_defaults(&info);
    jpeg_set_colorspace(&info, form.isGrey ? JCS_GRAYSCALE : JCS_YCbCr);
    jpeg_set_quality(&info, form.quality, TRUE);
    info.comp_info[0].h_samp_factor = form.isGrey ? 1 : form.horizontal;
    info.comp_info[0].v_samp_factor = form.isGrey ? 1 : form.vertical;
    info.write_JFIF_header = form.hasJfif ? TRUE : FALSE;
    info.restart_interval = static_cast<unsigned>(form.restartInterval);
    if (form.isProgressive) {
        jpeg_simple_progression(&info);
    } else if (form.hasScanPerColour) {
        for (int colour = 0; colour < 3; ++colour) {
            scans.push_back(scanOf(colour, 0, 63, 0, 0));
        }
        setScans(info, scans);
    } else if (form.hasHundredsOfScans) {
        constexpr int kBits = 4;
        scans.push_back(scanOf(0, 0, 0, 0, 0));
        for (int coefficient = 1; coefficient < 64; ++coefficient) {
            for (int bit = kBits; bit >= 0; --bit) {
                scans.push_back(scanOf(0, coefficient, coefficient, bit == kBits ? 0 : bit + 1, bit));
            }
        }
        setScans(info, scans);
    }
}

} // namespace

std::ostream& operator<<(std::ostream& out, const JpegForm& form) {
    return out << form.name;
}

Bytes madeJpeg(const RgbImage& picture, const JpegForm& form) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    std::vector<jpeg_scan_info> scans;
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &buffer, &size);
    info.image_width = static_cast<JDIMENSION>(picture.width());
    info.image_height = static_cast<JDIMENSION>(picture.height());
    info.input_components = 3;
    info.in_color_space = JCS_RGB;
    setForm(info, form, scans);
    jpeg_start_compress(&info, TRUE);
    for (const Bytes& content : form.applications) {
        jpeg_write_marker(&info, JPEG_APP0 + 1, content.data(), static_cast<unsigned>(content.size()));
    }
    for (int y = 0; y < picture.height(); ++y) {
        auto* row = const_cast<JSAMPROW>(picture.at(0, y));
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    Bytes bytes(buffer, buffer + size);
    std::free(buffer);
    return bytes;
}

RgbImage madePicture(int width, int height, unsigned seed) {
    Random random(seed);
    RgbImage picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const double wave = std::sin(0.13 * (c + 1) * x) * std::cos(0.09 * y + c);
                const double value = 128 + 90 * wave + random.normal(6);
                picture.at(x, y)[c] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
            }
        }
    }
    return picture;
}

} // namespace spherewalk::test
