// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "picture/made_photo.h"
#include "random.h"

#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/position_tag.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

namespace spherewalk {
namespace {

photo::PhotoMetadata read(const std::string& xmp) {
    return photo::readMetadata(test::madePhoto(ByteView(), xmp), "a.jpg");
}

TEST(PhotoMetadata, ReadsExifOfBothByteOrders) {
    for (const bool isBigEndian : {false, true}) {
        const auto exif = test::madeExif({.isBigEndian = isBigEndian, .theta = test::thetaFields()});
        const auto metadata = photo::readMetadata(test::madePhoto(exif, ""), "a.jpg");
        EXPECT_EQ(metadata.width, 64);
        EXPECT_EQ(metadata.height, 32);
        EXPECT_EQ(metadata.make, "RICOH");
        EXPECT_EQ(metadata.model, "RICOH THETA V");
        EXPECT_EQ(metadata.software, "RICOH THETA V Ver 3.82.1");
        EXPECT_EQ(metadata.takenAt, "2026-01-02T03:04:05");
        EXPECT_EQ(metadata.timeZone, "+09:00");
        EXPECT_EQ(metadata.exposureS, 1.0 / 250);
        EXPECT_EQ(metadata.fNumber, 2.0);
        EXPECT_EQ(metadata.iso, 100);
        EXPECT_FALSE(metadata.panorama);
        EXPECT_TRUE(metadata.remarks.empty());
    }
}

TEST(PhotoMetadata, TellsNoLightUnlessAllOfTheExposureIsStated) {
    photo::PhotoMetadata metadata;
    EXPECT_FALSE(photo::exposureStops(metadata));
    metadata.exposureS = 0.5;
    metadata.fNumber = 2;
    EXPECT_FALSE(photo::exposureStops(metadata));
    metadata.iso = 100;
    EXPECT_NEAR(photo::exposureStops(metadata).value(), std::log2(12.5), 1e-12);
    metadata.fNumber = 0;
    EXPECT_FALSE(photo::exposureStops(metadata));
}

TEST(PhotoMetadata, TellsHowThePictureAsksToBeTurned) {
    for (const bool isBigEndian : {false, true}) {
        test::ExifForm form;
        form.isBigEndian = isBigEndian;
        EXPECT_EQ(photo::readMetadata(test::madePhoto(test::madeExif(form), ""), "a.jpg").orientation, 1);
        form.orientation = 6;
        EXPECT_EQ(photo::readMetadata(test::madePhoto(test::madeExif(form), ""), "a.jpg").orientation, 6);
        form.orientation = 77;
        EXPECT_EQ(photo::readMetadata(test::madePhoto(test::madeExif(form), ""), "a.jpg").orientation, 1);
    }
}

TEST(PhotoMetadata, IsEmptyForAJpegThatSaysNothing) {
    photo::PhotoMetadata expected;
    expected.width = 64;
    expected.height = 32;
    EXPECT_EQ(read(""), expected);
}

TEST(PhotoMetadata, ReadsPanoramaElementsAndAttributes) {
    const std::string attributes =
        "<x:xmpmeta xmlns:x='adobe:ns:meta/'><rdf:RDF "
        "xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'>"
        "<rdf:Description rdf:about='' xmlns:GPano='http://ns.google.com/photos/1.0/panorama/' "
        "GPano:ProjectionType='equirectangular' GPano:FullPanoWidthPixels='5376' "
        "GPano:PosePitchDegrees='17.0' "
        "GPano:PoseRollDegrees='-121.0' GPano:PoseHeadingDegrees='-90'/></rdf:RDF></x:xmpmeta>";
    const std::string elements = test::gpanoXmp(test::poseXmp("17.0", "-121.0") +
                                                "<GPano:PoseHeadingDegrees>270</GPano:PoseHeadingDegrees>");
    EXPECT_EQ(read(attributes), read(elements));
    const auto panorama = read(elements).panorama;
    ASSERT_TRUE(panorama && panorama->pitch && panorama->roll && panorama->heading);
    EXPECT_EQ(panorama->projection, "equirectangular");
    EXPECT_EQ(panorama->pitch->value(), 17);
    EXPECT_EQ(panorama->roll->value(), -121);
    EXPECT_EQ(panorama->heading->value(), 270);
    EXPECT_EQ(panorama->fullWidth, 5376);
    EXPECT_FALSE(panorama->fullHeight);
}

TEST(PhotoMetadata, IgnoresAndRemarksOnPosesThatAreNoNumbers) {
    for (const char* const text :
         {"nan", "inf", "-inf", "1e999", "3,5", "north", "0x10", "91", "1 2", "--1"}) {
        SCOPED_TRACE(text);
        const auto metadata = read(test::gpanoXmp(test::poseXmp(text, "2.5")));
        ASSERT_TRUE(metadata.panorama);
        EXPECT_FALSE(metadata.panorama->pitch);
        ASSERT_TRUE(metadata.panorama->roll);
        EXPECT_EQ(metadata.panorama->roll->value(), 2.5);
        EXPECT_EQ(metadata.remarks.size(), 1U);
    }
}

TEST(PhotoMetadata, RemarksOnXmpThatIsNone) {
    std::string deep;
    for (int i = 0; i < 5000; ++i) {
        deep += "<a>";
    }
    const std::string utf16("<\0x\0/\0>\0", 8);
    const std::string entities = "<!DOCTYPE x [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]><x>&b;</x>";
    for (const std::string& xmp :
         {std::string("garbage"), std::string("<x:xmpmeta"), deep, utf16, entities}) {
        SCOPED_TRACE(xmp.substr(0, 20));
        const auto metadata = read(xmp);
        EXPECT_FALSE(metadata.panorama);
        EXPECT_EQ(metadata.width, 64);
    }
    EXPECT_EQ(read(deep).remarks.size(), 1U);
    EXPECT_EQ(read(utf16).remarks.size(), 1U);
    EXPECT_EQ(read(entities).remarks.size(), 1U);
    EXPECT_EQ(read("<x:xmpmeta").remarks.size(), 1U);
}

TEST(PhotoMetadata, ADepthThatIsOnlyWrittenInCommentsOrTextsIsRead) {
    std::string comment = "<!--";
    for (int i = 0; i < 500; ++i) {
        comment += "<a>";
    }
    EXPECT_TRUE(read(test::gpanoXmp(comment + "-->")).panorama);
    EXPECT_TRUE(read("<?xpacket begin='' id='W5M0MpCehiHzreSzNTczkc9d'?>" + test::gpanoXmp("") +
                     "<?xpacket end='w'?>")
                    .panorama);
}

TEST(PhotoMetadata, IsRefusedForWhatIsNoJpeg) {
    test::expectError(ErrorKind::Corrupt, "a.jpg", [] { photo::readMetadata(bytesOf("<html>"), "a.jpg"); });
    test::expectError(ErrorKind::Corrupt, "a.jpg", [] { photo::readMetadata({}, "a.jpg"); });
}

TEST(PhotoMetadata, CanBeReadByManyThreadsAtATime) {
    const Bytes photo = test::madePhoto(test::madeExif({.theta = test::thetaFields()}),
                                        test::gpanoXmp(test::poseXmp("1.5", "-2")));
    const auto expected = photo::readMetadata(photo, "a.jpg");
    std::atomic<int> same = 0;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 8; ++i) {
            threads.emplace_back([&, i] {
                for (int round = 0; round < 50; ++round) {
                    const Bytes tagged = photo::withPositionTag(photo, {"s", i, "a", {1, 2, 3}, {}}, "a.jpg");
                    same += photo::readMetadata(tagged, "a.jpg") == expected &&
                                    photo::readPositionTag(tagged, "a.jpg")->stationId == i
                                ? 1
                                : 0;
                }
            });
        }
    }
    EXPECT_EQ(same, 400);
}

TEST(PhotoMetadata, DamagedMetadataNeverCrash) {
    test::Random random(424242);
    SCOPED_TRACE(random.seed());
    int read = 0;
    int tagged = 0;
    for (int round = 0; round < 4000; ++round) {
        const auto exif = test::madeExif(
            {.isBigEndian = round % 2 == 0, .isThetaInside = round % 4 < 2, .theta = test::thetaFields()});
        Bytes photo = test::madePhoto(exif, test::gpanoXmp(test::poseXmp("1.5", "-2")));
        const auto segments = jpeg::segments(photo, "a.jpg");
        const auto last = static_cast<int>(segments[2].offset);
        for (int i = random.integer(1, 6); i > 0; --i) {
            const auto at = static_cast<std::size_t>(random.integer(2, last));
            photo[at] = static_cast<std::uint8_t>(random.integer(0, 3) == 0 ? 0xFF : random.integer(0, 255));
        }
        try {
            photo::readMetadata(photo, "a.jpg");
            ++read;
            photo::readPositionTag(photo, "a.jpg");
            photo::withPositionTag(photo, {"s", 1, "a", {1, 2, 3}, {}}, "a.jpg");
            ++tagged;
        } catch (const Error& error) {
            // A frame header may turn into one of another kind of JPEG.
            EXPECT_TRUE(error.kind() == ErrorKind::Corrupt || error.kind() == ErrorKind::Unsupported)
                << error.sentence();
        }
    }
    EXPECT_GT(read, 3000);
    EXPECT_GT(tagged, 100);
}

} // namespace
} // namespace spherewalk
