// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "made_jpeg.h"

#include "spherewalk/jpeg/jpeg.h"

#include <gtest/gtest.h>

namespace spherewalk {
namespace {

TEST(JpegSegments, FollowOneAnotherFromSoiToSos) {
    const Bytes jpeg = test::madeJpeg(test::madePicture(33, 20), {.applications = {Bytes(10, 7), Bytes()}});
    const auto found = jpeg::segments(jpeg, "a.jpg");
    std::size_t offset = 2;
    for (const jpeg::Segment& segment : found) {
        EXPECT_EQ(segment.offset, offset);
        EXPECT_EQ(jpeg[offset], 0xFF);
        EXPECT_EQ(jpeg[offset + 1], segment.marker);
        EXPECT_EQ(segment.marker == jpeg::kSos, &segment == &found.back());
        offset += segment.size;
    }
    ASSERT_GE(found.size(), 3U);
    EXPECT_EQ(found[0].marker, jpeg::kApp0);
    EXPECT_EQ(found[1].marker, jpeg::kApp1);
    EXPECT_EQ(found[1].content(jpeg).size(), 10U);
    EXPECT_EQ(found[1].content(jpeg).back(), 7);
    EXPECT_TRUE(found[2].content(jpeg).empty());
}

TEST(JpegSegments, PassOverFillBytes) {
    const Bytes jpeg{0xFF, 0xD8, 0xFF, 0xFF, 0xFF, 0xFE, 0, 3, 'a', 0xFF, 0x01, 0xFF, 0xDA, 0, 2};
    const std::vector<jpeg::Segment> expected{{jpeg::kCom, 4, 5}, {0x01, 9, 2}, {jpeg::kSos, 11, 4}};
    EXPECT_EQ(jpeg::segments(jpeg, "a.jpg"), expected);
}

TEST(JpegSegments, RefusesImpossibleLengthsAndMarkers) {
    const auto refused = [](const std::string& part, const Bytes& jpeg) {
        test::expectError(ErrorKind::Corrupt, part, [&] { jpeg::segments(jpeg, "a.jpg"); });
    };
    refused("it is not a JPEG", {});
    refused("it is not a JPEG", {0xFF});
    refused("it is not a JPEG", {0x89, 'P', 'N', 'G'});
    refused("it ends within", {0xFF, 0xD8});
    refused("it ends within", {0xFF, 0xD8, 0xFF, 0xFF});
    refused("impossible length", {0xFF, 0xD8, 0xFF, 0xE1, 0, 1, 0, 0});
    refused("impossible length", {0xFF, 0xD8, 0xFF, 0xE1, 0xFF, 0xFF, 0, 0});
    refused("impossible length", {0xFF, 0xD8, 0xFF, 0xE1, 0});
    refused("marker was expected", {0xFF, 0xD8, 0xFF, 0xFE, 0, 3, 'a', 'b', 0xFF, 0xDA, 0, 2});
    refused("no picture", {0xFF, 0xD8, 0xFF, 0xD9});
    refused("no picture", {0xFF, 0xD8, 0xFF, 0x00});
    refused("no picture", {0xFF, 0xD8, 0xFF, 0xD8});
}

TEST(JpegSegments, EveryTruncationIsRefused) {
    const Bytes jpeg = jpeg::encode(test::madePicture(16, 16), 80);
    const auto found = jpeg::segments(jpeg, "a.jpg");
    const std::size_t header = found.back().offset + found.back().size;
    for (std::size_t size = 0; size < header; ++size) {
        SCOPED_TRACE(size);
        test::expectError(ErrorKind::Corrupt, "a.jpg",
                          [&] { jpeg::segments(ByteView(jpeg).first(size), "a.jpg"); });
    }
}

} // namespace
} // namespace spherewalk
