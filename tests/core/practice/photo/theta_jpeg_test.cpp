// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/theta_jpeg.h"

#include <map>
#include <optional>

namespace spherewalk::practice {
namespace {

RgbImage grey() {
    RgbImage picture(512, 256);
    std::fill(picture.values().begin(), picture.values().end(), std::uint8_t{128});
    return picture;
}

/// The contents of the APP1 segments, in their order.
std::vector<Bytes> app1(const Bytes& file) {
    std::vector<Bytes> segments;
    std::size_t at = 2;
    while (at + 4 < file.size() && file[at] == 0xFF && file[at + 1] != 0xDA) {
        const std::size_t length = std::size_t{file[at + 2]} * 256 + file[at + 3];
        if (file[at + 1] == 0xE1) {
            segments.emplace_back(file.begin() + std::ptrdiff_t(at + 4),
                                  file.begin() + std::ptrdiff_t(at + 2 + length));
        }
        at += 2 + length;
    }
    return segments;
}

/// A TIFF reader as small as a test needs.
class Tiff {
  public:
    explicit Tiff(const Bytes& exif) : m_bytes(exif.begin() + 6, exif.end()), m_isBig(m_bytes.at(0) == 'M') {}

    bool isBig() const { return m_isBig; }

    std::uint32_t number(std::size_t at, int size) const {
        std::uint32_t value = 0;
        for (int i = 0; i < size; ++i) {
            value |= std::uint32_t{m_bytes.at(at + std::size_t(i))} << 8 * (m_isBig ? size - 1 - i : i);
        }
        return value;
    }

    struct Entry {
        std::uint32_t type;
        std::uint32_t count;
        std::size_t at; ///< of the value
    };

    std::map<std::uint32_t, Entry> directory(std::uint32_t at) const {
        std::map<std::uint32_t, Entry> entries;
        std::uint32_t last = 0;
        for (std::uint32_t i = 0; i < number(at, 2); ++i) {
            const std::uint32_t entry = at + 2 + 12 * i;
            const std::uint32_t type = number(entry + 2, 2);
            const std::uint32_t count = number(entry + 4, 4);
            const std::uint32_t unit = type == 3 ? 2 : type == 4 ? 4 : type == 5 || type == 10 ? 8 : 1;
            const std::uint32_t tag = number(entry, 2);
            EXPECT_GT(tag, last) << "tags must rise";
            last = tag;
            entries[tag] = {type, count, unit * count <= 4 ? entry + 8 : number(entry + 8, 4)};
        }
        return entries;
    }

    std::string ascii(const Entry& entry) const {
        EXPECT_EQ(m_bytes.at(entry.at + entry.count - 1), 0);
        return {m_bytes.begin() + std::ptrdiff_t(entry.at),
                m_bytes.begin() + std::ptrdiff_t(entry.at + entry.count - 1)};
    }

    double rational(const Entry& entry, std::size_t i) const {
        return double(std::int32_t(number(entry.at + 8 * i, 4))) / double(number(entry.at + 8 * i + 4, 4));
    }

    std::map<std::uint32_t, Entry> exif() const {
        return directory(number(directory(number(4, 4)).at(0x8769).at, 4));
    }

    std::map<std::uint32_t, Entry> theta() const {
        const Entry note = exif().at(0x927C);
        const auto maker = directory(std::uint32_t(note.at + 8));
        return directory(number(maker.at(0x4001).at, 4));
    }

    const Bytes& bytes() const { return m_bytes; }

  private:
    Bytes m_bytes;
    bool m_isBig;
};

ThetaTags tilted() {
    ThetaTags tags;
    tags.time = std::chrono::sys_days(std::chrono::year(2026) / 2 / 28) + std::chrono::hours(23);
    tags.timeZone = std::chrono::minutes(90);
    tags.posePitchDeg = 17.0;
    tags.poseRollDeg = -121.0;
    tags.inclinationPitchDeg = 17.0;
    tags.inclinationRollDeg = -121.0;
    tags.isoSpeed = 64;
    return tags;
}

class ThetaJpegVariants : public testing::TestWithParam<std::tuple<ThetaTags::ByteOrder, bool>> {};

TEST_P(ThetaJpegVariants, CarriesExifAndTheMakerNoteInBothByteOrders) {
    ThetaTags tags = tilted();
    std::tie(tags.byteOrder, tags.thetaIfdInsideMakerNote) = GetParam();
    const std::vector<Bytes> segments = app1(thetaJpeg(grey(), tags));
    ASSERT_EQ(segments.size(), 2U);
    const Tiff tiff(segments[0]);
    EXPECT_EQ(tiff.isBig(), tags.byteOrder == ThetaTags::ByteOrder::Big);
    const auto main = tiff.directory(tiff.number(4, 4));
    EXPECT_EQ(tiff.ascii(main.at(0x010F)), "RICOH");
    EXPECT_EQ(tiff.ascii(main.at(0x0110)), "RICOH THETA V");
    EXPECT_EQ(tiff.ascii(main.at(0x0132)), "2026:03:01 00:30:00") << "local time";
    const auto photo = tiff.exif();
    EXPECT_EQ(tiff.number(photo.at(0x8827).at, 2), 64U);
    EXPECT_EQ(tiff.number(photo.at(0xA002).at, 4), 512U);
    EXPECT_NEAR(tiff.rational(photo.at(0x829A), 0), 1.0 / 60, 1e-9);

    const auto note = photo.at(0x927C);
    EXPECT_EQ(std::string(tiff.bytes().begin() + std::ptrdiff_t(note.at),
                          tiff.bytes().begin() + std::ptrdiff_t(note.at + 5)),
              "Ricoh");
    const auto maker = tiff.directory(std::uint32_t(note.at + 8));
    EXPECT_EQ(tiff.ascii(maker.at(0x0001)), "Rdc");
    EXPECT_EQ(tiff.ascii(maker.at(0x0002)), "Rev3821");
    EXPECT_EQ(tiff.number(maker.at(0x4001).at, 4) < note.at + note.count, tags.thetaIfdInsideMakerNote);
    const auto theta = tiff.theta();
    EXPECT_EQ(tiff.number(theta.at(0x0001).at, 2), 1U);
    EXPECT_EQ(tiff.number(theta.at(0x0007).at, 2), 0U);
    EXPECT_EQ(tiff.ascii(theta.at(0x000A)), "+01:30");
    EXPECT_NEAR(tiff.rational(theta.at(0x0003), 0), -121, 1e-9);
    EXPECT_NEAR(tiff.rational(theta.at(0x0003), 1), 17, 1e-9);
    EXPECT_EQ(theta.at(0x0109).count, 3U);
}

INSTANTIATE_TEST_SUITE_P(All, ThetaJpegVariants,
                         testing::Combine(testing::Values(ThetaTags::ByteOrder::Big,
                                                          ThetaTags::ByteOrder::Little),
                                          testing::Bool()));

TEST(ThetaJpeg, CarriesThePoseAsXmpElements) {
    const std::vector<Bytes> segments = app1(thetaJpeg(grey(), tilted()));
    const std::string xmp(textOf(segments.at(1)));
    EXPECT_THAT(xmp, testing::StartsWith(std::string("http://ns.adobe.com/xap/1.0/\0", 29)));
    EXPECT_THAT(xmp, testing::HasSubstr("<GPano:PosePitchDegrees>17.0</GPano:PosePitchDegrees>"));
    EXPECT_THAT(xmp, testing::HasSubstr("<GPano:PoseRollDegrees>-121.0</GPano:PoseRollDegrees>"));
    EXPECT_THAT(xmp, testing::HasSubstr("<GPano:FullPanoWidthPixels>512</GPano:FullPanoWidthPixels>"));
    EXPECT_THAT(xmp, testing::Not(testing::HasSubstr("PoseHeading")));
}

TEST(ThetaJpeg, HoldsAThumbnailThatDecodes) {
    const Tiff tiff(app1(thetaJpeg(grey(), tilted())).at(0));
    const std::uint32_t main = tiff.number(4, 4);
    const auto second = tiff.directory(tiff.number(main + 2 + 12 * tiff.number(main, 2), 4));
    const std::uint32_t at = tiff.number(second.at(0x0201).at, 4);
    const std::uint32_t size = tiff.number(second.at(0x0202).at, 4);
    ASSERT_LE(at + size, tiff.bytes().size());
    const RgbImage thumbnail = jpeg::decode(ByteView(tiff.bytes()).subspan(at, size), "thumbnail");
    EXPECT_EQ(thumbnail.width(), 2 * thumbnail.height());
}

TEST(ThetaJpeg, DecodesToThePicture) {
    const Bytes file = thetaJpeg(grey(), tilted());
    EXPECT_EQ(jpeg::decode(file, "photo"), grey());
    EXPECT_EQ(file[file.size() - 2], 0xFF);
    EXPECT_EQ(file[file.size() - 1], 0xD9);
}

TEST(ThetaJpeg, LeavesOutWhatIsNotWanted) {
    ThetaTags tags = tilted();
    tags.withMakerNote = false;
    tags.withXmp = false;
    const std::vector<Bytes> segments = app1(thetaJpeg(grey(), tags));
    ASSERT_EQ(segments.size(), 1U);
    EXPECT_FALSE(Tiff(segments[0]).exif().contains(0x927C));
}

TEST(ThetaJpeg, RefusesPicturesThatAreNotSpherical) {
    test::expectError(ErrorKind::InvalidInput, "twice as wide", [] { thetaJpeg(RgbImage(300, 200), {}); });
    test::expectError(ErrorKind::InvalidInput, "twice as wide", [] { thetaJpeg({}, {}); });
}

} // namespace
} // namespace spherewalk::practice
