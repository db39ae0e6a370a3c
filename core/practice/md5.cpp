// SPDX-License-Identifier: GPL-3.0-or-later
#include "md5.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace spherewalk::practice {

namespace {

constexpr std::size_t kBlock = 64;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    }
    return word;
}

/// The bytes, a one bit, zeros, and the length in bits, to whole blocks.
std::string padded(std::string_view text) {
    std::string bytes(text);
    bytes += '\x80';
    bytes.resize((bytes.size() + 8 + kBlock - 1) / kBlock * kBlock - 8, '\0');
    const std::uint64_t bits = 8 * std::uint64_t{text.size()};
    for (int i = 0; i < 8; ++i) {
        bytes += static_cast<char>(bits >> (8 * i) & 0xff);
    }
    return bytes;
}

using State = std::array<std::uint32_t, 4>;

State afterBlock(const State& before, std::string_view block) {
    constexpr std::array<std::array<int, 4>, 4> kTurns{
        {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}}};
    auto [a, b, c, d] = before;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const std::uint32_t round = i / 16;
        const std::uint32_t mixed = round == 0   ? (b & c) | (~b & d)
                                    : round == 1 ? (d & b) | (~d & c)
                                    : round == 2 ? b ^ c ^ d
                                                 : c ^ (b | ~d);
        const std::array<std::uint32_t, 4> index{i, 5 * i + 1, 3 * i + 5, 7 * i};
        const auto constant =
            static_cast<std::uint32_t>(std::floor(std::abs(std::sin(i + 1.0)) * 4294967296.0));
        const std::uint32_t sum = a + mixed + constant + wordAt(block, 4 * (index[round] % 16));
        a = d;
        d = c;
        c = b;
        b += std::rotl(sum, kTurns[round][i % 4]);
    }
    return {before[0] + a, before[1] + b, before[2] + c, before[3] + d};
}

} // namespace

std::string md5Hex(std::string_view text) {
    State state{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
    const std::string bytes = padded(text);
    for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
        state = afterBlock(state, std::string_view(bytes).substr(at, kBlock));
    }
    std::string hex;
    for (const std::uint32_t word : state) {
        for (int i = 0; i < 4; ++i) {
            hex += "0123456789abcdef"[word >> (8 * i + 4) & 15];
            hex += "0123456789abcdef"[word >> (8 * i) & 15];
        }
    }
    return hex;
}

} // namespace spherewalk::practice
