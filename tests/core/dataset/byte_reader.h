// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace spherewalk::test {

/// Reads what bags and messages hold, with no code of theirs. It throws where bytes are missing.
class ByteReader {
  public:
    explicit ByteReader(ByteView bytes) : m_bytes(bytes) {}

    std::size_t at() const { return m_at; }

    void moveTo(std::size_t at) { m_at = at; }

    bool atEnd() const { return m_at == m_bytes.size(); }

    ByteView take(std::size_t count) {
        if (count > m_bytes.size() - m_at) {
            throw std::runtime_error("bytes end at " + std::to_string(m_at));
        }
        m_at += count;
        return m_bytes.subspan(m_at - count, count);
    }

    /// Little-endian, one byte after the other.
    std::uint64_t number(std::size_t bytes) {
        std::uint64_t value = 0;
        const ByteView from = take(bytes);
        for (std::size_t i = 0; i < bytes; ++i) {
            value |= std::uint64_t{from[i]} << 8 * i;
        }
        return value;
    }

    double real() {
        const std::uint64_t bits = number(8);
        double value;
        std::memcpy(&value, &bits, 8);
        return value;
    }

    /// Text or bytes behind their length of four bytes.
    std::string sized() { return std::string(textOf(take(number(4)))); }

    ByteView all() const { return m_bytes; }

  private:
    ByteView m_bytes;
    std::size_t m_at = 0;
};

/// The checksum of ISO 3309, bit by bit.
inline std::uint32_t crc32(ByteView bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = crc >> 1 ^ (0xedb88320 & (0 - (crc & 1)));
        }
    }
    return ~crc;
}

} // namespace spherewalk::test
