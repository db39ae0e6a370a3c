// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/hung_tags.h"

#include "spherewalk/align/room_tags.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spherewalk::align {

using testing::HasSubstr;

namespace {

constexpr double kSizeM = kHungM;
constexpr double kSigmaRad = 5e-5;

/// Photos in a room, and what they see of tags, with noise.
struct MadeSurvey {
    std::vector<std::optional<PlacedPhoto>> photos;
    std::vector<TagSighting> sightings;
    FixedRandom random;

    explicit MadeSurvey(std::uint64_t seed, int count = 9) : random(seed) {
        for (int i = 0; i < count; ++i) {
            const Radians yaw(2 * std::numbers::pi * random.uniform());
            photos.push_back(
                PlacedPhoto{{rotation({yaw, Degrees(random.normal(2)), Degrees(random.normal(2))}),
                             {1 + 0.6 * (i % 3), 1 + 0.6 * (i / 3), 1.2}},
                            {},
                            text("P", i)});
        }
    }

    void see(int photo, int number, const photo::TagCorners<Eigen::Vector3d>& corners) {
        const PlacedPhoto& from = *photos[static_cast<std::size_t>(photo)];
        photo::SeenTag tag;
        tag.number = number;
        tag.sigmaRad = kSigmaRad;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Eigen::Vector3d inPhoto = from.roomFromPhoto.inverse() * corners[i];
            const Eigen::Vector3d noise(random.normal(kSigmaRad), random.normal(kSigmaRad),
                                        random.normal(kSigmaRad));
            tag.directions[i] = (from.lenses.directionTo(inPhoto).normalized() + noise).normalized();
        }
        sightings.push_back({photo, tag});
    }

    void seeFromAll(int number, const photo::TagCorners<Eigen::Vector3d>& corners) {
        for (int photo = 0; photo < static_cast<int>(photos.size()); ++photo) {
            see(photo, number, corners);
        }
    }

    RoomTags tags() const { return roomTags(photos, sightings, kSizeM); }
};

double worstM(const RoomTag& tag, const photo::TagCorners<Eigen::Vector3d>& truth) {
    double worst = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        worst = std::max(worst, (tag.corners[i] - truth[i]).norm());
    }
    return worst;
}

} // namespace

TEST(RoomTags, AreWhereThePhotosSeeThem) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        MadeSurvey survey(seed);
        const auto south = hung({1.5, 0, 1.5}, Degrees(90));
        const auto east = hung({4, 2, 1.3}, Degrees(180));
        survey.seeFromAll(3, south);
        survey.seeFromAll(8, east);
        const RoomTags tags = survey.tags();
        ASSERT_EQ(tags.tags.size(), 2U) << seed;
        EXPECT_LT(worstM(tags.tags[0], south), 0.001) << seed;
        EXPECT_LT(worstM(tags.tags[1], east), 0.001) << seed;
        EXPECT_LT(worstM(tags.tags[0], south), 5 * tags.tags[0].sigma) << seed;
        EXPECT_EQ(tags.tags[0].photos, 9);
        ASSERT_TRUE(tags.scale);
        EXPECT_NEAR(tags.scale->value, 1, 4 * tags.scale->sigma) << seed;
        EXPECT_LT(tags.scale->sigma, 0.002) << seed;
        EXPECT_TRUE(tags.warnings.empty()) << tags.warnings.front();
    }
}

TEST(RoomTags, TellTheScaleOfThePlaces) {
    MadeSurvey survey(4);
    // Tapes that are 2 % too short: all places are, and with them the tag that they see.
    survey.seeFromAll(0, hung({1.5, 0, 1.5}, Degrees(90), 0.98 * kSizeM));
    const RoomTags tags = survey.tags();
    ASSERT_TRUE(tags.scale);
    EXPECT_NEAR(tags.scale->value, 0.98, 0.003);
}

TEST(RoomTags, RaysBeginAtTheLens) {
    MadeSurvey survey(5);
    for (auto& photo : survey.photos) {
        photo->lenses.aheadM = 0.012;
    }
    const auto south = hung({1.5, 0, 1.5}, Degrees(90));
    survey.seeFromAll(0, south);
    ASSERT_EQ(survey.tags().tags.size(), 1U);
    EXPECT_LT(worstM(survey.tags().tags[0], south), 0.001);
    for (auto& photo : survey.photos) {
        photo->lenses.aheadM = 0;
    }
    EXPECT_GT(worstM(survey.tags().tags[0], south), 0.002);
}

TEST(RoomTags, ANumberThatHangsTwiceIsNamed) {
    MadeSurvey survey(6);
    const auto south = hung({1.5, 0, 1.5}, Degrees(90));
    survey.seeFromAll(0, south);
    survey.see(2, 0, hung({4, 2, 1.3}, Degrees(180)));
    survey.see(7, 0, hung({4, 2, 1.3}, Degrees(180)));
    const RoomTags tags = survey.tags();
    ASSERT_EQ(tags.tags.size(), 1U);
    EXPECT_LT(worstM(tags.tags[0], south), 0.001);
    ASSERT_EQ(tags.warnings.size(), 1U);
    EXPECT_THAT(tags.warnings[0], HasSubstr("AprilTag 0 hangs in more than one place"));
    EXPECT_THAT(tags.warnings[0], HasSubstr("P2, P7"));
}

TEST(RoomTags, ThatOnePhotoSeesHaveNoPlace) {
    MadeSurvey survey(7);
    survey.see(1, 5, hung({1.5, 0, 1.5}, Degrees(90)));
    const RoomTags tags = survey.tags();
    EXPECT_TRUE(tags.tags.empty());
    EXPECT_FALSE(tags.scale);
    ASSERT_EQ(tags.warnings.size(), 1U);
    EXPECT_THAT(tags.warnings[0], HasSubstr("1 photo sees it (P1)"));
}

TEST(RoomTags, PhotosWithoutAPoseAndAtOnePlaceSayNothing) {
    MadeSurvey survey(8, 2);
    survey.photos[1]->roomFromPhoto.translation = survey.photos[0]->roomFromPhoto.translation;
    survey.seeFromAll(0, hung({1.5, 0, 1.5}, Degrees(90)));
    EXPECT_TRUE(survey.tags().tags.empty());
    survey.photos[0].reset();
    survey.photos[1].reset();
    EXPECT_TRUE(survey.tags().tags.empty());
    EXPECT_TRUE(roomTags({}, {}, kSizeM).tags.empty());
}

// A ruler's error is in all tags, however many there are.
TEST(RoomTags, AreMeasuredWithOneRuler) {
    MadeSurvey survey(14);
    for (int number = 0; number < 40; ++number) {
        survey.seeFromAll(number, hung({0.2 + 0.09 * number, 0, 1.5}, Degrees(90)));
    }
    const RoomTags tags = survey.tags();
    ASSERT_EQ(tags.tags.size(), 40U);
    EXPECT_GE(tags.scale->sigma, 0.001);
}

TEST(RoomTags, AreToldFromAPhotoWhosePoseErrs) {
    MadeSurvey survey(15);
    const auto south = hung({1.5, 0, 1.5}, Degrees(90));
    survey.seeFromAll(0, south);
    survey.photos[4]->roomFromPhoto.translation.x() += 0.3;
    const RoomTags tags = survey.tags();
    ASSERT_EQ(tags.tags.size(), 1U);
    EXPECT_LT(worstM(tags.tags[0], south), 0.001);
    EXPECT_EQ(tags.tags[0].photos, 8);
}

TEST(RoomTags, OfManyPhotosAreThoseOfMost) {
    MadeSurvey survey(16, 300);
    for (int photo = 0; photo < 300; ++photo) { // A third see another sheet with the same number.
        survey.photos[static_cast<std::size_t>(photo)]->roomFromPhoto.translation = {
            1 + 0.1 * (photo % 20), 1 + 0.1 * (photo / 20), 1.2};
        survey.see(photo, 0,
                   photo % 3 == 0 ? hung({4, 2, 1.3}, Degrees(180)) : hung({1.5, 0, 1.5}, Degrees(90)));
    }
    const RoomTags tags = survey.tags();
    ASSERT_EQ(tags.tags.size(), 1U);
    EXPECT_LT(worstM(tags.tags[0], hung({1.5, 0, 1.5}, Degrees(90))), 0.001);
    EXPECT_EQ(tags.tags[0].photos, 200);
}

TEST(RoomTags, LieFarFromTheOriginAsWell) {
    MadeSurvey survey(9);
    const Eigen::Vector3d far(1e6, -1e6, 0);
    for (auto& photo : survey.photos) {
        photo->roomFromPhoto.translation += far;
    }
    auto south = hung({1.5, 0, 1.5}, Degrees(90));
    for (Eigen::Vector3d& corner : south) {
        corner += far;
    }
    survey.seeFromAll(0, south);
    ASSERT_EQ(survey.tags().tags.size(), 1U);
    EXPECT_LT(worstM(survey.tags().tags[0], south), 0.001);
}

TEST(JoinTags, AddsTheCornersOfCommonTagsToPairs) {
    MadeSurvey survey(10, 3);
    survey.seeFromAll(0, hung({1.5, 0, 1.5}, Degrees(90)));
    survey.see(2, 0, hung({4, 2, 1.3}, Degrees(180))); // Twice in one photo: nobody knows which.
    std::vector<PhotoPair> pairs(2);
    pairs[0] = {0, 1, {}};
    pairs[1] = {1, 2, {}};
    joinTags(survey.sightings, pairs);
    ASSERT_EQ(pairs[0].matches.size(), 4U);
    EXPECT_TRUE(pairs[1].matches.empty());
    EXPECT_NE(pairs[0].matches[0].featureA, pairs[0].matches[1].featureA);
    EXPECT_EQ(pairs[0].matches[2].inB, survey.sightings[1].tag.directions[2]);
}

namespace {

std::vector<RoomTag> tagsAt(const Eigen::Vector3d& shift, double yaw, double scale, FixedRandom& random) {
    std::vector<RoomTag> made;
    const std::vector<std::pair<Eigen::Vector3d, Radians>> places = {{{1.5, 0, 1.5}, Degrees(90)},
                                                                     {{4, 2, 1.3}, Degrees(180)},
                                                                     {{0, 2.5, 1.6}, Degrees(0)},
                                                                     {{2.5, 4, 1.4}, Degrees(-90)}};
    for (const auto& [middle, facing] : places) {
        RoomTag tag;
        tag.number = static_cast<int>(made.size());
        tag.corners = hung(middle, facing);
        tag.sigma = 0.0005 * scale;
        for (Eigen::Vector3d& corner : tag.corners) {
            const Eigen::Vector3d noise(random.normal(2e-4), random.normal(2e-4), random.normal(2e-4));
            corner = scale * (yawRotation(Radians(yaw)) * (corner + noise) + shift);
        }
        made.push_back(tag);
    }
    return made;
}

} // namespace

TEST(TagJoin, FindsTheOtherFrame) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        FixedRandom random(seed);
        const auto other = tagsAt(Eigen::Vector3d::Zero(), 0, 1, random);
        const auto own = tagsAt({0.7, -2, 0.1}, 6 * random.uniform(), 3.7, random);
        const auto join = joinByTags(own, other);
        ASSERT_TRUE(join) << seed;
        EXPECT_EQ(join->numbers.size(), 4U);
        EXPECT_TRUE(join->moved.empty());
        EXPECT_NEAR(join->scale * 3.7, 1, 5e-4) << seed;
        EXPECT_LT(join->misfitM, 0.001) << seed;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const Eigen::Vector3d at = join->scale * (join->otherFromOwn.rotation * own[i].corners[0]) +
                                       join->otherFromOwn.translation;
            EXPECT_LT((at - other[i].corners[0]).norm(), 0.001) << seed;
        }
    }
}

TEST(TagJoin, NamesATagThatWasMoved) {
    FixedRandom random(11);
    const auto other = tagsAt(Eigen::Vector3d::Zero(), 0, 1, random);
    auto own = tagsAt({0.7, -2, 0.1}, 2, 1, random);
    for (Eigen::Vector3d& corner : own[2].corners) {
        corner.z() += 0.15;
    }
    const auto join = joinByTags(own, other);
    ASSERT_TRUE(join);
    EXPECT_EQ(join->moved, std::vector<int>{2});
    EXPECT_EQ(join->numbers, (std::vector<int>{0, 1, 3}));
    EXPECT_LT(join->misfitM, 0.001);
}

TEST(TagJoin, OneTagIsHelpedByWhatIsLevel) {
    FixedRandom random(12);
    const auto other = tagsAt(Eigen::Vector3d::Zero(), 0, 1, random);
    const auto own = tagsAt({0.7, -2, 0.1}, 2, 1, random);
    const auto join = joinByTags(std::span(own).first(1), other);
    ASSERT_TRUE(join);
    EXPECT_LT(std::abs((join->otherFromOwn.rotation * Eigen::Vector3d::UnitZ()).head<2>().norm()), 0.005);
}

TEST(TagJoin, NeedsACommonNumber) {
    FixedRandom random(13);
    const auto tags = tagsAt(Eigen::Vector3d::Zero(), 0, 1, random);
    EXPECT_FALSE(joinByTags(std::span(tags).first(2), std::span(tags).last(2)));
    EXPECT_FALSE(joinByTags({}, tags));
}

} // namespace spherewalk::align
