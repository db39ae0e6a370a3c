// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
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

inline std::string piece(char* text) { // what strerror gives
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

/// The pieces one after the other; numbers are written independently of the locale.
template <class... Pieces>
std::string text(const Pieces&... pieces) {
    return (std::string() + ... + detail::piece(pieces));
}

/// The number with this many digits behind the point, whatever the locale: fixed(1.5, 2) is "1.50".
std::string fixed(double number, int digits);

/// The number that the whole of the text spells, in the C locale; nothing for anything else, NaN, or
/// infinity.
std::optional<double> parseNumber(std::string_view text);

/// The number that so many decimal digits spell from a place of the text on; -1 if there are other characters
/// among them. Range: begin within the text, count up to 9.
int digitsAt(std::string_view text, std::size_t begin, std::size_t count);

/// A moment as ISO 8601 in UTC with milliseconds: "2026-01-02T03:04:05.678Z".
std::string isoUtc(std::chrono::system_clock::time_point moment);

/// The moment that text written by isoUtc() spells; nothing for any other text.
std::optional<std::chrono::system_clock::time_point> parseIsoUtc(std::string_view text);

/// A duration as people say it: "8 s", "3 min 20 s", "2 h 17 min".
std::string humanDuration(std::chrono::duration<double> duration);

/// A byte count as people say it: "512 bytes", "4.2 MB" (powers of ten).
std::string humanBytes(std::uint64_t sizeBytes);

/// The text with control characters and broken UTF-8 replaced and cut to a length that fits a sentence; use
/// it whenever a message quotes something that came from outside.
std::string printable(std::string_view foreign, std::size_t maxLength = 80);

} // namespace spherewalk
