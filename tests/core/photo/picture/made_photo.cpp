// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/made_photo.h"

#include "spherewalk/base/image.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>

namespace spherewalk::test {

namespace {

using namespace std::string_view_literals;

/// Writes directories one after the other, each with its long values behind it.
class TiffWriter {
  public:
    explicit TiffWriter(bool isBigEndian) : m_isBigEndian(isBigEndian) {
        add(isBigEndian ? "MM"sv : "II"sv);
        add(42, 2);
        add(8, 4);
    }

    Bytes& bytes() { return m_bytes; }

    void add(std::string_view text) { m_bytes.insert(m_bytes.end(), text.begin(), text.end()); }

    void add(std::uint32_t number, int size) {
        for (int i = 0; i < size; ++i) {
            const int shift = 8 * (m_isBigEndian ? size - 1 - i : i);
            m_bytes.push_back(static_cast<std::uint8_t>(number >> shift));
        }
    }

    /// Returns where the directory begins.
    std::size_t directory(const std::vector<TiffField>& fields) {
        const std::size_t start = m_bytes.size();
        std::size_t behind = start + 2 + 12 * fields.size() + 4;
        add(static_cast<std::uint32_t>(fields.size()), 2);
        TiffWriter values(m_isBigEndian);
        values.m_bytes.clear();
        for (const TiffField& field : fields) {
            add(field.tag, 2);
            add(field.type, 2);
            add(field.count, 4);
            TiffWriter one(m_isBigEndian);
            one.m_bytes.clear();
            one.addValue(field);
            if (one.m_bytes.size() <= 4) {
                one.m_bytes.resize(4);
                m_bytes.insert(m_bytes.end(), one.m_bytes.begin(), one.m_bytes.end());
            } else {
                add(static_cast<std::uint32_t>(behind + values.m_bytes.size()), 4);
                values.m_bytes.insert(values.m_bytes.end(), one.m_bytes.begin(), one.m_bytes.end());
            }
        }
        add(0, 4);
        m_bytes.insert(m_bytes.end(), values.m_bytes.begin(), values.m_bytes.end());
        return start;
    }

  private:
    void addValue(const TiffField& field) {
        add(field.text);
        for (const std::uint32_t number : field.numbers) {
            add(number, field.type == 3 ? 2 : 4);
        }
    }

    Bytes m_bytes;
    bool m_isBigEndian;
};

} // namespace

TiffField shortField(std::uint16_t tag, std::uint16_t value) {
    return {tag, 3, 1, {value}};
}

TiffField longField(std::uint16_t tag, std::uint32_t value) {
    return {tag, 4, 1, {value}};
}

TiffField asciiField(std::uint16_t tag, const std::string& text) {
    return {tag, 2, static_cast<std::uint32_t>(text.size() + 1), {}, text + '\0'};
}

TiffField rationalField(std::uint16_t tag, const std::vector<std::int64_t>& parts, bool isSigned) {
    TiffField field{tag, static_cast<std::uint16_t>(isSigned ? 10 : 5),
                    static_cast<std::uint32_t>(parts.size() / 2)};
    for (const std::int64_t part : parts) {
        field.numbers.push_back(static_cast<std::uint32_t>(part));
    }
    return field;
}

std::vector<TiffField> thetaFields() {
    return {shortField(0x0001, 1),
            rationalField(0x0003, {-7, 10, 33, 10}),
            rationalField(0x0004, {45, 2}, false),
            shortField(0x0007, 1),
            asciiField(0x000A, "+09:00"),
            rationalField(0x0109, {1, 100, -2, 100, 3, 100}),
            shortField(0x1001, 415),
            shortField(0x1003, 402)};
}

void MadeExif::setLong(std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
        tiff.at(at + i) = static_cast<std::uint8_t>(value >> (8 * (isBigEndian ? 3 - i : i)));
    }
}

void MadeExif::setShort(std::size_t at, std::uint16_t value) {
    tiff.at(at + (isBigEndian ? 0 : 1)) = static_cast<std::uint8_t>(value >> 8);
    tiff.at(at + (isBigEndian ? 1 : 0)) = static_cast<std::uint8_t>(value);
}

MadeExif madeExif(const ExifForm& form) {
    TiffWriter writer(form.isBigEndian);
    MadeExif made;
    made.isBigEndian = form.isBigEndian;
    const std::size_t first = writer.directory(
        {asciiField(0x010F, "RICOH"), asciiField(0x0110, form.model), shortField(0x0112, form.orientation),
         asciiField(0x0131, form.model + " Ver 3.82.1"), longField(0x8769, 0)});
    made.exifDirectory = writer.directory(
        {rationalField(0x829A, {1, 250}, false), rationalField(0x829D, {20, 10}, false),
         shortField(0x8827, 100), asciiField(0x9003, "2026:01:02 03:04:05"), TiffField{0x927C, 7, 0, {0}}});
    made.makerNote = writer.bytes().size();
    writer.add("Ricoh\0\0\0"sv);
    made.ricohDirectory = writer.directory({asciiField(0x0001, "Rdc"), asciiField(0x0002, "Rev0382"),
                                            asciiField(0x0005, "00123456"), longField(0x4001, 0)});
    std::size_t noteEnd = writer.bytes().size();
    made.thetaDirectory = writer.directory(form.theta);
    if (form.isThetaInside) {
        noteEnd = writer.bytes().size();
    }
    made.tiff = writer.bytes();
    made.setLong(MadeExif::valueAt(first, 4), static_cast<std::uint32_t>(made.exifDirectory));
    const std::size_t note = MadeExif::valueAt(made.exifDirectory, 4);
    made.setLong(note, static_cast<std::uint32_t>(made.makerNote));
    made.setLong(note - 4, static_cast<std::uint32_t>(noteEnd - made.makerNote));
    made.setLong(MadeExif::valueAt(made.ricohDirectory, 3), static_cast<std::uint32_t>(made.thetaDirectory));
    return made;
}

std::string gpanoXmp(const std::string& properties) {
    return "<x:xmpmeta xmlns:x='adobe:ns:meta/' x:xmptk='RICOH THETA V Ver 3.82.1'>"
           "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'>"
           "<rdf:Description rdf:about='' xmlns:GPano='http://ns.google.com/photos/1.0/panorama/'>"
           "<GPano:ProjectionType>equirectangular</GPano:ProjectionType>"
           "<GPano:FullPanoWidthPixels>5376</GPano:FullPanoWidthPixels>" +
           properties + "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

std::string poseXmp(const std::string& pitch, const std::string& roll) {
    return "<GPano:PosePitchDegrees>" + pitch + "</GPano:PosePitchDegrees><GPano:PoseRollDegrees>" + roll +
           "</GPano:PoseRollDegrees>";
}

Bytes segment(std::uint8_t marker, std::string_view signature, ByteView content) {
    const std::size_t length = 2 + signature.size() + content.size();
    Bytes bytes{0xFF, marker, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length)};
    bytes.insert(bytes.end(), signature.begin(), signature.end());
    bytes.insert(bytes.end(), content.begin(), content.end());
    return bytes;
}

Bytes madePhoto(ByteView tiff, const std::string& xmp, int width, int height) {
    RgbImage picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.at(x, y)[0] = static_cast<std::uint8_t>(4 * x);
            picture.at(x, y)[1] = static_cast<std::uint8_t>(8 * y);
            picture.at(x, y)[2] = static_cast<std::uint8_t>(x * y);
        }
    }
    Bytes jpeg = jpeg::encode(picture, 90);
    Bytes front;
    const auto put = [&](const Bytes& bytes) { front.insert(front.end(), bytes.begin(), bytes.end()); };
    if (!tiff.empty()) {
        put(segment(jpeg::kApp1, "Exif\0\0"sv, tiff));
    }
    if (!xmp.empty()) {
        put(segment(jpeg::kApp1, "http://ns.adobe.com/xap/1.0/\0"sv, bytesOf(xmp)));
    }
    jpeg.insert(jpeg.begin() + 2, front.begin(), front.end());
    return jpeg;
}

Bytes madePhoto(const MadeExif& exif, const std::string& xmp) {
    return madePhoto(exif.tiff, xmp);
}

} // namespace spherewalk::test
