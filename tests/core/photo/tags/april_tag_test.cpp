// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/april_tag.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::photo {

using test::expectError;

namespace {

constexpr int kWidth = 2048;

/// The tag after a quarter turn.
TagCells turned(const TagCells& cells) {
    TagCells made;
    for (int row = 0; row < kTagCells; ++row) {
        for (int column = 0; column < kTagCells; ++column) {
            made[static_cast<std::size_t>(column * kTagCells + kTagCells - 1 - row)] =
                cells[static_cast<std::size_t>(row * kTagCells + column)];
        }
    }
    return made;
}

practice::PracticeRoom taggedRoom(const std::vector<practice::PracticeTag>& tags) {
    practice::PracticeRoomOptions options;
    options.tags = tags;
    return practice::PracticeRoom(options);
}

const std::vector<practice::PracticeTag>& wallTags() {
    static const std::vector<practice::PracticeTag> kTags =
        practice::tagsOnWalls(practice::PracticeRoom(), 5, 0.2);
    return kTags;
}

/// Root mean square of the corners' errors along an axis, in pixels.
double errorPx(const SeenTag& seen, const practice::PracticeTag& truth, const Rigid3& pose, double pixelRad) {
    double squares = 0;
    const auto corners = truth.cornersM();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        squares += (seen.directions[i] - (pose.inverse() * corners[i]).normalized()).squaredNorm();
    }
    return std::sqrt(squares / 8) / pixelRad;
}

} // namespace

TEST(AprilTag, NumbersDifferInElevenCellsHoweverTheyAreTurned) {
    FixedRandom random(36);
    for (int draw = 0; draw < 60; ++draw) {
        const int a = static_cast<int>(random.below(kTagNumbers));
        const int b = static_cast<int>(random.below(kTagNumbers));
        TagCells other = tagCells(b);
        for (int quarter = 0; quarter < 4; ++quarter, other = turned(other)) {
            if (a != b || quarter > 0) {
                EXPECT_GE((tagCells(a) ^ other).count(), 11U) << a << ", " << b << ", turned " << quarter;
            }
        }
    }
}

TEST(AprilTag, HasABlackRim) {
    const TagCells cells = tagCells(17);
    for (std::size_t i = 0; i < kTagCells; ++i) {
        EXPECT_FALSE(cells[i] || cells[8 * i] || cells[8 * i + 7] || cells[56 + i]);
    }
}

TEST(AprilTag, OfAnUnknownNumberIsRefused) {
    expectError(ErrorKind::InvalidInput, "0 to 586", [] { tagCells(-1); });
    expectError(ErrorKind::InvalidInput, "0 to 586", [] { tagCells(kTagNumbers); });
}

TEST(SeenTags, AreWhereTheyHangToATwelfthOfAPixel) {
    const practice::PracticeRoom room = taggedRoom(wallTags());
    FixedRandom random(7);
    std::size_t found = 0;
    for (int photo = 0; photo < 3; ++photo) {
        const Rigid3 pose{rotation({Radians(2 * std::numbers::pi * random.uniform()),
                                    Degrees(random.normal(3)), Degrees(random.normal(3))}),
                          {1.8 + random.uniform(), 1.5 + random.uniform(), 1.2}};
        const RgbImage picture =
            jpeg::decode(jpeg::encode(room.spherical(pose, {kWidth, kWidth / 2}), 92), "a photo");
        for (const SeenTag& tag : seenTags(picture)) {
            ASSERT_LT(tag.number, 5);
            const double pixelRad = 2 * std::numbers::pi / kWidth;
            const double error =
                errorPx(tag, wallTags()[static_cast<std::size_t>(tag.number)], pose, pixelRad);
            EXPECT_LT(error, 1 / 12.0) << "photo " << photo << ", tag " << tag.number;
            EXPECT_LT(error * pixelRad, 6 * tag.sigmaRad) << "photo " << photo << ", tag " << tag.number;
            EXPECT_LT(tag.sigmaRad, 0.15 * pixelRad);
            ++found;
        }
    }
    EXPECT_GE(found, 8U);
}

TEST(SeenTags, AreNoneInARoomWithoutTags) {
    const Rigid3 pose{Eigen::Quaterniond::Identity(), {2.2, 1.9, 1.2}};
    EXPECT_TRUE(seenTags(practice::PracticeRoom().spherical(pose, {kWidth, kWidth / 2})).empty());
}

TEST(SeenTags, AtThePhotosSeamAreSeenOnceAndWhole) {
    practice::PracticeTag tag = wallTags().front();
    const practice::PracticeRoom room = taggedRoom({tag});
    const Eigen::Vector3d eye =
        tag.centreM + 1.2 * Eigen::Vector3d(std::cos(tag.facing.value()), std::sin(tag.facing.value()), 0);
    // The photo looks as the tag does, so that its back, where the seam is, looks at the tag.
    const Rigid3 pose{yawRotation(tag.facing), eye};
    const std::vector<SeenTag> seen = seenTags(room.spherical(pose, {kWidth, kWidth / 2}));
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_LT(errorPx(seen.front(), tag, pose, 2 * std::numbers::pi / kWidth), 0.1);
}

TEST(SeenTags, AreFoundByACameraWithALens) {
    const practice::PracticeTag& tag = wallTags().front();
    const practice::PracticeRoom room = taggedRoom(wallTags());
    const CameraModel camera(
        {640, 480, 420, 420, 310, 245, LensModel::PlumbBob, {-0.25, 0.06, 0.001, -0.0005, 0}});
    for (const double aside : {-0.6, -0.2, 0.2}) {
        const Eigen::Vector3d out(std::cos(tag.facing.value()), std::sin(tag.facing.value()), 0);
        const Eigen::Vector3d eye = tag.centreM + 1.4 * out + aside * Eigen::Vector3d::UnitZ().cross(out);
        const Rigid3 pose{
            yawRotation(Radians(tag.facing.value() + std::numbers::pi + 0.1)) * bodyFromOptical(), eye};
        const std::vector<SeenTag> seen = seenTags(room.view(camera, pose), camera);
        const auto own = std::ranges::find(seen, tag.number, &SeenTag::number);
        ASSERT_NE(own, seen.end()) << aside;
        EXPECT_LT(errorPx(*own, tag, pose, 1 / 420.0), 1 / 12.0) << aside;
    }
}

TEST(SeenTags, ComeFromNothingWithoutHarm) {
    EXPECT_TRUE(seenTags(RgbImage(64, 32)).empty());
    EXPECT_TRUE(seenTags(RgbImage(2, 1)).empty());
    EXPECT_TRUE(seenTags(RgbImage(1, 1), CameraModel(CameraIntrinsics::pinhole(1, 1, 1))).empty());
    expectError(ErrorKind::InvalidInput, "twice as wide", [] { seenTags(RgbImage(64, 64)); });
    expectError(ErrorKind::InvalidInput, "twice as wide", [] { seenTags(RgbImage()); });
    expectError(ErrorKind::InvalidInput, "8 x 6",
                [] { seenTags(RgbImage(4, 4), CameraModel(CameraIntrinsics::pinhole(8, 6, 1))); });
}

} // namespace spherewalk::photo
