// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/furnished_survey.h"
#include "expect_error.h"
#include "random.h"

#include "spherewalk/align/agreeing_parts.h"
#include "spherewalk/align/content_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace spherewalk::align {

using test::expectError;
using ::testing::Each;

namespace {

const Eigen::Vector3d kMoved(0.5, 0.3, 0);

/// The place on the first ray that is nearest to the second.
Eigen::Vector3d nearestToBoth(const Rigid3& a, const Eigen::Vector3d& inA, const Rigid3& b,
                              const Eigen::Vector3d& inB) {
    const Eigen::Vector3d ray = a.rotation * inA;
    const Eigen::Vector3d other = b.rotation * inB;
    const Eigen::Vector3d way = b.translation - a.translation;
    const double cosine = ray.dot(other);
    const double along = (ray.dot(way) - cosine * other.dot(way)) / std::max(1 - cosine * cosine, 1e-12);
    return a.translation + along * ray;
}

} // namespace

class AgreeingParts : public ::testing::Test {
  protected:
    AgreeingParts() { survey.expose(random); }

    std::vector<int> parts(double leastShare) const {
        std::vector<bool> isPlaced;
        for (const std::optional<Rigid3>& pose : survey.roomFromPhoto) {
            isPlaced.push_back(pose.has_value());
        }
        return agreeingParts(isPlaced,
                             photoAgreements(survey.roomFromPhoto, survey.pairs,
                                             fittingMatches(survey.roomFromPhoto, survey.pairs)),
                             leastShare);
    }

    /// Moves all photos from this one on, as if they had been joined by something that is there twice.
    void moveFrom(std::size_t first) {
        for (std::size_t i = first; i < survey.roomFromPhoto.size(); ++i) {
            survey.roomFromPhoto[i]->translation += kMoved;
        }
    }

    test::Random random{77};
    FurnishedSurvey survey{{4, 5, 0.4}, random};
};

TEST_F(AgreeingParts, AreOneWherePhotosShowTheSame) {
    EXPECT_THAT(parts(0.3), Each(0));
    EXPECT_THAT(parts(0.5), Each(0));
}

TEST_F(AgreeingParts, AreTwoWhereHalfOfThePhotosStandElsewhere) {
    moveFrom(12);
    const std::vector<int> found = parts(0.3);
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i], i < 12 ? 0 : 1) << i;
    }
}

TEST_F(AgreeingParts, AreTwoAlsoWhereOnePhotoAgreesWithBothSides) {
    const std::vector<std::optional<Rigid3>> truth = survey.roomFromPhoto;
    moveFrom(12);
    // A photo at the place of the seventh, that also shows the things of the other side where they would
    // stand.
    const auto between = static_cast<int>(truth.size());
    const Rigid3 pose = *truth[6];
    survey.roomFromPhoto.emplace_back(pose);
    std::vector<PhotoPair> more;
    for (PhotoPair pair : survey.pairs) {
        if (pair.a == 6 && pair.b < 12) {
            pair.a = between;
            more.push_back(pair);
        } else if (pair.a == 13) {
            pair.a = between;
            for (Correspondence& match : pair.matches) {
                const auto& other = *truth[static_cast<std::size_t>(pair.b)];
                const Eigen::Vector3d thing = nearestToBoth(*truth[13], match.inA, other, match.inB);
                match.inA = (pose.inverse() * (thing + kMoved)).normalized();
                match.featureA += 100000;
            }
            more.push_back(pair);
        }
    }
    survey.pairs.insert(survey.pairs.end(), more.begin(), more.end());
    const std::vector<int> found = parts(0.3);

    EXPECT_THAT(std::set(found.begin(), found.begin() + 12), ::testing::SizeIs(1));
    EXPECT_THAT(std::set(found.begin() + 12, found.begin() + between), ::testing::SizeIs(1));
    EXPECT_NE(found[0], found[12]);
}

TEST_F(AgreeingParts, AreTwoWherePhotosBesideEachOtherShowLessThanUsual) {
    const PhotoAgreement one{0, 1, 100, 200, 0.5, 2};
    const PhotoAgreement other{2, 3, 100, 200, 0.5, 2};
    const PhotoAgreement third{4, 5, 100, 200, 0.5, 2};
    const PhotoAgreement fourth{6, 7, 100, 200, 0.5, 2};
    const PhotoAgreement farAway{0, 3, 100, 90, 1.2, 0.95};
    const PhotoAgreement farther{3, 4, 100, 90, 1.2, 0.95};
    const PhotoAgreement farthest{5, 6, 100, 90, 1.2, 0.95};
    PhotoAgreement beside{1, 2, 100, 70, 0.4, 0.8};
    double besideM = 0.6;
    const auto found = [&] {
        return agreeingParts(std::vector<bool>(8, true),
                             std::vector{one, other, third, fourth, farAway, farther, farthest, beside}, 0.3,
                             besideM);
    };
    EXPECT_THAT(found(), ::testing::ElementsAre(1, 1, 0, 0, 0, 0, 0, 0));
    beside.betterShare = 1.1; // One of them is blurred.
    EXPECT_THAT(found(), Each(0));
    beside.betterShare = 0.8;
    beside.apartM = 0.7; // A wall may be between them.
    EXPECT_THAT(found(), Each(0));
    beside.apartM = 0.4;
    besideM = 0; // How long anything is, is not known.
    EXPECT_THAT(found(), Each(0));
}

TEST_F(AgreeingParts, AreOneWhereHardlyAnyPhotosAreBesideEachOther) {
    const PhotoAgreement one{0, 1, 100, 400, 0.2, 3.9};
    const PhotoAgreement other{2, 3, 100, 180, 0.1, 1.9};
    const PhotoAgreement between{1, 2, 100, 90, 1.2, 0.95};
    EXPECT_THAT(agreeingParts({true, true, true, true}, std::vector{one, other, between}, 0.3), Each(0));
}

TEST_F(AgreeingParts, AreTwoWhereWhatBothHaveInSightLooksAnotherWay) {
    std::vector<PhotoAgreement> agreements;
    for (int i = 0; i < 6; ++i) {
        agreements.push_back({i, i + 1, 100, 150, 0.8, 1.6, 2.5, 0.65});
        agreements.push_back({i + 7, i + 8, 100, 150, 0.8, 1.6, 2.5, 0.65});
    }
    agreements.push_back({3, 9, 100, 80, 0.9, 0.9, 2.5, 0.3}); // The same table stands in both rooms.
    PhotoAgreement& alike = agreements.back();
    double besideM = 0.6;
    const auto found = [&] { return agreeingParts(std::vector<bool>(14, true), agreements, 0.3, besideM); };
    EXPECT_THAT(found(), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1));
    besideM = 0; // How long anything is, is not known.
    EXPECT_THAT(found(), Each(0));
    besideM = 0.6;
    alike.shareInSight = 0.45;
    EXPECT_THAT(found(), Each(0));
    alike.shareInSight = 0.3;
    alike.apartM = 1.1; // No other photos are so far apart, so nobody knows what is usual.
    EXPECT_THAT(found(), Each(0));
}

TEST_F(AgreeingParts, AreTwoWhereTwoPairsContradictTogether) {
    std::vector<PhotoAgreement> agreements;
    for (int i = 0; i < 6; ++i) {
        agreements.push_back({i, i + 1, 100, 150, 0.8, 1.6, 2.5, 0.65});
        agreements.push_back({i + 7, i + 8, 100, 150, 0.8, 1.6, 2.5, 0.65});
    }
    agreements.push_back({3, 9, 100, 55, 0.8, 0.9, 2.5, 0.5});
    const auto found = [&] { return agreeingParts(std::vector<bool>(14, true), agreements, 0.3); };
    EXPECT_THAT(found(), Each(0));
    agreements.push_back({9, 3, 100, 55, 0.8, 0.9, 2.5, 0.5}); // The same pair, as another look has it.
    EXPECT_THAT(found(), Each(0));
    agreements.push_back({4, 9, 100, 55, 0.8, 0.9, 2.5, 0.5});
    EXPECT_THAT(found(), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1));
    agreements.back().seen = 65; // As much is there as a door lets through.
    EXPECT_THAT(found(), Each(0));
}

// The lenses are no 60 cm apart, but a wall with an open door is between them.
TEST_F(AgreeingParts, AreOneWherePhotosBesideADoorShareWhatBothHaveInSight) {
    std::vector<PhotoAgreement> agreements;
    for (int i = 0; i < 6; ++i) {
        agreements.push_back({i, i + 1, 100, 200, 0.5, 2, 2.5, 0.65});
        agreements.push_back({i + 7, i + 8, 100, 200, 0.5, 2, 2.5, 0.65});
    }
    agreements.push_back({3, 9, 100, 70, 0.4, 0.8, 2.5, 0.45});
    const auto found = [&] { return agreeingParts(std::vector<bool>(14, true), agreements, 0.3); };
    EXPECT_THAT(found(), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1));
    agreements.back().shareInSight = 0.6;
    EXPECT_THAT(found(), Each(0));
}

// Walls of bricks: features of one are taken for those of the next one.
TEST_F(AgreeingParts, AreOneWhereMostPairsShareWhatIsInSightAndOneContradicts) {
    std::vector<PhotoAgreement> agreements;
    for (int i = 0; i < 6; ++i) {
        agreements.push_back({i, i + 1, 100, 150, 0.8, 1.6, 2.5, 0.65});
        agreements.push_back({i + 7, i + 8, 100, 150, 0.8, 1.6, 2.5, 0.65});
        agreements.push_back({i, i + 7, 100, 90, 0.8, 1, 2.5, 0.6});
    }
    agreements.push_back({6, 13, 100, 1, 0.9, 0.1, 2.5});
    const auto found = [&] { return agreeingParts(std::vector<bool>(14, true), agreements, 0.3); };
    EXPECT_THAT(found(), Each(0));
    agreements.push_back({2, 13, 100, 1, 1, 0.1, 2.5});
    agreements.push_back({5, 13, 100, 1, 0.9, 0.1, 2.5});
    EXPECT_THAT(found(), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1))
        << "three, and six pairs for them";
    agreements.resize(agreements.size() - 2);
    for (PhotoAgreement& pair : agreements) { // Rooms with the same furniture share as much.
        pair.shareInSight = pair.b == pair.a + 7 && pair.shareInSight < 1 ? 0.53 : pair.shareInSight;
    }
    EXPECT_THAT(found(), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1));
}

TEST_F(AgreeingParts, NamePhotosThatContradictEachOther) {
    const std::vector<PhotoAgreement> agreements{
        {4, 2, 100, 1, 0.9, 0.1, 2.5}, {0, 1, 100, 200, 0.9, 2, 2.5}, {1, 3, 100, 2, 1, 0.1, 2.5}};
    EXPECT_THAT(contradictingPhotos(agreements), ::testing::ElementsAre(std::pair(1, 3), std::pair(2, 4)));
}

// Every fourth thing stands in both rooms. No photos stand so near to each other that no wall can be between
// them.
TEST_F(AgreeingParts, AreTwoRoomsOfOneSizeWithSomeThingsInCommon) {
    FurnishedSurvey rooms{{4, 5, 0.7, 1.5}, random};
    rooms.expose(random);
    const auto partsOf = [&] {
        return agreeingParts(std::vector<bool>(rooms.roomFromPhoto.size(), true),
                             photoAgreements(rooms.roomFromPhoto, rooms.pairs,
                                             fittingMatches(rooms.roomFromPhoto, rooms.pairs)),
                             0.05);
    };
    EXPECT_THAT(partsOf(), Each(0));
    for (PhotoPair& pair : rooms.pairs) {
        if ((pair.a < 12) != (pair.b < 12)) {
            std::erase_if(pair.matches, [](const Correspondence& match) { return match.featureA % 4 != 0; });
        }
    }
    const std::vector<int> found = partsOf();
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i], i < 12 ? 0 : 1) << i;
    }
}

TEST_F(AgreeingParts, AreOneWhereAWallExplainsThatNothingIsThere) {
    const PhotoAgreement one{0, 1, 100, 200, 1, 2, 2.5};
    const PhotoAgreement other{2, 3, 100, 200, 1, 2, 2.5};
    const PhotoAgreement throughDoor{1, 2, 100, 60, 1.5, 0.7, 2.5};
    PhotoAgreement unlike{0, 3, 150, 1, 3.5, 0.02, 2.5}; // They stand farther apart than they see.
    const auto found = [&] {
        return agreeingParts({true, true, true, true}, std::vector{one, other, throughDoor, unlike}, 0.3);
    };
    EXPECT_THAT(found(), Each(0));
    unlike.apartM = 1.2; // No wall is there, and yet nothing of the other's things.
    EXPECT_THAT(found(), ::testing::ElementsAre(0, 0, 1, 1));
}

TEST_F(AgreeingParts, AreOneWhereAllPhotosAreDense) {
    // Neighbours stand as near: they show about as much as usual, some more and some less.
    std::vector<PhotoAgreement> dense;
    for (const auto& [a, b] :
         {std::pair(0, 1), std::pair(1, 2), std::pair(2, 3), std::pair(0, 2), std::pair(1, 3)}) {
        dense.push_back({a, b, 100, 100, 0.2, b - a == 1 ? 1.1 : 0.8});
    }
    EXPECT_THAT(agreeingParts({true, true, true, true}, dense, 0.3), Each(0));
}

TEST_F(AgreeingParts, ExpectAsMuchOfABlurredPhotoAsItShows) {
    // Four of five features of one photo are lost: its things are seen beside it, and few of theirs in it.
    std::vector<PhotoPair> pairs = survey.pairs;
    for (PhotoPair& pair : pairs) {
        if (pair.a == 7 || pair.b == 7) {
            std::erase_if(pair.matches, [&](const Correspondence& match) {
                return (pair.a == 7 ? match.featureA : match.featureB) % 5 != 0;
            });
        }
    }
    survey.pairs = pairs;
    EXPECT_THAT(parts(0.3), Each(0));
}

TEST_F(AgreeingParts, LeaveOutPhotosWithoutAPose) {
    survey.roomFromPhoto[3].reset();
    EXPECT_EQ(parts(0.3)[3], -1);
    EXPECT_EQ(parts(0.3)[4], 0);
}

TEST_F(AgreeingParts, JoinPhotosThatNothingSpeaksAgainst) {
    survey.pairs = {survey.pairs.front()}; // no third photo tells what to expect
    survey.roomFromPhoto.resize(2);
    EXPECT_THAT(parts(0.5), Each(0));
}

TEST_F(AgreeingParts, RefuseListsOfDifferentLengths) {
    expectError(ErrorKind::InvalidInput, "inliers of",
                [&] { photoAgreements(survey.roomFromPhoto, survey.pairs, {}); });
}

// The third part is of another place. While it is there, the second seems to be elsewhere as well.
TEST(RejoinedParts, AreThoseThatAgreeOnceNothingElseBendsThem) {
    const std::vector<int> found = {0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 3, -1};
    std::vector<std::vector<int>> tried;
    const auto partsWhereCut = [&](const std::vector<int>& parts) {
        tried.push_back(parts);
        return parts[9] == 0 ? found : parts;
    };
    const std::vector<int> joined = {0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 2, 2, 3, -1};
    EXPECT_EQ(rejoinedParts(found, partsWhereCut), joined);
    ASSERT_EQ(tried.size(), 2U); // the larger one first, and then the other with it
    EXPECT_EQ(tried[0], joined);
    EXPECT_EQ(tried[1], (std::vector{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, -1}));
}

// That all together do not agree is known.
TEST(RejoinedParts, AreNeverAllOfThem) {
    int tried = 0;
    const auto alwaysOne = [&](const std::vector<int>& parts) {
        ++tried;
        return std::vector<int>(parts.size(), 0);
    };
    EXPECT_EQ(rejoinedParts({0, 0, 0, 1, 1, 1, 2, 2, 2}, alwaysOne),
              (std::vector{0, 0, 0, 0, 0, 0, 2, 2, 2}));
    EXPECT_EQ(tried, 1);
}

TEST(RejoinedParts, AreNotTriedWhereNothingElseBends) {
    const auto never = [](const std::vector<int>&) -> std::vector<int> {
        ADD_FAILURE();
        return {};
    };
    for (const std::vector<int>& parts :
         {std::vector<int>{}, {-1}, {0, 0, 0, 1, 1, 1, -1}, {0, 0, 0, 1, 1, 2, 3}}) {
        EXPECT_EQ(rejoinedParts(parts, never), parts);
    }
}

} // namespace spherewalk::align
