// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "structural_jpeg.h"

#include "spherewalk/camera/live_preview.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace spherewalk::camera {
namespace {

using test::structuralJpeg;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> framesOf(const std::string& stream, std::size_t step = SIZE_MAX,
                                  std::size_t maxFrameBytes = 4 << 20) {
    PreviewParser parser(maxFrameBytes);
    std::vector<std::string> frames;
    for (std::size_t at = 0; at < stream.size();) {
        const std::string_view piece = std::string_view(stream).substr(at, step);
        parser.feed(bytesOf(piece),
                    [&](const PreviewFrame& frame) { frames.emplace_back(textOf(frame.jpeg)); });
        at += piece.size();
    }
    return frames;
}

const std::string kFirst = structuralJpeg(640, 320, "first");
const std::string kSecond = structuralJpeg(1024, 512, "second");

TEST(PreviewParser, TakesThePicturesAsTheThetaFramesThem) {
    const auto part = [](const std::string& jpeg) {
        return "---osclivepreview---\r\nContent-type: image/jpeg\r\nContent-Length: " +
               std::to_string(jpeg.size()) + "\r\n\r\n" + jpeg + "\r\n\r\n";
    };
    EXPECT_THAT(framesOf(part(kFirst) + part(kSecond)), ElementsAre(kFirst, kSecond));
}

TEST(PreviewParser, TakesThePicturesAsMimeFramesThem) {
    const std::string stream = "preamble\r\n--cut\r\nContent-Type: image/jpeg\r\n\r\n" + kFirst +
                               "\r\n--cut\r\n\r\n" + kSecond + "\r\n--cut--\r\n";
    EXPECT_THAT(framesOf(stream), ElementsAre(kFirst, kSecond));
}

TEST(PreviewParser, NeedsNeitherBoundaryNorLengthNorOrderBetweenThem) {
    EXPECT_THAT(framesOf(kFirst + kSecond), ElementsAre(kFirst, kSecond));
    EXPECT_THAT(framesOf("Content-Length: 3\r\n\r\n" + kFirst + "Content-Length: 999999\r\n\r\n" + kSecond),
                ElementsAre(kFirst, kSecond));
    EXPECT_THAT(framesOf("\xff\xff\xd8 noise \xff" + kFirst + std::string(1000, '\xff') + kSecond),
                ElementsAre(kFirst, kSecond));
}

TEST(PreviewParser, GivesTheSameHoweverTheBytesAreCut) {
    const std::string stream = "--a\r\n\r\n" + kFirst + "\r\n--a\r\n" + kSecond;
    for (std::size_t step = 1; step < 40; ++step) {
        EXPECT_THAT(framesOf(stream, step), ElementsAre(kFirst, kSecond)) << "pieces of " << step;
    }
}

TEST(PreviewParser, ReadsTheSizeInTheHeader) {
    PreviewParser parser;
    PreviewFrame seen;
    parser.feed(bytesOf(kSecond), [&](PreviewFrame frame) { seen = std::move(frame); });
    EXPECT_EQ(seen.width, 1024);
    EXPECT_EQ(seen.height, 512);
}

TEST(PreviewParser, APictureThatIsCutOffCostsOnlyItself) {
    const std::string half = kFirst.substr(0, kFirst.size() - 4);
    EXPECT_THAT(framesOf(half + kSecond), ElementsAre(kSecond));
    EXPECT_THAT(framesOf(half + "\r\n--a\r\n\r\n" + kSecond), ElementsAre(kSecond));
}

TEST(PreviewParser, LeavesOutWhatIsTooLargeAndGoesOn) {
    const std::string large = structuralJpeg(640, 320, std::string(5000, 'x'));
    EXPECT_THAT(framesOf(large + kSecond, SIZE_MAX, 4000), ElementsAre(kSecond));
    const std::string endless = kFirst.substr(0, kFirst.size() - 2) + std::string(100'000, 'x');
    EXPECT_THAT(framesOf(endless + kSecond, SIZE_MAX, 4000), ElementsAre(kSecond));
}

TEST(PreviewParser, LeavesOutWhatNoDecoderShouldSee) {
    EXPECT_THAT(framesOf(structuralJpeg(0, 320)), IsEmpty());
    EXPECT_THAT(framesOf(structuralJpeg(65535, 65535)), IsEmpty());
    EXPECT_THAT(framesOf("\xff\xd8\xff\xd9"), IsEmpty());
    EXPECT_THAT(framesOf(std::string("\xff\xd8\xff\xe1\0\1", 6) + kFirst), ElementsAre(kFirst));
}

TEST(PreviewParser, WhateverComesFramesAreWholeAndSmall) {
    test::Random random(7);
    constexpr std::size_t kMost = 600;
    const std::vector<std::string> words{"\xff",   "\xd8", "\xff\xd8\xff", "\xff\xd9", "\xff\xda", "\xc0",
                                         "\0\x08", kFirst, kSecond,        "---osc",   "\r\n"};
    for (int round = 0; round < 300; ++round) {
        std::string stream;
        for (int i = 0; i < 40; ++i) {
            const int which = random.integer(0, static_cast<int>(words.size()) + 1);
            stream += which < static_cast<int>(words.size()) ? words[static_cast<std::size_t>(which)]
                                                             : std::string(1, char(random.integer(0, 255)));
        }
        for (const std::string& frame :
             framesOf(stream, static_cast<std::size_t>(random.integer(1, 50)), kMost)) {
            EXPECT_TRUE(frame.starts_with("\xff\xd8\xff") && frame.ends_with("\xff\xd9")) << random.seed();
            EXPECT_LE(frame.size(), kMost);
        }
    }
}

} // namespace
} // namespace spherewalk::camera
