// SPDX-License-Identifier: GPL-3.0-or-later
#include "maker_note.h"

#include "tiff_view.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::photo {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kRicoh = "Ricoh\0\0\0"sv;
constexpr std::uint16_t kExifDirectory = 0x8769;
constexpr std::uint16_t kMakerNote = 0x927C;
constexpr std::uint16_t kThetaDirectory = 0x4001;

/// A directory of the note with the reader of its values.
class Tags {
  public:
    Tags(const TiffView& tiff, std::vector<TiffEntry> entries)
        : m_tiff(tiff), m_entries(std::move(entries)) {}

    std::optional<std::vector<double>> numbers(std::uint16_t tag, std::size_t count) const {
        const TiffEntry* entry = find(m_entries, tag);
        return entry != nullptr ? m_tiff.numbers(*entry, count) : std::nullopt;
    }

    std::optional<double> number(std::uint16_t tag) const {
        const auto found = numbers(tag, 1);
        return found ? std::optional(found->front()) : std::nullopt;
    }

    std::string text(std::uint16_t tag) const {
        const TiffEntry* entry = find(m_entries, tag);
        return entry != nullptr ? m_tiff.text(*entry) : std::string();
    }

    /// The directory that the entry points to, empty if there is none.
    Tags below(std::uint16_t tag) const {
        const std::optional<double> offset = number(tag);
        return {m_tiff, offset && *offset >= 0 ? m_tiff.directory(static_cast<std::size_t>(*offset))
                                               : std::vector<TiffEntry>()};
    }

    const TiffEntry* entry(std::uint16_t tag) const { return find(m_entries, tag); }

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

void readTheta(const Tags& tags, ThetaMakerNote& note) {
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
    const Tags exif = Tags(*view, view->directory(view->firstDirectory())).below(kExifDirectory);
    const TiffEntry* entry = exif.entry(kMakerNote);
    if (entry == nullptr || !textOf(view->bytes(*entry)).starts_with(kRicoh)) {
        return std::nullopt;
    }
    const Tags ricoh(*view, view->directory(entry->offset + kRicoh.size()));
    ThetaMakerNote note;
    note.firmware = ricoh.text(0x0002);
    note.serial = ricoh.text(0x0005);
    readTheta(ricoh.below(kThetaDirectory), note);
    return note;
}

} // namespace spherewalk::photo
