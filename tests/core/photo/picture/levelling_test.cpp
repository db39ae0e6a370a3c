// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/photo/metadata.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk {
namespace {

photo::PhotoMetadata of(const std::string& model, std::optional<bool> isLevelled, double pitch, double roll) {
    photo::PhotoMetadata metadata;
    metadata.model = model;
    metadata.panorama.emplace();
    metadata.panorama->pitch = Degrees(pitch);
    metadata.panorama->roll = Degrees(roll);
    if (isLevelled) {
        metadata.theta.emplace();
        metadata.theta->isLevelled = isLevelled;
    }
    return metadata;
}

TEST(Levelling, IsDecidedByTheMakerNote) {
    EXPECT_TRUE(photo::isLevel(of("RICOH THETA V", true, 17, -121)));
    EXPECT_FALSE(photo::isLevel(of("RICOH THETA V", false, 0, 0)));
    EXPECT_TRUE(photo::isLevel(of("RICOH THETA S", true, 3, 0)));
}

TEST(Levelling, WithoutAMakerNoteIsDecidedByCameraAndPose) {
    for (const char* const model :
         {"RICOH THETA V", "RICOH THETA SC2", "RICOH THETA Z1", "RICOH THETA X", "Other"}) {
        EXPECT_TRUE(photo::isLevel(of(model, {}, 0.4, -0.4))) << model;
        EXPECT_FALSE(photo::isLevel(of(model, {}, 0.6, 0))) << model;
        EXPECT_FALSE(photo::isLevel(of(model, {}, 0, -0.6))) << model;
    }
    EXPECT_FALSE(photo::isLevel(of("RICOH THETA S", {}, 0, 0)));
    EXPECT_FALSE(photo::isLevel(of("RICOH THETA SC", {}, 0, 0)));
}

TEST(Levelling, WithoutAnythingIsAssumedOfALevellingThetaOnly) {
    photo::PhotoMetadata metadata;
    EXPECT_FALSE(photo::isLevel(metadata));
    EXPECT_FALSE(photo::levelFromPhoto(metadata));
    metadata.model = "RICOH THETA V";
    EXPECT_TRUE(photo::isLevel(metadata));
    metadata.model = "RICOH THETA S";
    EXPECT_FALSE(photo::levelFromPhoto(metadata));
}

TEST(Levelling, OfALevelPhotoChangesNothing) {
    const auto level = photo::levelFromPhoto(of("RICOH THETA V", true, 17, -121));
    ASSERT_TRUE(level);
    EXPECT_EQ(angleBetween(*level, Eigen::Quaterniond::Identity()).value(), 0);
}

TEST(Levelling, APitchAboveZeroLooksUp) {
    const auto level = photo::levelFromPhoto(of("RICOH THETA S", false, 20, 0));
    ASSERT_TRUE(level);
    const SphericalDirection centre = sphericalDirection(*level * Eigen::Vector3d::UnitX());
    EXPECT_NEAR(Degrees(centre.elevation).value(), 20, 1e-9);
    EXPECT_NEAR(centre.azimuth.value(), 0, 1e-12);
}

TEST(Levelling, ARollAboveZeroLeansToTheRight) {
    const auto level = photo::levelFromPhoto(of("RICOH THETA S", false, 0, 10));
    ASSERT_TRUE(level);
    const SphericalDirection left = sphericalDirection(*level * Eigen::Vector3d::UnitY());
    EXPECT_NEAR(Degrees(left.elevation).value(), 10, 1e-9);
}

TEST(Levelling, KeepsTheHeadingAndRollsBeforeItPitches) {
    const auto level = photo::levelFromPhoto(of("RICOH THETA S", false, 20, -30));
    ASSERT_TRUE(level);
    const SphericalDirection centre = sphericalDirection(*level * Eigen::Vector3d::UnitX());
    EXPECT_NEAR(centre.azimuth.value(), 0, 1e-12);
    EXPECT_NEAR(Degrees(centre.elevation).value(), 20, 1e-9);
}

} // namespace
} // namespace spherewalk
