// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/made_photo.h"

#include "spherewalk/photo/metadata.h"

#include <gtest/gtest.h>

namespace spherewalk {
namespace {

/// Both byte orders, with the Theta directory inside and outside of the maker note's bytes.
class MakerNote : public testing::TestWithParam<std::tuple<bool, bool>> {
  protected:
    test::MadeExif made(const std::vector<test::TiffField>& theta = test::thetaFields()) const {
        return test::madeExif({.isBigEndian = std::get<0>(GetParam()),
                               .isThetaInside = std::get<1>(GetParam()),
                               .theta = theta});
    }

    static std::optional<photo::ThetaMakerNote> read(const test::MadeExif& exif) {
        return photo::readMetadata(test::madePhoto(exif, ""), "a.jpg").theta;
    }

    std::optional<photo::ThetaMakerNote> read(const std::vector<test::TiffField>& theta) const {
        return read(made(theta));
    }
};

TEST_P(MakerNote, IsReadWithAllItsTags) {
    const auto note = read(made());
    ASSERT_TRUE(note);
    EXPECT_EQ(note->firmware, "Rev0382");
    EXPECT_EQ(note->serial, "00123456");
    EXPECT_EQ(note->imageType, 1);
    ASSERT_TRUE(note->inclinationRoll && note->inclinationPitch && note->compass && note->zenith);
    EXPECT_DOUBLE_EQ(note->inclinationRoll->value(), -0.7);
    EXPECT_DOUBLE_EQ(note->inclinationPitch->value(), 3.3);
    EXPECT_DOUBLE_EQ(note->compass->value(), 22.5);
    EXPECT_EQ(note->isLevelled, true);
    EXPECT_EQ(note->timeZone, "+09:00");
    EXPECT_EQ(*note->zenith, Eigen::Vector3d(0.01, -0.02, 0.03));
    EXPECT_EQ(note->frontSensorCelsius, 41.5);
    EXPECT_EQ(note->rearSensorCelsius, 40.2);
}

TEST_P(MakerNote, EveryTagIsOptional) {
    const auto all = test::thetaFields();
    for (std::size_t i = 0; i < all.size(); ++i) {
        auto fields = all;
        fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_TRUE(read(fields)) << i;
        EXPECT_NE(read(fields), read(all)) << i;
    }
    const auto none = read(std::vector<test::TiffField>());
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->isLevelled);
    EXPECT_EQ(none->serial, "00123456");
}

TEST_P(MakerNote, AnInclinationBeyondHalfATurnIsNegative) {
    const auto note = read({test::rationalField(0x0003, {3593, 10, 1800, 10}, false)});
    ASSERT_TRUE(note && note->inclinationRoll && note->inclinationPitch);
    EXPECT_NEAR(note->inclinationRoll->value(), -0.7, 1e-9);
    EXPECT_EQ(note->inclinationPitch->value(), 180);
}

TEST_P(MakerNote, ADenominatorOfZeroMakesTheValueAbsent) {
    const auto note = read({test::rationalField(0x0003, {-7, 0, 33, 10}), test::rationalField(0x0004, {0, 0}),
                            test::shortField(0x0007, 0), test::rationalField(0x0109, {1, 1, 1, 1, 1, 0})});
    ASSERT_TRUE(note);
    EXPECT_FALSE(note->inclinationRoll);
    EXPECT_FALSE(note->compass);
    EXPECT_FALSE(note->zenith);
    EXPECT_EQ(note->isLevelled, false);
}

TEST_P(MakerNote, ValuesThatMakeNoSenseAreAbsent) {
    const auto note = read({test::rationalField(0x0003, {4000, 1, 0, 1}),
                            test::rationalField(0x0004, {-1, 1}), test::shortField(0x0007, 7),
                            test::asciiField(0x000A, "Tokyo!"), test::asciiField(0x0109, "xyz")});
    ASSERT_TRUE(note);
    EXPECT_FALSE(note->inclinationRoll);
    EXPECT_TRUE(note->inclinationPitch);
    EXPECT_FALSE(note->compass);
    EXPECT_FALSE(note->isLevelled);
    EXPECT_EQ(note->timeZone, "");
    EXPECT_FALSE(note->zenith);
}

TEST_P(MakerNote, TooFewValuesAreAbsent) {
    const auto note =
        read({test::rationalField(0x0003, {-7, 10}), test::rationalField(0x0109, {1, 1, 1, 1})});
    ASSERT_TRUE(note);
    EXPECT_FALSE(note->inclinationRoll);
    EXPECT_FALSE(note->zenith);
}

TEST_P(MakerNote, OffsetsOutOfTheSegmentLeadNowhere) {
    for (const std::uint32_t offset : {0U, 1U, 0x7FFFFFFFU, 0xFFFFFFFFU, 0xFFFFFFF5U}) {
        SCOPED_TRACE(offset);
        test::MadeExif exif = made();
        exif.setLong(test::MadeExif::valueAt(exif.ricohDirectory, 3), offset);
        const auto note = read(exif);
        ASSERT_TRUE(note);
        EXPECT_FALSE(note->isLevelled);

        test::MadeExif zenith = made();
        zenith.setLong(test::MadeExif::valueAt(zenith.thetaDirectory, 5), offset | 0x10000U);
        ASSERT_TRUE(read(zenith));
        EXPECT_FALSE(read(zenith)->zenith);
        EXPECT_EQ(read(zenith)->isLevelled, true);
    }
    test::MadeExif end = made();
    end.setLong(test::MadeExif::valueAt(end.ricohDirectory, 3), static_cast<std::uint32_t>(end.tiff.size()));
    EXPECT_FALSE(read(end)->isLevelled);
    end.setLong(test::MadeExif::valueAt(end.ricohDirectory, 3),
                static_cast<std::uint32_t>(end.tiff.size() - 1));
    EXPECT_FALSE(read(end)->isLevelled);
}

TEST_P(MakerNote, HostileCountsAreRefused) {
    for (const std::uint32_t count : {0x20000000U, 0x20000001U, 0xFFFFFFFFU, 10000U}) {
        SCOPED_TRACE(count);
        test::MadeExif exif = made();
        exif.setLong(test::MadeExif::valueAt(exif.thetaDirectory, 5) - 4, count);
        ASSERT_TRUE(read(exif));
        EXPECT_FALSE(read(exif)->zenith);
    }
    test::MadeExif entries = made();
    entries.setShort(entries.thetaDirectory, 513);
    entries.tiff.resize(entries.tiff.size() + 12 * 600);
    ASSERT_TRUE(read(entries));
    EXPECT_FALSE(read(entries)->isLevelled);
    entries.setShort(entries.thetaDirectory, 512);
    EXPECT_EQ(read(entries)->isLevelled, true);
}

TEST_P(MakerNote, DirectoriesThatPointToOneAnotherEnd) {
    test::MadeExif exif = made();
    exif.setLong(test::MadeExif::valueAt(exif.ricohDirectory, 3),
                 static_cast<std::uint32_t>(exif.ricohDirectory));
    const auto note = read(exif);
    ASSERT_TRUE(note);
    EXPECT_FALSE(note->isLevelled);
    exif.setLong(test::MadeExif::valueAt(exif.ricohDirectory, 3),
                 static_cast<std::uint32_t>(exif.exifDirectory));
    EXPECT_TRUE(read(exif));
}

TEST_P(MakerNote, EveryTruncationIsRead) {
    const test::MadeExif whole = made();
    const auto expected = read(whole);
    for (std::size_t size = 0; size < whole.tiff.size(); ++size) {
        test::MadeExif cut = whole;
        cut.tiff.resize(size);
        const auto note = read(cut);
        EXPECT_TRUE(!note || note->isLevelled.value_or(true)) << size;
        EXPECT_TRUE(size + 24 > whole.tiff.size() || note != expected) << size;
    }
}

TEST_P(MakerNote, AnotherMakersNoteIsLeftAlone) {
    test::MadeExif exif = made();
    exif.tiff[exif.makerNote] = 'X';
    EXPECT_FALSE(read(exif));
}

INSTANTIATE_TEST_SUITE_P(Layouts, MakerNote, testing::Combine(testing::Bool(), testing::Bool()));

} // namespace
} // namespace spherewalk
