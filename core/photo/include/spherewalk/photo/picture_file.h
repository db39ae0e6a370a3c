// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace spherewalk::photo {

/// The picture in a PNG or JPEG file, as 8-bit RGB; transparency is dropped, and an orientation tag is not
/// applied. Errors: NotFound, Io; Corrupt for a damaged file; Unsupported for any other format and for more
/// than 2^28 pixels.
RgbImage readPicture(const std::filesystem::path& file);

/// The values of a PNG with one channel of 16 bits, as depths and labels have. Errors: as readPicture();
/// Unsupported for any other PNG.
Image<std::uint16_t, 1> readPng16(const std::filesystem::path& file);

/// The distances in a PNG of 16 bits that holds millimetres, in metres; +infinity where it holds 0. Errors:
/// as readPng16().
DepthImage readDepthPng(const std::filesystem::path& file);

/// Writes a PNG, durably; a file of that name is replaced. Errors: InvalidInput for an empty picture; Io,
/// Full.
void writePng(const std::filesystem::path& file, const RgbImage& picture);

/// The same as a PNG of 16 bits, which readPng16() reads.
void writePng(const std::filesystem::path& file, const Image<std::uint16_t, 1>& picture);

/// The picture at another size: each pixel is the average of the area that it covers; enlarging interpolates.
/// Range: sizes of 1 to 65535. Errors: InvalidInput.
RgbImage resized(const RgbImage& picture, int width, int height);

/// All pictures side by side, row after row, each reduced to the cell's width at its own aspect ratio, on
/// dark grey. captions: one a picture, written below it in ASCII, or none at all. Errors: InvalidInput for no
/// pictures, an empty one, or captions of another count.
RgbImage contactSheet(std::span<const RgbImage> pictures, int columns, int cellWidth,
                      std::span<const std::string> captions = {});

/// Peak signal-to-noise ratio over all three channels, in dB; infinity for equal pictures.
/// Errors: InvalidInput if the sizes differ or are empty.
double psnr(const RgbImage& a, const RgbImage& b);

} // namespace spherewalk::photo
