// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/file.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/position_tag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace spherewalk {
namespace {

const std::filesystem::path kFile = std::filesystem::path(SPHEREWALK_TEST_DATA) / "theta-s" / "rolled.jpg";

TEST(RealThetaS, SaysWhatTheCameraWrote) {
    const auto metadata = photo::readMetadata(readFile(kFile), kFile.string());
    EXPECT_EQ(metadata.make, "RICOH");
    EXPECT_EQ(metadata.model, "RICOH THETA S");
    EXPECT_EQ(metadata.software, "RICOH THETA S Ver 1.90");
    EXPECT_EQ(metadata.takenAt, "2026-07-20T06:15:37");
    EXPECT_EQ(metadata.timeZone, "-07:00");
    EXPECT_EQ(metadata.exposureS, 0.004);
    EXPECT_EQ(metadata.fNumber, 2);
    EXPECT_EQ(metadata.iso, 100);
    EXPECT_NEAR(exposureStops(metadata).value(), std::log2(0.004 * 100 / 4), 1e-12);
    EXPECT_TRUE(metadata.remarks.empty());
    ASSERT_TRUE(metadata.panorama && metadata.panorama->pitch && metadata.panorama->roll);
    EXPECT_EQ(metadata.panorama->projection, "equirectangular");
    EXPECT_EQ(metadata.panorama->fullWidth, 5376);
    EXPECT_EQ(metadata.panorama->pitch->value(), 3.4);
    EXPECT_EQ(metadata.panorama->roll->value(), 10.1);
    ASSERT_TRUE(metadata.theta);
    EXPECT_EQ(metadata.theta->firmware, "Rev0190");
    EXPECT_EQ(metadata.theta->imageType, 1);
    EXPECT_EQ(metadata.theta->isLevelled, false);
    EXPECT_FALSE(photo::isLevel(metadata));
}

TEST(RealThetaS, MakerNoteAndXmpAgreeOnTheTilt) {
    const auto metadata = photo::readMetadata(readFile(kFile), kFile.string());
    ASSERT_TRUE(metadata.theta && metadata.theta->inclinationPitch && metadata.theta->inclinationRoll);
    EXPECT_NEAR(metadata.theta->inclinationPitch->value(), metadata.panorama->pitch->value(), 1e-9);
    EXPECT_NEAR(metadata.theta->inclinationRoll->value(), metadata.panorama->roll->value(), 1e-9);
}

TEST(RealThetaS, KeepsAllOfItWhenTagged) {
    const Bytes photo = readFile(kFile);
    const Bytes tagged =
        photo::withPositionTag(photo, {"survey", 12, "C 4", {0.4, 0.6, 1.2}, {}}, kFile.string());
    EXPECT_EQ(photo::readMetadata(tagged, "tagged"), photo::readMetadata(photo, "photo"));
    ASSERT_TRUE(photo::readPositionTag(tagged, "tagged"));
    EXPECT_EQ(photo::readPositionTag(tagged, "tagged")->stationId, 12);
}

} // namespace
} // namespace spherewalk
