// SPDX-License-Identifier: GPL-3.0-or-later
// Input: which part of a photo's header, and its bytes: the Exif block with the maker note, the XMP packet,
// or the whole file. Whatever they say, they are read as far as they make sense, or refused.
#include "spherewalk/base/error.h"
#include "spherewalk/photo/metadata.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

using namespace spherewalk;

namespace {

using namespace std::string_view_literals;

/// SOI, this APP1, and the frame and scan headers of a picture of 8 x 4 grey pixels, which nobody decodes.
Bytes fileWith(std::string_view signature, ByteView content) {
    constexpr std::string_view kRest = "\xFF\xC0\x00\x0B\x08\x00\x04\x00\x08\x01\x01\x11\x00"
                                       "\xFF\xDA\x00\x08\x01\x01\x00\x00\x3F\x00\x00\xFF\xD9"sv;
    content = content.first(std::min<std::size_t>(content.size(), 65533 - signature.size()));
    const std::size_t length = 2 + signature.size() + content.size();
    Bytes file{
        0xFF, 0xD8, 0xFF, 0xE1, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length)};
    file.insert(file.end(), signature.begin(), signature.end());
    file.insert(file.end(), content.begin(), content.end());
    file.insert(file.end(), kRest.begin(), kRest.end());
    return file;
}

void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void checkRanges(const photo::PhotoMetadata& metadata) {
    require(!metadata.exposureS || (std::isfinite(*metadata.exposureS) && *metadata.exposureS > 0));
    require(!metadata.iso || *metadata.iso >= 0);
    if (metadata.theta && metadata.theta->zenith) {
        require(metadata.theta->zenith->allFinite());
    }
    if (metadata.panorama && metadata.panorama->heading) {
        const double heading = metadata.panorama->heading->value();
        require(heading >= 0 && heading < 360);
    }
    if (const auto level = photo::levelFromPhoto(metadata)) {
        require(std::abs(level->norm() - 1) < 1e-9);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 1) {
        return 0;
    }
    const ByteView content(data + 1, size - 1);
    Bytes file(content.begin(), content.end());
    if (data[0] % 4 < 2) {
        file = fileWith("Exif\0\0"sv, content);
    } else if (data[0] % 4 == 2) {
        file = fileWith("http://ns.adobe.com/xap/1.0/\0"sv, content);
    }
    try {
        checkRanges(photo::readMetadata(file, "the photo"));
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::Corrupt || error.kind() == ErrorKind::Unsupported);
    }
    return 0;
}
