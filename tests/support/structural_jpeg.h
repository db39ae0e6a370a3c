// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace spherewalk::test {

/// A JPEG by its segments, with a thumbnail in its Exif segment, a stuffed 0xff, a restart marker and fill
/// bytes; its coded data decode to nothing.
inline std::string structuralJpeg(int width, int height, const std::string& coded = "coded") {
    const auto number = [](int value) {
        return std::string{static_cast<char>(value >> 8), static_cast<char>(value & 255)};
    };
    const auto segment = [&](char code, const std::string& content) {
        return std::string("\xff") + code + number(static_cast<int>(content.size()) + 2) + content;
    };
    const std::string thumbnail = "\xff\xd8\xff\xda tiny \xff\xd9";
    const std::string sizes = std::string(1, '\x08') + number(height) + number(width) + '\x03';
    return "\xff\xd8" + segment('\xe1', thumbnail) + segment('\xdb', "table") + "\xff" +
           segment('\xc0', sizes) + segment('\xda', "scan") + coded + std::string("\xff\0", 2) +
           "more\xff\xd3" + coded + "\xff\xd9";
}

} // namespace spherewalk::test
