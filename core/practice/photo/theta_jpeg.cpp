// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/practice/theta_jpeg.h"

#include "photo/camera_time.h"
#include "photo/tiff_writer.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::practice {

namespace {

constexpr std::size_t kMaxSegment = 65533;

std::pair<std::int64_t, std::int64_t> rational(double value, std::int64_t denominator) {
    return {std::llround(value * static_cast<double>(denominator)), denominator};
}

std::pair<std::int64_t, std::int64_t> exposureTime(double seconds) {
    return seconds < 0.3 ? std::pair<std::int64_t, std::int64_t>{1, std::llround(1 / seconds)}
                         : rational(seconds, 10);
}

RgbImage thumbnail(const RgbImage& picture) {
    RgbImage small(160, 80);
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x) {
            const int left = x * picture.width() / small.width();
            const int top = y * picture.height() / small.height();
            const int right = std::max(left + 1, (x + 1) * picture.width() / small.width());
            const int bottom = std::max(top + 1, (y + 1) * picture.height() / small.height());
            for (int c = 0; c < 3; ++c) {
                int sum = 0;
                for (int j = top; j < bottom; ++j) {
                    for (int i = left; i < right; ++i) {
                        sum += picture.at(i, j)[c];
                    }
                }
                small.at(x, y)[c] = static_cast<std::uint8_t>(sum / ((right - left) * (bottom - top)));
            }
        }
    }
    return small;
}

std::vector<TiffWriter::Entry> mainEntries(const TiffWriter& w, const ThetaTags& tags,
                                           const std::string& time) {
    return {w.ascii(0x010E, std::string(31, ' ')),
            w.ascii(0x010F, "RICOH"),
            w.ascii(0x0110, tags.model),
            w.shorts(0x0112, {1}),
            w.rationals(0x011A, {{72, 1}}),
            w.rationals(0x011B, {{72, 1}}),
            w.shorts(0x0128, {2}),
            w.ascii(0x0131, tags.model + " Ver " + tags.firmware),
            w.ascii(0x0132, time),
            w.shorts(0x0213, {2}),
            w.ascii(0x8298, ""),
            w.longs(0x8769, {0})};
}

std::vector<TiffWriter::Entry> photoEntries(const TiffWriter& w, const ThetaTags& tags,
                                            const std::string& time, const RgbImage& picture) {
    const double brightness = std::log2(4.0 / (tags.exposureTimeS * tags.isoSpeed * 0.3));
    std::vector<TiffWriter::Entry> entries = {
        w.rationals(0x829A, {exposureTime(tags.exposureTimeS)}),
        w.rationals(0x829D, {{20, 10}}),
        w.shorts(0x8822, {tags.exposureProgram}),
        w.shorts(0x8827, {tags.isoSpeed}),
        w.shorts(0x8830, {1}),
        w.undefined(0x9000, "0230"),
        w.ascii(0x9003, time),
        w.ascii(0x9004, time),
        w.undefined(0x9101, std::string("\1\2\3\0", 4)),
        w.rationals(0x9102, {{32, 10}}),
        w.rationals(0x9202, {{20, 10}}),
        w.signedRationals(0x9203, {rational(brightness, 10)}),
        w.signedRationals(0x9204, {rational(tags.exposureBias, 10)}),
        w.shorts(0x9207, {5}),
        w.shorts(0x9208, {0}),
        w.shorts(0x9209, {0}),
        w.rationals(0x920A, {{103, 100}}),
    };
    if (tags.withMakerNote) {
        entries.push_back(w.undefined(0x927C, "12345678")); // linked when its place is known
    }
    const auto size = [](int side) { return static_cast<std::uint32_t>(side); };
    for (const TiffWriter::Entry& entry :
         {w.undefined(0xA000, "0100"), w.shorts(0xA001, {1}), w.longs(0xA002, {size(picture.width())}),
          w.longs(0xA003, {size(picture.height())}), w.shorts(0xA402, {tags.exposureProgram == 1 ? 1 : 0}),
          w.shorts(0xA403, {tags.hasFixedWhiteBalance ? 1 : 0}), w.shorts(0xA406, {0})}) {
        entries.push_back(entry);
    }
    return entries;
}

std::vector<TiffWriter::Entry> thetaEntries(const TiffWriter& w, const ThetaTags& tags) {
    // The attitude at the shot as a rotation vector in the body's frame: x right, y out of the front, z up.
    const double pitch = Radians(Degrees(tags.inclinationPitchDeg)).value();
    const double roll = Radians(Degrees(tags.inclinationRollDeg)).value();
    return {w.shorts(0x0001, {1}),
            w.shorts(0x0002, {0}),
            w.signedRationals(
                0x0003, {rational(tags.inclinationRollDeg, 10), rational(tags.inclinationPitchDeg, 10)}),
            w.shorts(0x0005, {0}),
            w.shorts(0x0006, {0}),
            w.shorts(0x0007, {tags.levelled ? 1 : 0}),
            w.shorts(0x0008, {0}),
            w.ascii(0x000A, zoneText(tags.timeZone)),
            w.rationals(0x0101, {{tags.isoSpeed, 1}, {0, 1}, {tags.isoSpeed, 1}, {0, 1}}),
            w.rationals(0x0102, {{20, 10}, {20, 10}}),
            w.rationals(0x0103, {exposureTime(tags.exposureTimeS), exposureTime(tags.exposureTimeS)}),
            w.signedRationals(0x0109, {rational(pitch, 1000000), rational(roll, 1000000), {0, 1000000}}),
            w.shorts(0x1001, {325}),
            w.shorts(0x1003, {318})};
}

/// "Rev" and four digits made of the version's first two numbers, as the firmware spells itself.
std::string revision(const std::string& firmware) {
    std::string digits;
    for (const char c : firmware) {
        if (c >= '0' && c <= '9') {
            digits += c;
        }
    }
    digits.resize(4, '0');
    return "Rev" + digits;
}

void addMakerNote(TiffWriter& w, const ThetaTags& tags, const TiffWriter::Place& photo) {
    constexpr std::uint16_t kMakerNote = 0x927C;
    const std::uint32_t begin = w.append(bytesOf(std::string_view("Ricoh\0\0\0", 8)));
    const auto maker = w.directory({w.ascii(0x0001, "Rdc"), w.ascii(0x0002, revision(tags.firmware)),
                                    w.ascii(0x0005, tags.serial), w.longs(0x4001, {0})});
    std::uint32_t end = w.size();
    const auto theta = w.directory(thetaEntries(w, tags));
    if (tags.thetaIfdInsideMakerNote) {
        end = w.size();
    }
    constexpr std::uint32_t kCount = 4; // within an entry: tag, type, count, value
    constexpr std::uint32_t kValue = 8;
    constexpr std::uint32_t kNowhere = 0xfffffff0;
    w.patchLong(maker.entry(0x4001) + kValue, tags.withHostileMakerNote ? kNowhere : theta.offset);
    if (tags.withHostileMakerNote) {
        w.patchLong(maker.entry(0x0005) + kCount, kNowhere);
        w.patchLong(maker.entry(0x0005) + kValue, kNowhere);
    }
    w.patchLong(photo.entry(kMakerNote) + kCount, end - begin);
    w.patchLong(photo.entry(kMakerNote) + kValue, begin);
}

Bytes exif(const RgbImage& picture, const ThetaTags& tags) {
    TiffWriter w(tags.byteOrder == ThetaTags::ByteOrder::Big ? TiffWriter::Order::Big
                                                             : TiffWriter::Order::Little);
    const std::string time = exifTime({tags.time, tags.timeZone});
    constexpr std::uint32_t kValue = 8;
    const auto main = w.directory(mainEntries(w, tags, time));
    const auto photo = w.directory(photoEntries(w, tags, time, picture));
    w.patchLong(main.entry(0x8769) + kValue, photo.offset);
    if (tags.withMakerNote) {
        addMakerNote(w, tags, photo);
    }
    const Bytes small = jpeg::encode(thumbnail(picture), 80);
    const auto second =
        w.directory({w.shorts(0x0103, {6}), w.rationals(0x011A, {{72, 1}}), w.rationals(0x011B, {{72, 1}}),
                     w.shorts(0x0128, {2}), w.longs(0x0201, {0}),
                     w.longs(0x0202, {static_cast<std::uint32_t>(small.size())})});
    w.patchLong(main.nextOffset, second.offset);
    w.patchLong(second.entry(0x0201) + kValue, w.append(small));
    Bytes segment = {'E', 'x', 'i', 'f', 0, 0};
    segment.insert(segment.end(), w.bytes().begin(), w.bytes().end());
    return segment;
}

std::string xmp(const RgbImage& picture, const ThetaTags& tags) {
    const auto element = [](std::string_view name, std::string_view value) {
        return text("<GPano:", name, ">", value, "</GPano:", name, ">");
    };
    const std::string width = text(picture.width());
    const std::string height = text(picture.height());
    return text("http://ns.adobe.com/xap/1.0/", std::string_view("\0", 1),
                "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n",
                "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\" x:xmptk=\"", tags.model, " Ver ", tags.firmware, "\">",
                "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">",
                "<rdf:Description rdf:about=\"\" xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\">",
                element("ProjectionType", "equirectangular"), element("UsePanoramaViewer", "True"),
                element("CroppedAreaImageWidthPixels", width),
                element("CroppedAreaImageHeightPixels", height), element("FullPanoWidthPixels", width),
                element("FullPanoHeightPixels", height), element("CroppedAreaLeftPixels", "0"),
                element("CroppedAreaTopPixels", "0"),
                element("PosePitchDegrees", fixed(tags.posePitchDeg, 1)),
                element("PoseRollDegrees", fixed(tags.poseRollDeg, 1)),
                "</rdf:Description></rdf:RDF></x:xmpmeta>\n<?xpacket end=\"r\"?>");
}

void appendApp1(Bytes& file, ByteView content) {
    if (content.size() > kMaxSegment) {
        throw Error(ErrorKind::Internal, "The practice camera's metadata does not fit into a JPEG segment.");
    }
    const auto length = static_cast<std::uint32_t>(content.size() + 2);
    file.insert(file.end(),
                {0xFF, 0xE1, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length)});
    file.insert(file.end(), content.begin(), content.end());
}

/// Where the segments behind SOI and a JFIF header begin.
std::size_t behindJfif(const Bytes& encoded) {
    const bool hasJfif = encoded.size() > 6 && encoded[2] == 0xFF && encoded[3] == 0xE0;
    return hasJfif ? 4 + std::size_t{encoded[4]} * 256 + encoded[5] : 2;
}

} // namespace

Bytes thetaJpeg(const RgbImage& picture, const ThetaTags& tags, int quality) {
    if (picture.empty() || picture.width() != 2 * picture.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not make a spherical photo of a picture of ", picture.width(), " x ",
                         picture.height(), " pixels: it must be twice as wide as high."));
    }
    const Bytes encoded = jpeg::encode(picture, quality);
    Bytes file = {0xFF, 0xD8};
    appendApp1(file, exif(picture, tags));
    if (tags.withXmp) {
        appendApp1(file, bytesOf(xmp(picture, tags)));
    }
    file.insert(file.end(), encoded.begin() + static_cast<std::ptrdiff_t>(behindJfif(encoded)),
                encoded.end());
    return file;
}

} // namespace spherewalk::practice
