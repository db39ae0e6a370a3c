// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::practice {

/// Writes a TIFF structure front to back. Offsets are counted from its first byte. Source: TIFF 6.0.
class TiffWriter {
  public:
    enum class Order { Big, Little };

    struct Entry {
        std::uint16_t tag;
        std::uint16_t type;
        std::uint32_t count;
        Bytes value; ///< In the byte order of the file.
    };

    /// The place of a written directory.
    struct Place {
        std::uint32_t offset = 0;
        std::uint32_t nextOffset = 0; ///< Place of the link to the next directory.
        std::vector<std::pair<std::uint16_t, std::uint32_t>> entries;

        /// Place of the entry with this tag.
        std::uint32_t entry(std::uint16_t tag) const;
    };

    explicit TiffWriter(Order order);

    Entry ascii(std::uint16_t tag, std::string_view text) const;
    Entry undefined(std::uint16_t tag, std::string_view bytes) const;
    Entry shorts(std::uint16_t tag, std::initializer_list<int> values) const;
    Entry longs(std::uint16_t tag, std::initializer_list<std::uint32_t> values) const;
    Entry rationals(std::uint16_t tag,
                    std::initializer_list<std::pair<std::int64_t, std::int64_t>> values) const;
    Entry signedRationals(std::uint16_t tag,
                          std::initializer_list<std::pair<std::int64_t, std::int64_t>> values) const;

    /// Appends a directory, and behind it the values that do not fit into their entries. entries: by rising
    /// tag.
    Place directory(const std::vector<Entry>& entries);
    /// Appends bytes and returns their place.
    std::uint32_t append(ByteView bytes);
    /// Overwrites a number, for offsets that become known later.
    void patchLong(std::uint32_t offset, std::uint32_t value);

    std::uint32_t size() const { return static_cast<std::uint32_t>(m_bytes.size()); }

    const Bytes& bytes() const { return m_bytes; }

  private:
    void put(Bytes& to, std::uint64_t value, int size) const;

    Order m_order;
    Bytes m_bytes;
};

} // namespace spherewalk::practice
