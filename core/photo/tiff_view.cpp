// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiff_view.h"

#include "plain_text.h"

#include <algorithm>

namespace spherewalk::photo {

namespace {

constexpr std::size_t kMaxEntries = 512;
constexpr std::size_t kEntryBytes = 12;

enum Type : std::uint16_t {
    kByte = 1,
    kAscii = 2,
    kShort = 3,
    kLong = 4,
    kRational = 5,
    kSignedByte = 6,
    kUndefined = 7,
    kSignedShort = 8,
    kSignedLong = 9,
    kSignedRational = 10,
};

/// Bytes of one value, 0 for an unknown type.
std::size_t sizeOf(std::uint16_t type) {
    switch (type) {
    case kByte:
    case kAscii:
    case kSignedByte:
    case kUndefined:
        return 1;
    case kShort:
    case kSignedShort:
        return 2;
    case kLong:
    case kSignedLong:
        return 4;
    case kRational:
    case kSignedRational:
        return 8;
    default:
        return 0;
    }
}

double asSigned(std::uint32_t bits) {
    return static_cast<double>(static_cast<std::int32_t>(bits));
}

} // namespace

std::optional<TiffView> TiffView::of(ByteView tiff) {
    if (tiff.size() < 8 || tiff[0] != tiff[1] || (tiff[0] != 'I' && tiff[0] != 'M')) {
        return std::nullopt;
    }
    const TiffView view(tiff, tiff[0] == 'M');
    return view.number(2, 2) == 42 ? std::optional(view) : std::nullopt;
}

std::size_t TiffView::firstDirectory() const {
    return number(4, 4);
}

std::vector<TiffEntry> TiffView::directory(std::size_t offset) const {
    if (offset > m_tiff.size() || m_tiff.size() - offset < 2) {
        return {};
    }
    const std::size_t count = number(offset, 2);
    const std::size_t first = offset + 2;
    if (count > kMaxEntries || m_tiff.size() - first < count * kEntryBytes) {
        return {};
    }
    std::vector<TiffEntry> entries;
    for (std::size_t at = first; at < first + count * kEntryBytes; at += kEntryBytes) {
        TiffEntry entry{static_cast<std::uint16_t>(number(at, 2)),
                        static_cast<std::uint16_t>(number(at + 2, 2)), number(at + 4, 4), at + 8, 0};
        entry.size = sizeOf(entry.type) * std::size_t{entry.count};
        if (entry.size > 4) {
            entry.offset = number(at + 8, 4);
        }
        if (entry.size > 0 && entry.offset <= m_tiff.size() && entry.size <= m_tiff.size() - entry.offset) {
            entries.push_back(entry);
        }
    }
    return entries;
}

std::optional<std::vector<double>> TiffView::numbers(const TiffEntry& entry, std::size_t count) const {
    if (entry.count < count) {
        return std::nullopt;
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> one = value(entry, i);
        if (!one) {
            return std::nullopt;
        }
        values.push_back(*one);
    }
    return values;
}

std::string TiffView::text(const TiffEntry& entry) const {
    return entry.type == kAscii ? plainText(textOf(bytes(entry))) : std::string();
}

std::uint32_t TiffView::number(std::size_t offset, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
        value = value << 8 | m_tiff[offset + (m_isBigEndian ? i : size - 1 - i)];
    }
    return value;
}

std::optional<double> TiffView::value(const TiffEntry& entry, std::size_t index) const {
    const std::size_t at = entry.offset + index * sizeOf(entry.type);
    switch (entry.type) {
    case kByte:
        return number(at, 1);
    case kShort:
        return number(at, 2);
    case kSignedShort:
        return static_cast<double>(static_cast<std::int16_t>(number(at, 2)));
    case kLong:
        return number(at, 4);
    case kSignedLong:
        return asSigned(number(at, 4));
    case kRational:
    case kSignedRational: {
        const bool isSigned = entry.type == kSignedRational;
        const auto part = [&](std::size_t offset) {
            const std::uint32_t bits = number(offset, 4);
            return isSigned ? asSigned(bits) : static_cast<double>(bits);
        };
        const double denominator = part(at + 4);
        return denominator == 0 ? std::nullopt : std::optional(part(at) / denominator);
    }
    default:
        return std::nullopt;
    }
}

const TiffEntry* find(const std::vector<TiffEntry>& directory, std::uint16_t tag) {
    const auto found = std::ranges::find(directory, tag, &TiffEntry::tag);
    return found == directory.end() ? nullptr : &*found;
}

} // namespace spherewalk::photo
