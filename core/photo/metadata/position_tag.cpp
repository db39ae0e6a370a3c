// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/position_tag.h"

#include "metadata/maker_note.h"
#include "metadata/xmp_packet.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"

#include <exiv2/error.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

namespace spherewalk::photo {

namespace {

using jpeg::Segment;

constexpr std::string_view kKeyPrefix = "Xmp.spherewalk.";
constexpr std::size_t kMostSegmentBytes = 65533;
constexpr std::size_t kMostTagText = 200;
constexpr std::array kPositionKeys{"PositionX", "PositionY", "PositionZ"};
constexpr std::array kRotationKeys{"RoomFromPhotoW", "RoomFromPhotoX", "RoomFromPhotoY", "RoomFromPhotoZ"};
constexpr std::array<std::string_view, 3> kPoseKeys{
    "Xmp.GPano.PoseHeadingDegrees", "Xmp.GPano.PosePitchDegrees", "Xmp.GPano.PoseRollDegrees"};

std::string tagKey(std::string_view name) {
    return text(kKeyPrefix, name);
}

void checkTag(const PositionTag& tag) {
    const auto isText = [](const std::string& value) { return printable(value, value.size()) == value; };
    if (tag.surveyId.empty() || !isText(tag.surveyId) || !isText(tag.stationName) ||
        tag.surveyId.size() > kMostTagText || tag.stationName.size() > kMostTagText) {
        throw Error(ErrorKind::InvalidInput,
                    text("A photo cannot be tagged with the survey \"", printable(tag.surveyId),
                         "\" and the station \"", printable(tag.stationName),
                         "\": use up to 200 printable characters, and a survey id."));
    }
    if (!tag.positionM.allFinite()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The position of station \"", tag.stationName, "\" is not a number."));
    }
}

/// Looking up and leaning to the right are positive there.
void setPose(const Eigen::Quaterniond& roomFromPhoto, Exiv2::XmpData& xmp) {
    constexpr int kDigits = 4; // of a degree
    constexpr double kRounded = 360 - 0.5e-4;
    const YawPitchRoll angles = yawPitchRoll(roomFromPhoto);
    const double clockwise = 90 - Degrees(angles.yaw).value();
    const double heading = clockwise < 0 ? clockwise + 360 : clockwise;
    const std::array degrees{heading < kRounded ? heading : 0, -Degrees(angles.pitch).value(),
                             Degrees(angles.roll).value()};
    for (std::size_t i = 0; i < kPoseKeys.size(); ++i) {
        xmp[std::string(kPoseKeys[i])] = fixed(degrees[i], kDigits);
    }
}

void setProperties(const PositionTag& tag, Exiv2::XmpData& xmp) {
    xmp[tagKey("SurveyId")] = tag.surveyId;
    xmp[tagKey("StationId")] = text(tag.stationId);
    if (!tag.stationName.empty()) {
        xmp[tagKey("StationName")] = tag.stationName;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        xmp[tagKey(kPositionKeys[i])] = text(tag.positionM[static_cast<Eigen::Index>(i)]);
    }
    if (tag.roomFromPhoto) {
        const auto& q = *tag.roomFromPhoto;
        const Eigen::Quaterniond unit =
            checkedQuaternion(q.w(), q.x(), q.y(), q.z(), "a photo's position tag");
        const std::array components{unit.w(), unit.x(), unit.y(), unit.z()};
        for (std::size_t i = 0; i < 4; ++i) {
            xmp[tagKey(kRotationKeys[i])] = text(components[i]);
        }
        if (tag.isPanoramaPose) {
            setPose(unit, xmp);
        }
    }
}

bool isOurs(const Exiv2::Xmpdatum& datum) {
    return datum.key().starts_with(kKeyPrefix);
}

/// True for what this tag replaces.
bool isReplaced(const Exiv2::Xmpdatum& datum, const PositionTag& tag) {
    const std::string name = datum.key();
    return isOurs(datum) ||
           (tag.isPanoramaPose && tag.roomFromPhoto && std::ranges::find(kPoseKeys, name) != kPoseKeys.end());
}

void removeProperties(const PositionTag& tag, Exiv2::XmpData& xmp) {
    for (auto it = xmp.begin(); it != xmp.end();) {
        it = isReplaced(*it, tag) ? xmp.erase(it) : it + 1;
    }
}

ByteView packetIn(const Segment& segment, ByteView jpeg) {
    return segment.content(jpeg).subspan(xmpSignature().size());
}

Exiv2::XmpData readXmp(const XmpSession& session, const Segment* segment, ByteView jpeg,
                       std::string_view source) {
    return segment == nullptr ? Exiv2::XmpData() : session.decoded(packetIn(*segment, jpeg), source);
}

/// The packet of the photo with the tag in place of an earlier one.
std::string taggedPacket(const Segment* present, ByteView jpeg, const PositionTag& tag,
                         std::string_view source) {
    const XmpSession session;
    Exiv2::XmpData xmp = readXmp(session, present, jpeg, source);
    removeProperties(tag, xmp);
    try {
        setProperties(tag, xmp);
    } catch (const Exiv2::Error& error) {
        throw Error(ErrorKind::Internal,
                    text("Could not tag ", source, "; please report this with the photo."),
                    printable(error.what()));
    }
    return session.encoded(xmp);
}

/// All properties but those that the tag replaces, with their values.
std::multimap<std::string, std::string> foreignProperties(ByteView jpeg, const PositionTag& tag,
                                                          std::string_view source) {
    const std::vector<Segment> segments = jpeg::segments(jpeg, source);
    const XmpSession session;
    std::multimap<std::string, std::string> found;
    for (const Exiv2::Xmpdatum& datum :
         readXmp(session, findApp1(segments, jpeg, xmpSignature()), jpeg, source)) {
        if (!isReplaced(datum, tag)) {
            found.emplace(datum.key(), datum.toString());
        }
    }
    return found;
}

Bytes xmpSegment(const std::string& packet, std::string_view source) {
    const std::size_t content = xmpSignature().size() + packet.size();
    if (content > kMostSegmentBytes) {
        throw Error(ErrorKind::Unsupported,
                    text("Could not tag ", source, ": its XMP would have ", humanBytes(content),
                         ", more than a JPEG can hold in one piece; remove some of it."));
    }
    const std::size_t length = content + 2;
    Bytes segment{0xFF, jpeg::kApp1, static_cast<std::uint8_t>(length >> 8),
                  static_cast<std::uint8_t>(length)};
    for (const std::string_view part : {xmpSignature(), std::string_view(packet)}) {
        segment.insert(segment.end(), part.begin(), part.end());
    }
    return segment;
}

/// Where a new XMP segment belongs: behind Exif, or else behind the leading JFIF segments.
std::size_t placeForXmp(const std::vector<Segment>& segments, ByteView jpeg) {
    if (const Segment* exif = findApp1(segments, jpeg, exifSignature())) {
        return exif->offset + exif->size;
    }
    const auto other =
        std::ranges::find_if(segments, [](const Segment& s) { return s.marker != jpeg::kApp0; });
    return other == segments.begin() ? 2 : std::prev(other)->offset + std::prev(other)->size;
}

/// Every segment but the XMP, and all from the first scan on.
std::vector<ByteView> untouched(ByteView jpeg, std::string_view source) {
    std::vector<ByteView> parts;
    const std::vector<Segment> segments = jpeg::segments(jpeg, source);
    const Segment* xmp = findApp1(segments, jpeg, xmpSignature());
    for (const Segment& segment : segments) {
        if (&segment != xmp) {
            parts.push_back(segment.whole(jpeg));
        }
    }
    parts.back() = jpeg.subspan(segments.back().offset);
    return parts;
}

std::optional<ThetaMakerNote> makerNote(ByteView jpeg, std::string_view source) {
    const std::vector<Segment> segments = jpeg::segments(jpeg, source);
    const Segment* exif = findApp1(segments, jpeg, exifSignature());
    return exif == nullptr ? std::nullopt
                           : readThetaMakerNote(exif->content(jpeg).subspan(exifSignature().size()));
}

bool isSame(const PositionTag& a, const PositionTag& b) {
    const auto isSameRotation = [&] {
        constexpr double kRounding = 1e-12;
        return a.roomFromPhoto.has_value() == b.roomFromPhoto.has_value() &&
               (!a.roomFromPhoto ||
                angleBetween(a.roomFromPhoto->normalized(), b.roomFromPhoto->normalized()).value() <
                    kRounding);
    };
    return a.surveyId == b.surveyId && a.stationId == b.stationId && a.stationName == b.stationName &&
           a.positionM == b.positionM && isSameRotation();
}

void verifyTagging(ByteView before, ByteView after, const PositionTag& tag, std::string_view source) {
    const auto require = [&](bool isTrue, std::string_view what) {
        if (!isTrue) {
            throw Error(ErrorKind::Internal,
                        text("Tagging ", source, " would have changed ", what,
                             ", so it was left as it is; please report this with the photo."));
        }
    };
    const auto areEqual = [](ByteView a, ByteView b) { return std::ranges::equal(a, b); };
    require(std::ranges::equal(untouched(before, source), untouched(after, source), areEqual),
            "more than its XMP");
    require(makerNote(before, source) == makerNote(after, source), "its maker note");
    require(foreignProperties(before, tag, source) == foreignProperties(after, tag, source),
            "other XMP properties");
    const std::optional<PositionTag> written = readPositionTag(after, source);
    require(written && isSame(*written, tag), "the tag itself");
}

std::optional<std::int64_t> integer(const std::string& value) {
    std::int64_t parsed = 0;
    const char* end = value.data() + value.size();
    const auto [stop, failure] = std::from_chars(value.data(), end, parsed);
    return failure == std::errc() && stop == end ? std::optional(parsed) : std::nullopt;
}

/// Our properties by name, without the prefix. Nothing for a packet that cannot be read.
std::map<std::string, std::string> ownProperties(ByteView jpeg, std::string_view source) {
    const std::vector<Segment> segments = jpeg::segments(jpeg, source);
    std::map<std::string, std::string> found;
    try {
        const XmpSession session;
        for (const Exiv2::Xmpdatum& datum :
             readXmp(session, findApp1(segments, jpeg, xmpSignature()), jpeg, source)) {
            if (isOurs(datum)) {
                found.emplace(datum.key().substr(kKeyPrefix.size()), datum.toString());
            }
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt) {
            throw;
        }
    }
    return found;
}

/// The finite numbers of these names, nothing if one is missing.
template <std::size_t Count>
std::optional<std::array<double, Count>> tagNumbers(const std::map<std::string, std::string>& properties,
                                                    const std::array<const char*, Count>& names) {
    std::array<double, Count> values{};
    for (std::size_t i = 0; i < Count; ++i) {
        const auto found = properties.find(names[i]);
        const auto value = found == properties.end() ? std::nullopt : parseNumber(found->second);
        if (!value) {
            return std::nullopt;
        }
        values[i] = *value;
    }
    return values;
}

std::optional<Eigen::Quaterniond> unitRotation(const std::optional<std::array<double, 4>>& wxyz) {
    if (!wxyz) {
        return std::nullopt;
    }
    const Eigen::Quaterniond q((*wxyz)[0], (*wxyz)[1], (*wxyz)[2], (*wxyz)[3]);
    constexpr double kTolerance = 0.01;
    return std::abs(q.norm() - 1) < kTolerance ? std::optional(q.normalized()) : std::nullopt;
}

} // namespace

Bytes withPositionTag(ByteView jpeg, const PositionTag& tag, std::string_view source) {
    checkTag(tag);
    const std::vector<Segment> segments = jpeg::segments(jpeg, source);
    const Segment* present = findApp1(segments, jpeg, xmpSignature());
    const Bytes segment = xmpSegment(taggedPacket(present, jpeg, tag, source), source);

    const std::size_t begin = present != nullptr ? present->offset : placeForXmp(segments, jpeg);
    const std::size_t end = present != nullptr ? present->offset + present->size : begin;
    Bytes tagged;
    tagged.reserve(jpeg.size() + segment.size());
    for (const ByteView part : {jpeg.first(begin), ByteView(segment), jpeg.subspan(end)}) {
        tagged.insert(tagged.end(), part.begin(), part.end());
    }
    verifyTagging(jpeg, tagged, tag, source);
    return tagged;
}

std::optional<PositionTag> readPositionTag(ByteView jpeg, std::string_view source) {
    const std::map<std::string, std::string> properties = ownProperties(jpeg, source);
    const auto word = [&](const char* name) {
        const auto found = properties.find(name);
        return found == properties.end() ? std::string() : printable(found->second, kMostTagText);
    };
    const auto position = tagNumbers(properties, kPositionKeys);
    const auto stationId = integer(word("StationId"));
    if (!position || !stationId || word("SurveyId").empty()) {
        return std::nullopt;
    }
    return PositionTag{word("SurveyId"),
                       *stationId,
                       word("StationName"),
                       Eigen::Vector3d(position->data()),
                       unitRotation(tagNumbers(properties, kRotationKeys)),
                       false};
}

} // namespace spherewalk::photo
