// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "picture/made_photo.h"
#include "random.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/position_tag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace spherewalk {
namespace {

using photo::PositionTag;

const PositionTag kTag{"b8c0", 7, "A 3", {1.25, -0.5, 1.2}, {}};

void expectSame(const std::optional<PositionTag>& got, const PositionTag& expected) {
    ASSERT_TRUE(got);
    EXPECT_EQ(got->surveyId, expected.surveyId);
    EXPECT_EQ(got->stationId, expected.stationId);
    EXPECT_EQ(got->stationName, expected.stationName);
    EXPECT_EQ(got->positionM, expected.positionM);
    ASSERT_EQ(got->roomFromPhoto.has_value(), expected.roomFromPhoto.has_value());
    if (expected.roomFromPhoto) {
        EXPECT_LT(angleBetween(*got->roomFromPhoto, *expected.roomFromPhoto).value(), 1e-12);
    }
}

/// All but the XMP segment.
Bytes withoutXmp(const Bytes& jpeg) {
    Bytes rest;
    std::size_t end = 0;
    for (const jpeg::Segment& segment : jpeg::segments(jpeg, "a.jpg")) {
        const bool isXmp = textOf(segment.content(jpeg)).starts_with("http://ns.adobe.com/xap/1.0/");
        if (!isXmp) {
            rest.insert(rest.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(end),
                        jpeg.begin() + static_cast<std::ptrdiff_t>(segment.offset + segment.size));
        }
        end = segment.offset + segment.size;
    }
    rest.insert(rest.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(end), jpeg.end());
    return rest;
}

TEST(PositionTag, IsReadAsItWasWritten) {
    test::Random random(11);
    SCOPED_TRACE(random.seed());
    const Bytes photo = test::madePhoto(test::madeExif({.theta = test::thetaFields()}), test::gpanoXmp(""));
    for (int i = 0; i < 100; ++i) {
        PositionTag tag{
            "survey", random.integer(-5, 1000000), "A " + std::to_string(i), random.vector(1e6), {}};
        if (i % 2 == 0) {
            tag.roomFromPhoto = random.rotation();
        }
        expectSame(photo::readPositionTag(photo::withPositionTag(photo, tag, "a.jpg"), "a.jpg"), tag);
    }
}

TEST(PositionTag, StatesTheRotationAsThePanoramasPoseToo) {
    test::Random random(12);
    SCOPED_TRACE(random.seed());
    const Bytes photo = test::madePhoto(ByteView(), test::gpanoXmp(test::poseXmp("1.5", "-2.5")));
    for (int i = 0; i < 50; ++i) {
        const YawPitchRoll angles{Radians(random.uniform(-3.14, 3.14)), Radians(random.uniform(-1.5, 1.5)),
                                  Radians(random.uniform(-3.1, 3.1))};
        const PositionTag tag{"survey", 1, "", Eigen::Vector3d::Zero(), rotation(angles), true};
        const Bytes tagged = photo::withPositionTag(photo, tag, "a.jpg");
        const auto said = photo::readMetadata(tagged, "a.jpg").panorama;
        ASSERT_TRUE(said && said->heading && said->pitch && said->roll);
        EXPECT_EQ(said->projection, "equirectangular");
        EXPECT_NEAR(wrapped(Radians(Degrees(90 - said->heading->value())) - angles.yaw).value(), 0, 2e-6);
        EXPECT_NEAR(-Radians(*said->pitch).value(), angles.pitch.value(), 2e-6);
        EXPECT_NEAR(Radians(*said->roll).value(), angles.roll.value(), 2e-6);
        // Once more: what was there is replaced.
        EXPECT_EQ(photo::withPositionTag(tagged, tag, "a.jpg"), tagged);
    }
    const auto kept = photo::readMetadata(photo::withPositionTag(photo, kTag, "a.jpg"), "a.jpg").panorama;
    EXPECT_EQ(kept->pitch, Degrees(1.5));
}

TEST(PositionTag, KeepsExtremesAndForeignLetters) {
    const Bytes photo = test::madePhoto(ByteView(), "");
    PositionTag tag{"<&>\"' ]]> \xc3\xa9\xe6\xbc\xa2",
                    std::numeric_limits<std::int64_t>::min(),
                    "",
                    {-0.0, 1e300, 5e-324},
                    {}};
    expectSame(photo::readPositionTag(photo::withPositionTag(photo, tag, "a.jpg"), "a.jpg"), tag);
    tag.stationId = std::numeric_limits<std::int64_t>::max();
    tag.stationName = std::string(200, 'n');
    expectSame(photo::readPositionTag(photo::withPositionTag(photo, tag, "a.jpg"), "a.jpg"), tag);
}

TEST(PositionTag, LeavesAllButTheXmpByteForByte) {
    for (const bool isInside : {false, true}) {
        for (const std::string& xmp : {std::string(), test::gpanoXmp(test::poseXmp("1.5", "-2"))}) {
            Bytes photo = test::madePhoto(
                test::madeExif({.isThetaInside = isInside, .theta = test::thetaFields()}), xmp);
            const Bytes more = test::segment(0xE2, "MPF", bytesOf("abc"));
            photo.insert(photo.begin() + 2, more.begin(), more.end());
            photo.insert(photo.end(), {0, 0, 0});
            const Bytes tagged = photo::withPositionTag(photo, kTag, "a.jpg");
            EXPECT_EQ(withoutXmp(tagged), withoutXmp(photo));
            EXPECT_EQ(photo::readMetadata(tagged, "a.jpg"), photo::readMetadata(photo, "a.jpg"));
            EXPECT_EQ(jpeg::decode(tagged, "a"), jpeg::decode(photo, "a"));
        }
    }
}

TEST(PositionTag, StandsBehindExif) {
    const Bytes photo = test::madePhoto(test::madeExif({}), "");
    const auto segments = jpeg::segments(photo::withPositionTag(photo, kTag, "a.jpg"), "a.jpg");
    EXPECT_EQ(segments[0].marker, jpeg::kApp1);
    EXPECT_EQ(segments[1].marker, jpeg::kApp1);
    EXPECT_EQ(segments[2].marker, jpeg::kApp0);
    const Bytes bare = test::madePhoto(ByteView(), "");
    const auto others = jpeg::segments(photo::withPositionTag(bare, kTag, "a.jpg"), "a.jpg");
    EXPECT_EQ(others[0].marker, jpeg::kApp0);
    EXPECT_EQ(others[1].marker, jpeg::kApp1);
}

TEST(PositionTag, ReplacesAnEarlierOne) {
    const Bytes photo = test::madePhoto(ByteView(), test::gpanoXmp(""));
    PositionTag first = kTag;
    first.roomFromPhoto = Eigen::Quaterniond(1, 0, 0, 0);
    const Bytes once = photo::withPositionTag(photo, first, "a.jpg");
    PositionTag second{"other", 8, "", {9, 8, 7}, {}};
    const Bytes twice = photo::withPositionTag(once, second, "a.jpg");
    expectSame(photo::readPositionTag(twice, "a.jpg"), second);
    EXPECT_EQ(twice, photo::withPositionTag(twice, second, "a.jpg"));
    EXPECT_EQ(twice, photo::withPositionTag(photo, second, "a.jpg"));
}

TEST(PositionTag, KeepsForeignPropertiesOfEveryShape) {
    const std::string shapes =
        "<dc:title xmlns:dc='http://purl.org/dc/elements/1.1/'><rdf:Alt><rdf:li "
        "xml:lang='x-default'>T</rdf:li>"
        "<rdf:li xml:lang='de'>U</rdf:li></rdf:Alt></dc:title>"
        "<dc:subject "
        "xmlns:dc='http://purl.org/dc/elements/1.1/'><rdf:Bag><rdf:li>a</rdf:li><rdf:li>b</rdf:li>"
        "</rdf:Bag></dc:subject>"
        "<my:thing xmlns:my='http://example.org/my/' "
        "rdf:parseType='Resource'><my:part>5</my:part></my:thing>";
    const Bytes photo = test::madePhoto(ByteView(), test::gpanoXmp(shapes));
    const Bytes tagged = photo::withPositionTag(photo, kTag, "a.jpg");
    for (const char* const part :
         {">T<", ">U<", ">a<", ">b<", "my:part", "http://example.org/my/", ">5<", "5376"}) {
        EXPECT_NE(textOf(tagged).find(part), std::string_view::npos) << part;
    }
}

TEST(PositionTag, IsNotConfusedByAForeignNamespaceOfItsPrefix) {
    const std::string clash =
        "<spherewalk:SurveyId xmlns:spherewalk='http://example.org/other/'>x</spherewalk:SurveyId>";
    const Bytes photo = test::madePhoto(ByteView(), test::gpanoXmp(clash));
    EXPECT_FALSE(photo::readPositionTag(photo, "a.jpg"));
    test::expectError(ErrorKind::Corrupt, "prefix", [&] { photo::withPositionTag(photo, kTag, "a.jpg"); });
}

TEST(PositionTag, IsWrittenAndReadAfterPhotosThatTookItsPrefix) {
    const auto hostile = [](const std::string& prefix) {
        return test::madePhoto(ByteView(),
                               test::gpanoXmp("<" + prefix + ":Any xmlns:" + prefix +
                                              "='http://example.org/other/'>x</" + prefix + ":Any>"));
    };
    const Bytes photo = test::madePhoto(ByteView(), test::gpanoXmp(test::poseXmp("1.5", "-2")));
    for (const char* const prefix : {"spherewalk", "GPano", "rdf", "x", "xmp", "exif"}) {
        SCOPED_TRACE(prefix);
        photo::readPositionTag(hostile(prefix), "hostile.jpg");
        const Bytes tagged = photo::withPositionTag(photo, kTag, "a.jpg");
        expectSame(photo::readPositionTag(tagged, "a.jpg"), kTag);
        EXPECT_EQ(photo::readMetadata(tagged, "a.jpg"), photo::readMetadata(photo, "a.jpg"));
        EXPECT_NE(textOf(tagged).find(photo::kTagNamespace), std::string_view::npos);
        EXPECT_NE(textOf(tagged).find("<GPano:PosePitchDegrees>1.5<"), std::string_view::npos);
    }
}

TEST(PositionTag, IsAbsentWhereItMakesNoSense) {
    const auto tagged = [](const std::string& id, const std::string& station, const std::string& x) {
        return test::madePhoto(
            ByteView(),
            test::gpanoXmp(
                "<s:SurveyId xmlns:s='http://spherewalk.org/ns/survey/1.0/'>" + id +
                "</s:SurveyId><s:StationId xmlns:s='http://spherewalk.org/ns/survey/1.0/'>" + station +
                "</s:StationId><s:PositionX xmlns:s='http://spherewalk.org/ns/survey/1.0/'>" + x +
                "</s:PositionX><s:PositionY xmlns:s='http://spherewalk.org/ns/survey/1.0/'>2"
                "</s:PositionY><s:PositionZ xmlns:s='http://spherewalk.org/ns/survey/1.0/'>3</s:PositionZ>"));
    };
    EXPECT_TRUE(photo::readPositionTag(tagged("a", "1", "1.5"), "a.jpg"));
    for (const auto& [id, station, x] :
         {std::array{"", "1", "1"}, std::array{"a", "1.5", "1"}, std::array{"a", "99999999999999999999", "1"},
          std::array{"a", "1", "nan"}, std::array{"a", "1", "inf"}, std::array{"a", "1", ""}}) {
        EXPECT_FALSE(photo::readPositionTag(tagged(id, station, x), "a.jpg"))
            << id << "," << station << "," << x;
    }
    EXPECT_FALSE(photo::readPositionTag(test::madePhoto(ByteView(), ""), "a.jpg"));
    EXPECT_FALSE(photo::readPositionTag(test::madePhoto(ByteView(), "garbage <"), "a.jpg"));
}

TEST(PositionTag, OutOfRangeIsRefused) {
    const Bytes photo = test::madePhoto(ByteView(), "");
    const auto refused = [&](const std::string& part, const PositionTag& tag) {
        test::expectError(ErrorKind::InvalidInput, part,
                          [&] { photo::withPositionTag(photo, tag, "a.jpg"); });
    };
    refused("survey id", {"", 1, "a", {0, 0, 0}, {}});
    refused("printable", {"s", 1, "a\nb", {0, 0, 0}, {}});
    refused("printable", {"s", 1, "\xff", {0, 0, 0}, {}});
    refused("printable", {"s", 1, std::string(201, 'x'), {0, 0, 0}, {}});
    refused("not a number", {"s", 1, "a", {0, std::nan(""), 0}, {}});
    refused("not a number", {"s", 1, "a", {0, 0, HUGE_VAL}, {}});
    refused("unit quaternion", {"s", 1, "a", {0, 0, 0}, Eigen::Quaterniond(2, 0, 0, 0)});
}

TEST(PositionTag, IsRefusedWhereXmpIsDamagedOrFull) {
    const Bytes damaged = test::madePhoto(ByteView(), "<x:xmpmeta");
    test::expectError(ErrorKind::Corrupt, "XMP of a.jpg",
                      [&] { photo::withPositionTag(damaged, kTag, "a.jpg"); });
    const Bytes full =
        test::madePhoto(ByteView(), test::gpanoXmp("<GPano:StitchingSoftware>" + std::string(64600, 'x') +
                                                   "</GPano:StitchingSoftware>"));
    test::expectError(ErrorKind::Unsupported, "more than a JPEG can hold",
                      [&] { photo::withPositionTag(full, kTag, "a.jpg"); });
    test::expectError(ErrorKind::Corrupt, "a.jpg", [&] { photo::withPositionTag({}, kTag, "a.jpg"); });
}

} // namespace
} // namespace spherewalk
