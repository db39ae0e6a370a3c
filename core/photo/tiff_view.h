// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::photo {

/// One entry of a TIFF directory whose value lies within the bytes.
struct TiffEntry {
    std::uint16_t tag = 0;
    std::uint16_t type = 0;
    std::uint32_t count = 0;
    std::size_t offset = 0; ///< of the value, from the TIFF header
    std::size_t size = 0;   ///< of the value in bytes
};

/// Reads directories and values of a TIFF in memory, of either byte order. Nothing outside of the bytes is
/// ever touched, and nothing is followed but what the caller asks for. Owner: the bytes must outlive it.
/// Source: TIFF 6.0, section 2.
class TiffView {
  public:
    /// Nothing if the bytes do not begin with a TIFF header.
    static std::optional<TiffView> of(ByteView tiff);

    /// Where the first directory is said to be.
    std::size_t firstDirectory() const;
    /// The entries of the directory at the offset that can be used: known type, value within the bytes. None
    /// if the directory is cut off or has more than 512.
    std::vector<TiffEntry> directory(std::size_t offset) const;

    ByteView bytes(const TiffEntry& entry) const { return m_tiff.subspan(entry.offset, entry.size); }

    /// The first `count` numbers of an integer or rational entry; nothing if it has fewer, is of another
    /// type, or one has the denominator 0.
    std::optional<std::vector<double>> numbers(const TiffEntry& entry, std::size_t count) const;
    /// The text of an ASCII entry up to its first NUL, trimmed and printable; empty for another type.
    std::string text(const TiffEntry& entry) const;

  private:
    TiffView(ByteView tiff, bool isBigEndian) : m_tiff(tiff), m_isBigEndian(isBigEndian) {}

    /// Range: offset + size within the bytes.
    std::uint32_t number(std::size_t offset, std::size_t size) const;
    std::optional<double> value(const TiffEntry& entry, std::size_t index) const;

    ByteView m_tiff;
    bool m_isBigEndian;
};

/// The entry with this tag, or null.
const TiffEntry* find(const std::vector<TiffEntry>& directory, std::uint16_t tag);

} // namespace spherewalk::photo
