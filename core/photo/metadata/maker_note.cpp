// SPDX-License-Identifier: GPL-3.0-or-later
#include "metadata/maker_note.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::photo {

namespace {

constexpr std::size_t kMaxEntries = 512;
constexpr std::size_t kEntryBytes = 12;

enum TiffType : std::uint16_t {
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
std::size_t tiffValueBytes(std::uint16_t type) {
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

using namespace std::string_view_literals;

/// One entry of a TIFF directory whose value lies within the bytes.
struct TiffEntry {
    std::uint16_t tag = 0;
    std::uint16_t type = 0;
    std::uint32_t count = 0;
    std::size_t offset = 0; ///< Offset of the value from the TIFF header.
    std::size_t size = 0;   ///< Size of the value in bytes.
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
        entry.size = tiffValueBytes(entry.type) * std::size_t{entry.count};
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
    const std::size_t at = entry.offset + index * tiffValueBytes(entry.type);
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

/// The entry with this tag, or null.
const TiffEntry* findEntry(const std::vector<TiffEntry>& directory, std::uint16_t tag) {
    const auto found = std::ranges::find(directory, tag, &TiffEntry::tag);
    return found == directory.end() ? nullptr : &*found;
}

constexpr std::string_view kRicoh = "Ricoh\0\0\0"sv;
constexpr std::uint16_t kExifDirectory = 0x8769;
constexpr std::uint16_t kMakerNote = 0x927C;
constexpr std::uint16_t kThetaDirectory = 0x4001;

/// A directory of the note with the reader of its values.
class MakerTags {
  public:
    MakerTags(const TiffView& tiff, std::vector<TiffEntry> entries)
        : m_tiff(tiff), m_entries(std::move(entries)) {}

    std::optional<std::vector<double>> numbers(std::uint16_t tag, std::size_t count) const {
        const TiffEntry* entry = findEntry(m_entries, tag);
        return entry != nullptr ? m_tiff.numbers(*entry, count) : std::nullopt;
    }

    std::optional<double> number(std::uint16_t tag) const {
        const auto found = numbers(tag, 1);
        return found ? std::optional(found->front()) : std::nullopt;
    }

    std::string text(std::uint16_t tag) const {
        const TiffEntry* entry = findEntry(m_entries, tag);
        return entry != nullptr ? m_tiff.text(*entry) : std::string();
    }

    /// The directory that the entry points to, empty if there is none.
    MakerTags below(std::uint16_t tag) const {
        const std::optional<double> offset = number(tag);
        return {m_tiff, offset && *offset >= 0 ? m_tiff.directory(static_cast<std::size_t>(*offset))
                                               : std::vector<TiffEntry>()};
    }

    const TiffEntry* entry(std::uint16_t tag) const { return findEntry(m_entries, tag); }

  private:
    const TiffView& m_tiff;
    std::vector<TiffEntry> m_entries;
};

bool isTimeZone(std::string_view text) {
    const auto isDigit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
    return text.size() == 6 && (text[0] == '+' || text[0] == '-') && isDigit(1) && isDigit(2) &&
           text[3] == ':' && isDigit(4) && isDigit(5);
}

/// Degrees written as 359.3 for -0.7. Range: nothing beyond a full turn is an angle.
std::optional<Degrees> signedDegrees(double value) {
    if (std::abs(value) > 360) {
        return std::nullopt;
    }
    return Degrees(value > 180 ? value - 360 : value <= -180 ? value + 360 : value);
}

void readTheta(const MakerTags& tags, ThetaMakerNote& note) {
    if (const auto type = tags.number(0x0001)) {
        note.imageType = static_cast<int>(std::clamp(*type, -1.0, 65535.0));
    }
    if (const auto inclination = tags.numbers(0x0003, 2)) {
        note.inclinationRoll = signedDegrees((*inclination)[0]);
        note.inclinationPitch = signedDegrees((*inclination)[1]);
    }
    if (const auto compass = tags.number(0x0004); compass && *compass >= 0 && *compass <= 360) {
        note.compass = Degrees(*compass);
    }
    if (const auto levelled = tags.number(0x0007); levelled && (*levelled == 0 || *levelled == 1)) {
        note.isLevelled = *levelled == 1;
    }
    if (const std::string zone = tags.text(0x000A); isTimeZone(zone)) {
        note.timeZone = zone;
    }
    if (const auto zenith = tags.numbers(0x0109, 3)) {
        note.zenith = Eigen::Vector3d((*zenith)[0], (*zenith)[1], (*zenith)[2]);
    }
    const auto celsius = [&](std::uint16_t tag) {
        const auto tenths = tags.number(tag);
        return tenths ? std::optional(*tenths / 10) : std::nullopt;
    };
    note.frontSensorCelsius = celsius(0x1001);
    note.rearSensorCelsius = celsius(0x1003);
}

} // namespace

std::optional<ThetaMakerNote> readThetaMakerNote(ByteView tiff) {
    const std::optional<TiffView> view = TiffView::of(tiff);
    if (!view) {
        return std::nullopt;
    }
    const MakerTags exif = MakerTags(*view, view->directory(view->firstDirectory())).below(kExifDirectory);
    const TiffEntry* entry = exif.entry(kMakerNote);
    if (entry == nullptr || !textOf(view->bytes(*entry)).starts_with(kRicoh)) {
        return std::nullopt;
    }
    const MakerTags ricoh(*view, view->directory(entry->offset + kRicoh.size()));
    ThetaMakerNote note;
    note.firmware = ricoh.text(0x0002);
    note.serial = ricoh.text(0x0005);
    readTheta(ricoh.below(kThetaDirectory), note);
    return note;
}

std::string plainText(std::string_view foreign) {
    constexpr std::string_view kBlanks = " \t\r\n";
    constexpr std::size_t kMaxBytes = 200;
    foreign = foreign.substr(0, foreign.find('\0'));
    const std::size_t first = foreign.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return printable(foreign.substr(first, foreign.find_last_not_of(kBlanks) - first + 1), kMaxBytes);
}

} // namespace spherewalk::photo
