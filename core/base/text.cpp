// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <ctime>

namespace spherewalk {

namespace {

std::string padded(long long number, std::size_t width) {
    std::string digits = std::to_string(number);
    return digits.size() < width ? std::string(width - digits.size(), '0') + digits : digits;
}

/// Length of the well-formed UTF-8 sequence at the start of the text; 0 if there is none.
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
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) {
        return std::nullopt;
    }
    return number;
}

std::string isoUtc(std::chrono::system_clock::time_point moment) {
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(moment);
    const auto day = std::chrono::floor<std::chrono::days>(milliseconds);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss time(milliseconds - day);
    return padded(int(date.year()), 4) + "-" + padded(unsigned(date.month()), 2) + "-" +
           padded(unsigned(date.day()), 2) + "T" + padded(time.hours().count(), 2) + ":" +
           padded(time.minutes().count(), 2) + ":" + padded(time.seconds().count(), 2) + "." +
           padded(time.subseconds().count(), 3) + "Z";
}

std::optional<std::chrono::system_clock::time_point> parseIsoUtc(std::string_view text) {
    constexpr std::string_view kShape = "0000-00-00T00:00:00.000Z";
    if (text.size() != kShape.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < kShape.size(); ++i) {
        const bool isDigit = text[i] >= '0' && text[i] <= '9';
        if (kShape[i] == '0' ? !isDigit : text[i] != kShape[i]) {
            return std::nullopt;
        }
    }
    const auto number = [&](std::size_t at, std::size_t count) { return digitsAt(text, at, count); };
    const std::chrono::year_month_day date(std::chrono::year(number(0, 4)),
                                           std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                           std::chrono::day(static_cast<unsigned>(number(8, 2))));
    // The clock's nanoseconds end in 2262.
    if (!date.ok() || date.year() < std::chrono::year(1700) || date.year() > std::chrono::year(2260) ||
        number(11, 2) > 23 || number(14, 2) > 59 || number(17, 2) > 59) {
        return std::nullopt;
    }
    return std::chrono::sys_days(date) + std::chrono::hours(number(11, 2)) +
           std::chrono::minutes(number(14, 2)) + std::chrono::seconds(number(17, 2)) +
           std::chrono::milliseconds(number(20, 3));
}

std::string humanDuration(std::chrono::duration<double> duration) {
    const long long seconds = std::llround(std::max(0.0, duration.count()));
    if (seconds < 60) {
        return text(seconds, " s");
    }
    if (seconds < 3600) {
        return text(seconds / 60, " min ", seconds % 60, " s");
    }
    return text(seconds / 3600, " h ", seconds / 60 % 60, " min");
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
