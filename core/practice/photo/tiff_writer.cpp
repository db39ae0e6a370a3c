// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo/tiff_writer.h"

#include "spherewalk/base/error.h"

namespace spherewalk::practice {

namespace {

enum Type : std::uint16_t {
    kAscii = 2,
    kShort = 3,
    kLong = 4,
    kRational = 5,
    kUndefined = 7,
    kSignedRational = 10
};

} // namespace

std::uint32_t TiffWriter::Place::entry(std::uint16_t tag) const {
    for (const auto& [written, at] : entries) {
        if (written == tag) {
            return at;
        }
    }
    throw Error(ErrorKind::Internal, "A TIFF directory lacks an entry that was to be linked.");
}

TiffWriter::TiffWriter(Order order) : m_order(order) {
    m_bytes = order == Order::Big ? Bytes{'M', 'M'} : Bytes{'I', 'I'};
    put(m_bytes, 42, 2);
    put(m_bytes, 8, 4);
}

void TiffWriter::put(Bytes& to, std::uint64_t value, int size) const {
    for (int i = 0; i < size; ++i) {
        const int byte = m_order == Order::Big ? size - 1 - i : i;
        to.push_back(static_cast<std::uint8_t>(value >> (8 * byte)));
    }
}

TiffWriter::Entry TiffWriter::ascii(std::uint16_t tag, std::string_view text) const {
    Entry entry = undefined(tag, text);
    entry.type = kAscii;
    entry.value.push_back(0);
    ++entry.count;
    return entry;
}

TiffWriter::Entry TiffWriter::undefined(std::uint16_t tag, std::string_view bytes) const {
    return {tag, kUndefined, static_cast<std::uint32_t>(bytes.size()), Bytes(bytes.begin(), bytes.end())};
}

TiffWriter::Entry TiffWriter::shorts(std::uint16_t tag, std::initializer_list<int> values) const {
    Entry entry{tag, kShort, static_cast<std::uint32_t>(values.size()), {}};
    for (const int value : values) {
        put(entry.value, static_cast<std::uint64_t>(value), 2);
    }
    return entry;
}

TiffWriter::Entry TiffWriter::longs(std::uint16_t tag, std::initializer_list<std::uint32_t> values) const {
    Entry entry{tag, kLong, static_cast<std::uint32_t>(values.size()), {}};
    for (const std::uint32_t value : values) {
        put(entry.value, value, 4);
    }
    return entry;
}

TiffWriter::Entry
TiffWriter::rationals(std::uint16_t tag,
                      std::initializer_list<std::pair<std::int64_t, std::int64_t>> values) const {
    Entry entry{tag, kRational, static_cast<std::uint32_t>(values.size()), {}};
    for (const auto& [numerator, denominator] : values) {
        put(entry.value, static_cast<std::uint64_t>(numerator), 4);
        put(entry.value, static_cast<std::uint64_t>(denominator), 4);
    }
    return entry;
}

TiffWriter::Entry
TiffWriter::signedRationals(std::uint16_t tag,
                            std::initializer_list<std::pair<std::int64_t, std::int64_t>> values) const {
    Entry entry = rationals(tag, values);
    entry.type = kSignedRational;
    return entry;
}

TiffWriter::Place TiffWriter::directory(const std::vector<Entry>& entries) {
    if (m_bytes.size() % 2 != 0) {
        m_bytes.push_back(0);
    }
    Place place;
    place.offset = size();
    Bytes behind;
    const std::uint32_t behindOffset = place.offset + 2 + 12 * static_cast<std::uint32_t>(entries.size()) + 4;
    put(m_bytes, entries.size(), 2);
    for (const Entry& entry : entries) {
        place.entries.emplace_back(entry.tag, size());
        put(m_bytes, entry.tag, 2);
        put(m_bytes, entry.type, 2);
        put(m_bytes, entry.count, 4);
        if (entry.value.size() <= 4) {
            Bytes value = entry.value;
            value.resize(4);
            m_bytes.insert(m_bytes.end(), value.begin(), value.end());
        } else {
            put(m_bytes, behindOffset + behind.size(), 4);
            behind.insert(behind.end(), entry.value.begin(), entry.value.end());
            if (behind.size() % 2 != 0) {
                behind.push_back(0); // values begin at even places
            }
        }
    }
    place.nextOffset = size();
    put(m_bytes, 0, 4);
    m_bytes.insert(m_bytes.end(), behind.begin(), behind.end());
    return place;
}

std::uint32_t TiffWriter::append(ByteView bytes) {
    const std::uint32_t at = size();
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    return at;
}

void TiffWriter::patchLong(std::uint32_t offset, std::uint32_t value) {
    Bytes number;
    put(number, value, 4);
    std::copy(number.begin(), number.end(), m_bytes.begin() + offset);
}

} // namespace spherewalk::practice
