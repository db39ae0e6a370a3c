// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace spherewalk {

/// Collects bytes one after the other. Numbers are little-endian.
class ByteWriter {
  public:
    template <class Number>
    void number(Number value) {
        static_assert(std::is_arithmetic_v<Number>);
        auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof(Number)>>(value);
        if constexpr (std::endian::native == std::endian::big) {
            std::reverse(bytes.begin(), bytes.end());
        }
        put(bytes);
    }

    /// Puts the numbers of a range, one after the other.
    template <class Range>
    void numbers(const Range& values) {
        for (const auto value : values) {
            number(value);
        }
    }

    void put(ByteView bytes) { m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end()); }

    /// Puts zeros until the distance from `origin` is a multiple of `size`.
    void alignFrom(std::size_t origin, std::size_t size) {
        m_bytes.resize(origin + (m_bytes.size() - origin + size - 1) / size * size);
    }

    std::size_t size() const { return m_bytes.size(); }

    ByteView view() const { return m_bytes; }

    Bytes take() { return std::exchange(m_bytes, {}); }

  private:
    Bytes m_bytes;
};

} // namespace spherewalk
