// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/metadata.h"

#include "metadata/maker_note.h"
#include "metadata/xmp_packet.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"

#include <exiv2/exif.hpp>

#include <cmath>
#include <exception>

namespace spherewalk::photo {

namespace {

const Exiv2::Exifdatum* findExif(const Exiv2::ExifData& exif, const char* key) {
    const auto found = exif.findKey(Exiv2::ExifKey(key));
    // exiv2 reads the first of no values as if it were there.
    return found == exif.end() || found->count() < 1 ? nullptr : &*found;
}

std::string exifText(const Exiv2::ExifData& exif, const char* key) {
    const Exiv2::Exifdatum* datum = findExif(exif, key);
    return datum == nullptr ? std::string() : plainText(datum->toString());
}

std::optional<double> exifNumber(const Exiv2::ExifData& exif, const char* key) {
    const Exiv2::Exifdatum* datum = findExif(exif, key);
    if (datum == nullptr) {
        return std::nullopt;
    }
    const Exiv2::Rational value = datum->toRational();
    if (value.second == 0 || value.first <= 0 || value.second < 0) {
        return std::nullopt;
    }
    return static_cast<double>(value.first) / value.second;
}

/// WhiteBalance of Exif: 0 automatic, 1 manual.
std::optional<bool> isManual(const Exiv2::Exifdatum* datum) {
    const auto value = datum == nullptr ? -1 : datum->toRational().first;
    return value == 0 || value == 1 ? std::optional(value == 1) : std::nullopt;
}

/// "2026:01:02 03:04:05" as "2026-01-02T03:04:05"; empty for anything else, a clock that was not set among
/// it.
std::string isoTime(const std::string& exif) {
    constexpr std::string_view kPattern = "dddd:dd:dd dd:dd:dd";
    if (exif.size() != kPattern.size() || exif.starts_with("0000")) {
        return {};
    }
    for (std::size_t i = 0; i < kPattern.size(); ++i) {
        const bool isDigit = exif[i] >= '0' && exif[i] <= '9';
        if (kPattern[i] == 'd' ? !isDigit : exif[i] != kPattern[i]) {
            return {};
        }
    }
    std::string iso = exif;
    iso[4] = iso[7] = '-';
    iso[10] = 'T';
    return iso;
}

void readExif(ByteView tiff, PhotoMetadata& metadata) {
    metadata.theta = readThetaMakerNote(tiff);
    if (metadata.theta) {
        metadata.timeZone = metadata.theta->timeZone;
    }
    try {
        Exiv2::ExifData exif;
        Exiv2::ExifParser::decode(exif, tiff.data(), static_cast<std::uint32_t>(tiff.size()));
        metadata.make = exifText(exif, "Exif.Image.Make");
        metadata.model = exifText(exif, "Exif.Image.Model");
        metadata.software = exifText(exif, "Exif.Image.Software");
        metadata.takenAt = isoTime(exifText(exif, "Exif.Photo.DateTimeOriginal"));
        metadata.exposureS = exifNumber(exif, "Exif.Photo.ExposureTime");
        metadata.fNumber = exifNumber(exif, "Exif.Photo.FNumber");
        if (const auto iso = exifNumber(exif, "Exif.Photo.ISOSpeedRatings"); iso && *iso <= 1e7) {
            metadata.iso = static_cast<int>(*iso);
        }
        if (const auto orientation = exifNumber(exif, "Exif.Image.Orientation");
            orientation && *orientation <= 8) {
            metadata.orientation = static_cast<int>(*orientation);
        }
        metadata.hasFixedWhiteBalance = isManual(findExif(exif, "Exif.Photo.WhiteBalance"));
    } catch (const std::exception& error) {
        metadata.remarks.push_back(text("The Exif data are damaged (", printable(error.what()), ")."));
    }
}

/// Reads GPano properties; what makes no sense is remarked on and absent.
class PanoramaReader {
  public:
    PanoramaReader(const XmpSession& session, const Exiv2::XmpData& xmp, std::vector<std::string>& remarks)
        : m_session(session), m_xmp(xmp), m_remarks(remarks) {}

    bool isAny() const { return m_isAny; }

    std::string word(const char* name) {
        const auto value = find(name);
        return value ? plainText(*value) : std::string();
    }

    std::optional<double> number(const char* name, double least, double greatest) {
        const auto value = find(name);
        if (!value) {
            return std::nullopt;
        }
        const auto parsed = parseNumber(plainText(*value));
        if (parsed && *parsed >= least && *parsed <= greatest) {
            return parsed;
        }
        m_remarks.push_back(
            text("GPano:", name, " is \"", printable(*value, 40), "\", which makes no sense."));
        return std::nullopt;
    }

    std::optional<Degrees> angle(const char* name, double least, double greatest) {
        const auto value = number(name, least, greatest);
        return value ? std::optional(Degrees(*value)) : std::nullopt;
    }

    std::optional<int> pixels(const char* name) {
        const auto value = number(name, 1, 1e6);
        return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
    }

  private:
    std::optional<std::string> find(const char* name) {
        auto value = m_session.value(m_xmp, text("Xmp.GPano.", name));
        m_isAny = m_isAny || value;
        return value;
    }

    const XmpSession& m_session;
    const Exiv2::XmpData& m_xmp;
    std::vector<std::string>& m_remarks;
    bool m_isAny = false;
};

void readPanorama(ByteView packet, std::string_view source, PhotoMetadata& metadata) {
    try {
        const XmpSession session;
        const Exiv2::XmpData xmp = session.decoded(packet, source);
        PanoramaReader reader(session, xmp, metadata.remarks);
        PanoramaXmp panorama;
        panorama.projection = reader.word("ProjectionType");
        panorama.heading = reader.angle("PoseHeadingDegrees", -360, 360);
        if (panorama.heading) {
            const double turn = std::fmod(panorama.heading->value() + 360, 360);
            panorama.heading = Degrees(turn);
        }
        panorama.pitch = reader.angle("PosePitchDegrees", -90, 90);
        panorama.roll = reader.angle("PoseRollDegrees", -180, 180);
        panorama.fullWidth = reader.pixels("FullPanoWidthPixels");
        panorama.fullHeight = reader.pixels("FullPanoHeightPixels");
        panorama.croppedWidth = reader.pixels("CroppedAreaImageWidthPixels");
        panorama.croppedHeight = reader.pixels("CroppedAreaImageHeightPixels");
        if (reader.isAny()) {
            metadata.panorama = panorama;
        }
    } catch (const Error& error) {
        metadata.remarks.push_back(error.sentence());
    }
}

/// Pitch and roll, if the photo says both.
std::optional<YawPitchRoll> tilt(const PhotoMetadata& metadata) {
    if (!metadata.panorama || !metadata.panorama->pitch || !metadata.panorama->roll) {
        return std::nullopt;
    }
    // GPano counts looking up as positive, our pitch looking down.
    return YawPitchRoll{Radians(0), -Radians(*metadata.panorama->pitch), Radians(*metadata.panorama->roll)};
}

} // namespace

PhotoMetadata readMetadata(ByteView jpeg, std::string_view source) {
    prepareExiv2();
    const jpeg::Info info = jpeg::readInfo(jpeg, source);
    const std::vector<jpeg::Segment> segments = jpeg::segments(jpeg, source);
    PhotoMetadata metadata;
    metadata.width = info.width;
    metadata.height = info.height;
    if (const jpeg::Segment* exif = findApp1(segments, jpeg, exifSignature())) {
        readExif(exif->content(jpeg).subspan(exifSignature().size()), metadata);
    }
    if (const jpeg::Segment* xmp = findApp1(segments, jpeg, xmpSignature())) {
        readPanorama(xmp->content(jpeg).subspan(xmpSignature().size()), source, metadata);
    }
    return metadata;
}

std::optional<double> exposureStops(const PhotoMetadata& metadata) {
    const double exposure = metadata.exposureS.value_or(0) * metadata.iso.value_or(0);
    const double fNumber = metadata.fNumber.value_or(0);
    return exposure > 0 && fNumber > 0 ? std::optional(std::log2(exposure / (fNumber * fNumber)))
                                       : std::nullopt;
}

bool isLevel(const PhotoMetadata& metadata) {
    if (metadata.theta && metadata.theta->isLevelled) {
        return *metadata.theta->isLevelled;
    }
    if (metadata.model == "RICOH THETA S" || metadata.model == "RICOH THETA SC") {
        return false;
    }
    const std::optional<YawPitchRoll> angles = tilt(metadata);
    if (!angles) {
        return metadata.model.starts_with("RICOH THETA ");
    }
    constexpr Radians kAlmostLevel = Degrees(0.5);
    return std::abs(angles->pitch.value()) < kAlmostLevel.value() &&
           std::abs(angles->roll.value()) < kAlmostLevel.value();
}

std::optional<Eigen::Quaterniond> levelFromPhoto(const PhotoMetadata& metadata) {
    if (isLevel(metadata)) {
        return Eigen::Quaterniond::Identity();
    }
    const std::optional<YawPitchRoll> angles = tilt(metadata);
    return angles ? std::optional(rotation(*angles)) : std::nullopt;
}

} // namespace spherewalk::photo
