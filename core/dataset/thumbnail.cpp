// SPDX-License-Identifier: GPL-3.0-or-later
#include "thumbnail.h"

#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"

namespace spherewalk::dataset {

Bytes thumbnail(ByteView jpegBytes, std::string_view source, int width) {
    constexpr int kQuality = 85;
    const jpeg::Info info = jpeg::readInfo(jpegBytes, source);
    int denominator = 8;
    while (denominator > 1 && info.width / denominator < width) {
        denominator /= 2;
    }
    const RgbImage picture = jpeg::decode(jpegBytes, source, denominator);
    if (picture.width() <= width) {
        return jpeg::encode(picture, kQuality);
    }
    return jpeg::encode(photo::resized(picture, width, width / 2), kQuality);
}

} // namespace spherewalk::dataset
