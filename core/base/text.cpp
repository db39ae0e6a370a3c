// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>

namespace spherewalk {

namespace {

/// The length of the well-formed UTF-8 sequence at the start of the text; 0 if there is none.
std::size_t utf8Length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    const std::size_t length = lead < 0x80       ? 1
                               : lead >> 5 == 6  ? 2
                               : lead >> 4 == 14 ? 3
                               : lead >> 3 == 30 ? 4
                                                 : 0;
    if (length > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if (byte(i) >> 6 != 2) {
            return 0;
        }
    }
    return length;
}

} // namespace

#ifdef __cpp_lib_to_chars

std::string detail::piece(double number) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return {buffer.data(), end};
}

std::string fixed(double number, int digits) {
    std::array<char, 400> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::fixed, digits)
            .ptr;
    return {buffer.data(), end};
}

namespace {

/// The number that is the whole text; infinity if there is none.
double wholeNumber(std::string_view text) {
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    return failure == std::errc() && end == text.data() + text.size() ? number : HUGE_VAL;
}

} // namespace

#else // GCC 10 has these functions for whole numbers only. Streams are slower, and may obey no locale either.

namespace {

double wholeNumber(std::string_view text) {
    std::istringstream in{std::string(text)};
    in.imbue(std::locale::classic());
    double number = 0;
    in >> std::noskipws >> number;
    return !in.fail() && in.peek() == std::istringstream::traits_type::eof() && text.front() != '+'
               ? number
               : HUGE_VAL;
}

} // namespace

std::string fixed(double number, int digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << std::fixed << number;
    return out.str();
}

/// The fewest digits that give the number back, as to_chars has them: without an exponent unless that is
/// shorter.
std::string detail::piece(double number) {
    std::string words;
    int decimals = 0; // with an exponent
    for (; decimals < std::numeric_limits<double>::max_digits10; ++decimals) {
        std::ostringstream out;
        out.imbue(std::locale::classic());
        out.precision(decimals);
        out << std::scientific << number;
        words = out.str();
        if (wholeNumber(words) == number) {
            break;
        }
    }
    const std::size_t e = words.find('e');
    if (e == std::string::npos) { // no finite number
        return words;
    }
    const int exponent = std::stoi(words.substr(e + 1));
    std::string plain = fixed(number, std::max(0, decimals - exponent));
    return plain.size() <= words.size() ? plain : words;
}

#endif

int digitsAt(std::string_view text, std::size_t begin, std::size_t count) {
    int number = 0;
    for (const char c : text.substr(begin, count)) {
        if (c < '0' || c > '9') {
            return -1;
        }
        number = 10 * number + (c - '0');
    }
    return number;
}

std::optional<double> parseNumber(std::string_view text) {
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
    }
    const double number = wholeNumber(text);
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string humanBytes(std::uint64_t sizeBytes) {
    if (sizeBytes < 1000) {
        return text(sizeBytes, " bytes");
    }
    constexpr std::array kUnits{"kB", "MB", "GB", "TB", "PB", "EB"};
    double size = static_cast<double>(sizeBytes) / 1000;
    std::size_t unit = 0;
    while (size >= 999.95 && unit + 1 < kUnits.size()) {
        size /= 1000;
        ++unit;
    }
    return text(fixed(size, 1), " ", kUnits[unit]);
}

std::string printable(std::string_view foreign, std::size_t maxLength) {
    std::string result;
    while (!foreign.empty()) {
        const std::size_t length = utf8Length(foreign);
        if (result.size() + std::max<std::size_t>(length, 1) > maxLength) {
            return result + "...";
        }
        const auto first = static_cast<unsigned char>(foreign.front());
        const bool shows = length > 1 || (length == 1 && first >= 0x20 && first != 0x7f);
        result += shows ? std::string(foreign.substr(0, length)) : "?";
        foreign.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

} // namespace spherewalk
