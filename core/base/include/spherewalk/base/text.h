// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk {

namespace detail {
inline std::string piece(std::string_view text) {
    return std::string(text);
}

inline std::string piece(const char* text) {
    return text;
}

inline std::string piece(char* text) { // strerror returns this type
    return text;
}

inline std::string piece(const std::string& text) {
    return text;
}

template <class Number>
std::string piece(Number number) {
    return std::to_string(number);
}

/// The shortest decimal that reads back as the same number, whatever the locale.
std::string piece(double number);

inline std::string piece(float number) {
    return piece(static_cast<double>(number));
}
} // namespace detail

/// The pieces joined without separators. Numbers are written independently of the locale.
template <class... Pieces>
std::string text(const Pieces&... pieces) {
    return (std::string() + ... + detail::piece(pieces));
}

/// A count with its noun, in the singular or the plural: "1 photo was", "2 photos were".
template <class Count>
std::string counted(Count count, std::string_view one, std::string_view many) {
    return text(count, " ", count == 1 ? one : many);
}

/// The number with this many digits after the point, whatever the locale: fixed(1.5, 2) is "1.50".
std::string fixed(double number, int digits);

/// The finite number that the whole text spells in the C locale. Any other text gives nothing.
std::optional<double> parseNumber(std::string_view text);

/// The number that `count` decimal digits spell, from index `begin` of the text on. The result is -1 if one
/// of these characters is no digit. Range: begin within the text, count up to 9.
int digitsAt(std::string_view text, std::size_t begin, std::size_t count);

/// A byte count as people say it: "512 bytes", "4.2 MB" (powers of ten).
std::string humanBytes(std::uint64_t sizeBytes);

/// A text from outside, fit to be quoted in a message. Control characters and broken UTF-8 become "?", and
/// "..." ends a text that is longer than maxLength bytes.
std::string printable(std::string_view foreign, std::size_t maxLength = 80);

} // namespace spherewalk
