// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace spherewalk::test {

/// An entry of a TIFF directory that is being written.
struct TiffField {
    std::uint16_t tag = 0;
    std::uint16_t type = 0;
    std::uint32_t count = 0;
    std::vector<std::uint32_t> numbers = {}; ///< a rational is two of them
    std::string text = {};
};

TiffField shortField(std::uint16_t tag, std::uint16_t value);
TiffField longField(std::uint16_t tag, std::uint32_t value);
TiffField asciiField(std::uint16_t tag, const std::string& text);
/// Numerators and denominators in turn.
TiffField rationalField(std::uint16_t tag, const std::vector<std::int64_t>& parts, bool isSigned = true);

/// How the Exif block of a Theta is laid out, and what is in it.
struct ExifForm {
    bool isBigEndian = false;
    bool isThetaInside = true; ///< the Theta directory lies within the maker note's bytes
    std::string model = "RICOH THETA V";
    std::uint16_t orientation = 1;
    std::vector<TiffField> theta = {};
};

/// The fields of a levelled Theta V: image type 1, level, zone +09:00, zenith, temperatures.
std::vector<TiffField> thetaFields();

/// An Exif block, from its TIFF header on, with the places that a test may want to damage.
struct MadeExif {
    Bytes tiff;
    bool isBigEndian = false;
    std::size_t exifDirectory = 0;
    std::size_t makerNote = 0;
    std::size_t ricohDirectory = 0;
    std::size_t thetaDirectory = 0;

    /// Where the 4 bytes of value or offset of the n-th entry of a directory stand.
    static std::size_t valueAt(std::size_t directory, std::size_t n) { return directory + 2 + 12 * n + 8; }

    void setLong(std::size_t at, std::uint32_t value);
    void setShort(std::size_t at, std::uint16_t value);
};

MadeExif madeExif(const ExifForm& form);

/// A GPano packet as a Theta writes it, with this text in the middle of its properties.
std::string gpanoXmp(const std::string& properties);
/// Pitch and roll as properties for gpanoXmp.
std::string poseXmp(const std::string& pitch, const std::string& roll);

/// A small spherical JPEG with these segments in front; an empty one is left out.
Bytes madePhoto(ByteView tiff, const std::string& xmp, int width = 64, int height = 32);
Bytes madePhoto(const MadeExif& exif, const std::string& xmp);

/// An APPn segment.
Bytes segment(std::uint8_t marker, std::string_view signature, ByteView content);

} // namespace spherewalk::test
