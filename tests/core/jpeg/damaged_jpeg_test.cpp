// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "made_jpeg.h"
#include "random.h"

#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/restart.h"

#include <gtest/gtest.h>

namespace spherewalk {
namespace {

/// Calls and passes over an Error; true if there was none. Anything else ends the test.
template <class Call>
bool succeeds(Call&& call) {
    try {
        call();
        return true;
    } catch (const Error& error) {
        EXPECT_TRUE(error.kind() == ErrorKind::Corrupt || error.kind() == ErrorKind::Unsupported)
            << error.sentence();
        EXPECT_NE(error.sentence().find("flip.jpg"), std::string::npos) << error.sentence();
        return false;
    }
}

std::size_t frameOffset(const Bytes& jpeg) {
    for (const jpeg::Segment& segment : jpeg::segments(jpeg, "a.jpg")) {
        if (segment.marker >= jpeg::kSof0 && segment.marker <= jpeg::kSof2) {
            return segment.offset;
        }
    }
    return 0;
}

void setSize(Bytes& jpeg, int width, int height) {
    const std::size_t frame = frameOffset(jpeg);
    jpeg[frame + 5] = static_cast<std::uint8_t>(height >> 8);
    jpeg[frame + 6] = static_cast<std::uint8_t>(height);
    jpeg[frame + 7] = static_cast<std::uint8_t>(width >> 8);
    jpeg[frame + 8] = static_cast<std::uint8_t>(width);
}

class DamagedJpeg : public testing::TestWithParam<test::JpegForm> {};

TEST_P(DamagedJpeg, EveryTruncationIsCorrupt) {
    const Bytes jpeg = test::madeJpeg(test::madePicture(40, 24), GetParam());
    for (std::size_t size = 0; size < jpeg.size(); ++size) {
        SCOPED_TRACE(size);
        const ByteView part = ByteView(jpeg).first(size);
        test::expectError(ErrorKind::Corrupt, "cut.jpg", [&] { jpeg::decode(part, "cut.jpg"); });
        test::expectError(ErrorKind::Corrupt, "cut.jpg", [&] { jpeg::decode(part, "cut.jpg", 8); });
        test::expectError(ErrorKind::Corrupt, "cut.jpg",
                          [&] { jpeg::withRestartMarkers(part, 2, "cut.jpg"); });
    }
}

TEST_P(DamagedJpeg, FlippedBitsNeverCrash) {
    test::Random random(20260719);
    SCOPED_TRACE(random.seed());
    const Bytes jpeg = test::madeJpeg(test::madePicture(40, 24), GetParam());
    int decoded = 0;
    int refused = 0;
    for (int round = 0; round < 1500; ++round) {
        Bytes damaged = jpeg;
        for (int i = random.integer(1, 4); i > 0; --i) {
            const auto at = static_cast<std::size_t>(random.integer(2, static_cast<int>(jpeg.size()) - 1));
            damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1 << random.integer(0, 7)));
        }
        (succeeds([&] { jpeg::decode(damaged, "flip.jpg"); }) ? decoded : refused) += 1;
        succeeds([&] { jpeg::readInfo(damaged, "flip.jpg"); });
        succeeds([&] { jpeg::indexRestarts(damaged, "flip.jpg"); });
        succeeds([&] {
            const Bytes marked = jpeg::withRestartMarkers(damaged, 3, "flip.jpg");
            jpeg::serialised(jpeg::indexRestarts(marked, "flip.jpg"));
        });
    }
    EXPECT_GT(decoded, 0);
    EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Forms, DamagedJpeg,
                         testing::Values(test::JpegForm{.name = "420"},
                                         test::JpegForm{.name = "progressive", .isProgressive = true},
                                         test::JpegForm{
                                             .name = "restarts", .horizontal = 1, .restartInterval = 2}),
                         [](const auto& form) { return form.param.name; });

TEST(Jpeg, RefusesASizeThatTheBytesCannotHold) {
    Bytes jpeg = jpeg::encode(test::madePicture(16, 16), 90);
    setSize(jpeg, 16000, 16000);
    test::expectError(ErrorKind::Corrupt, "cannot hold", [&] { jpeg::decode(jpeg, "bomb.jpg"); });
    setSize(jpeg, 65500, 65500);
    test::expectError(ErrorKind::Unsupported, "more than this version",
                      [&] { jpeg::readInfo(jpeg, "bomb.jpg"); });
    setSize(jpeg, 0, 16);
    test::expectError(ErrorKind::Corrupt, "bomb.jpg", [&] { jpeg::readInfo(jpeg, "bomb.jpg"); });
}

TEST(Jpeg, RefusesAPictureOfHundredsOfScans) {
    const Bytes jpeg =
        test::madeJpeg(test::madePicture(16, 16), {.isGrey = true, .hasHundredsOfScans = true});
    test::expectError(ErrorKind::Corrupt, "number of scans", [&] { jpeg::decode(jpeg, "bomb.jpg"); });
    test::expectError(ErrorKind::Corrupt, "number of scans",
                      [&] { jpeg::withRestartMarkers(jpeg, 1, "bomb.jpg"); });
}

TEST(Jpeg, ReadsOnlyWhatIsAJpeg) {
    test::expectError(ErrorKind::Corrupt, "a.jpg", [] { jpeg::decode({}, "a.jpg"); });
    test::expectError(ErrorKind::Corrupt, "a.jpg",
                      [] { jpeg::decode(bytesOf("<html>hello</html>"), "a.jpg"); });
}

TEST(Jpeg, NamesCmykAsUnsupported) {
    // A frame header of four components, and nothing else that would be needed to decode it.
    const Bytes jpeg{0xFF, 0xD8, 0xFF, 0xC0, 0, 20,   8, 0, 8,    0, 8,    4,    1,    0x11,
                     0,    2,    0x11, 0,    3, 0x11, 0, 4, 0x11, 0, 0xFF, 0xDA, 0,    14,
                     4,    1,    0,    2,    0, 3,    0, 4, 0,    0, 63,   0,    0xFF, 0xD9};
    test::expectError(ErrorKind::Unsupported, "it is CMYK", [&] { jpeg::decode(jpeg, "a.jpg"); });
}

} // namespace
} // namespace spherewalk
