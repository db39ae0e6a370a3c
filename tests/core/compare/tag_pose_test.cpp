// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/compare/tag_pose.h"
#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace spherewalk::compare {

using testing::HasSubstr;

namespace {

render::DatasetTag hung(int number, const Eigen::Vector3d& middle, Radians facing) {
    const Eigen::Vector3d right =
        0.08 * Eigen::Vector3d(-std::sin(facing.value()), std::cos(facing.value()), 0);
    const Eigen::Vector3d up = 0.08 * Eigen::Vector3d::UnitZ();
    return {
        number, {middle - right + up, middle + right + up, middle + right - up, middle - right - up}, 1e-4};
}

photo::SeenTag seenFrom(const Rigid3& roomFromCamera, const render::DatasetTag& tag, double noiseRad,
                        FixedRandom& random) {
    photo::SeenTag seen;
    seen.number = tag.number;
    seen.sigmaRad = std::max(noiseRad, 1e-6);
    for (std::size_t i = 0; i < tag.cornersM.size(); ++i) {
        const Eigen::Vector3d noise(random.normal(noiseRad), random.normal(noiseRad),
                                    random.normal(noiseRad));
        seen.directions[i] = ((roomFromCamera.inverse() * tag.cornersM[i]).normalized() + noise).normalized();
    }
    return seen;
}

/// A camera so far from the tag on the south wall, looked at from this angle beside its normal.
Rigid3 lookingAt(double distanceM, Radians aside, FixedRandom& random) {
    const Radians heading(std::numbers::pi / 2 + aside.value());
    const Eigen::Vector3d out(std::cos(heading.value()), std::sin(heading.value()), 0);
    return {(rotation({Radians(heading.value() + std::numbers::pi + random.normal(0.1)),
                       Radians(random.normal(0.1)), Radians(random.normal(0.1))}) *
             bodyFromOptical())
                .normalized(),
            Eigen::Vector3d(2, 0, 1.5) + distanceM * out + Eigen::Vector3d(0, 0, random.normal(0.2))};
}

const render::DatasetTag kSouth = hung(4, {2, 0, 1.5}, Degrees(90));

} // namespace

TEST(TagPose, IsExactForExactCorners) {
    FixedRandom random(1);
    for (int i = 0; i < 30; ++i) {
        const Rigid3 truth =
            lookingAt(0.5 + 3 * random.uniform(), Degrees(120 * random.uniform() - 60), random);
        const std::vector seen{seenFrom(truth, kSouth, 0, random)};
        const TagRegistration found = registeredByTags(seen, std::span(&kSouth, 1));
        ASSERT_FALSE(found.poses.empty()) << i << found.why;
        EXPECT_EQ(found.poses.front().numbers, std::vector<int>{4});
        const Rigid3& pose = found.poses.front().roomFromCamera;
        EXPECT_LT((pose.translation - truth.translation).norm(), 1e-4) << i;
        EXPECT_LT(angleBetween(pose.rotation, truth.rotation), Radians(Degrees(0.01))) << i;
    }
}

TEST(TagPose, KnowsHowWellItIsKnown) {
    FixedRandom random(2);
    double squares = 0;
    constexpr int kDraws = 60;
    for (int i = 0; i < kDraws; ++i) {
        const Rigid3 truth = lookingAt(2, Degrees(45), random);
        const std::vector seen{seenFrom(truth, kSouth, 5e-5, random)};
        const TagPose pose = registeredByTags(seen, std::span(&kSouth, 1)).poses.front();
        squares += std::pow((pose.roomFromCamera.translation - truth.translation).norm() / pose.sigmaM, 2);
    }
    const double ratio = std::sqrt(squares / kDraws);
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 2);
}

TEST(TagPose, SeveralTagsAreFarBetterThanOne) {
    FixedRandom random(3);
    const std::vector known{kSouth, hung(5, {0.5, 0, 1.4}, Degrees(90)), hung(9, {3.4, 0, 1.6}, Degrees(90))};
    const Rigid3 truth = lookingAt(2, Degrees(10), random);
    std::vector<photo::SeenTag> seen;
    for (const render::DatasetTag& tag : known) {
        seen.push_back(seenFrom(truth, tag, 1e-4, random));
    }
    const TagRegistration all = registeredByTags(seen, known);
    const TagRegistration one = registeredByTags(std::span(seen).first(1), known);
    ASSERT_EQ(all.poses.size(), 1U);
    EXPECT_EQ(all.poses[0].numbers.size(), 3U);
    EXPECT_LT(3 * all.poses[0].sigmaM, one.poses[0].sigmaM);
    EXPECT_LT((all.poses[0].roomFromCamera.translation - truth.translation).norm(), 0.005);
}

TEST(TagPose, ATagThatWasMovedIsLeftOut) {
    FixedRandom random(4);
    const std::vector known{kSouth, hung(5, {0.5, 0, 1.4}, Degrees(90)), hung(9, {3.4, 0, 1.6}, Degrees(90))};
    const Rigid3 truth = lookingAt(2, Degrees(10), random);
    std::vector<photo::SeenTag> seen;
    for (const render::DatasetTag& tag : known) {
        seen.push_back(seenFrom(truth, tag, 5e-5, random));
    }
    seen[1] = seenFrom(truth, hung(5, {0.5, 0, 1.1}, Degrees(90)), 5e-5, random);
    const TagRegistration found = registeredByTags(seen, known);
    EXPECT_EQ(found.poses.front().numbers, (std::vector<int>{4, 9}));
    EXPECT_EQ(found.poses.front().moved, std::vector<int>{5});
    EXPECT_LT((found.poses.front().roomFromCamera.translation - truth.translation).norm(), 0.005);
}

// From far away a pose by one small tag misses the others, though none of them was moved.
TEST(TagPose, SmallTagsAreUsedTogether) {
    FixedRandom random(7);
    const std::vector known{kSouth, hung(5, {0.5, 0, 0.9}, Degrees(90)),
                            hung(9, {4, 1.5, 1.4}, Degrees(180))};
    for (int i = 0; i < 20; ++i) {
        const Rigid3 truth = lookingAt(3.5, Degrees(10), random);
        std::vector<photo::SeenTag> seen;
        for (const render::DatasetTag& tag : known) {
            seen.push_back(seenFrom(truth, tag, 4e-4, random));
        }
        const TagRegistration found = registeredByTags(seen, known);
        ASSERT_EQ(found.poses.size(), 1U) << i;
        const TagPose& pose = found.poses.front();
        EXPECT_EQ(pose.numbers.size(), 3U) << i;
        EXPECT_LT(pose.sigmaM, 0.03) << i;
        EXPECT_LT((pose.roomFromCamera.translation - truth.translation).norm(), 4 * pose.sigmaM) << i;
    }
}

// Nobody knows which of the two was moved: a view decides.
TEST(TagPose, TwoTagsThatContradictEachOtherGiveAPoseEach) {
    FixedRandom random(8);
    const std::vector known{kSouth, hung(9, {3.4, 0, 1.6}, Degrees(90))};
    const Rigid3 truth = lookingAt(2, Degrees(30), random);
    const std::vector seen{seenFrom(truth, kSouth, 5e-5, random),
                           seenFrom(truth, hung(9, {3.1, 0, 1.6}, Degrees(90)), 5e-5, random)};
    const TagRegistration found = registeredByTags(seen, known);
    std::set<int> used;
    for (const TagPose& pose : found.poses) {
        ASSERT_EQ(pose.numbers.size(), 1U);
        used.insert(pose.numbers.front());
    }
    EXPECT_EQ(used, (std::set<int>{4, 9}));
}

TEST(TagPose, OfATagWhoseCornersLieInOnePlaceIsNone) {
    FixedRandom random(9);
    const std::vector seen{seenFrom(lookingAt(2, Degrees(0), random), kSouth, 0, random)};
    render::DatasetTag point = kSouth;
    point.cornersM.fill(Eigen::Vector3d(2, 0, 1.5));
    render::DatasetTag line = kSouth;
    line.cornersM = {Eigen::Vector3d(1, 0, 1), {2, 0, 1}, {3, 0, 1}, {4, 0, 1}};
    EXPECT_TRUE(registeredByTags(seen, std::span(&point, 1)).poses.empty());
    EXPECT_THAT(registeredByTags(seen, std::span(&line, 1)).why, HasSubstr("contradict"));
}

TEST(TagPose, ASmallTagLeavesTwoPoses) {
    FixedRandom random(5);
    const Rigid3 truth = lookingAt(3.5, Degrees(15), random);
    const std::vector seen{seenFrom(truth, kSouth, 3e-4, random)};
    EXPECT_EQ(registeredByTags(seen, std::span(&kSouth, 1)).poses.size(), 2U);
}

TEST(TagPose, WithoutAKnownTagSaysWhy) {
    FixedRandom random(6);
    const std::vector seen{seenFrom(lookingAt(2, Degrees(0), random), kSouth, 0, random)};
    const render::DatasetTag other = hung(5, {0.5, 0, 1.4}, Degrees(90));
    EXPECT_THAT(registeredByTags(seen, {}).why, HasSubstr("--tag-size"));
    EXPECT_THAT(registeredByTags({}, std::span(&other, 1)).why, HasSubstr("shows no AprilTag"));
    EXPECT_THAT(registeredByTags(seen, std::span(&other, 1)).why, HasSubstr("of the picture (4)"));
    const std::vector twice{seen[0], seen[0]}; // Nobody knows which of the two is meant.
    EXPECT_THAT(registeredByTags(twice, std::span(&kSouth, 1)).why, HasSubstr("shows a tag twice"));
}

} // namespace spherewalk::compare
