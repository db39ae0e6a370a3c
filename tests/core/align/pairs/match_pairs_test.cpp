// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made/noise_photo.h"
#include "random.h"

#include "spherewalk/align/free_places.h"
#include "spherewalk/align/match_pairs.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace spherewalk::align {

using test::expectError;
using test::noisePhoto;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

Eigen::Quaterniond yaw(double degrees) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * kHalfTurn / 180, Eigen::Vector3d::UnitZ()));
}

/// Features that are nothing but bearings and random descriptors.
Features made(const std::vector<Eigen::Vector3d>& bearings, test::Random& random) {
    Features features;
    features.descriptorBytes = 128;
    for (const Eigen::Vector3d& bearing : bearings) {
        features.bearings.push_back(bearing.cast<float>());
        features.sigmasRad.push_back(1e-3F);
        features.responses.push_back(1);
        for (int i = 0; i < 128; ++i) {
            features.descriptors.push_back(static_cast<std::uint8_t>(random.integer(0, 90)));
        }
    }
    return features;
}

Features turned(Features features, const Eigen::Quaterniond& rotation) {
    for (Eigen::Vector3f& bearing : features.bearings) {
        bearing = (rotation * bearing.cast<double>()).cast<float>();
    }
    return features;
}

/// A world whose four quarters are equal, its columns shifted to the left.
RgbImage tiledPhoto(int shiftPx) {
    const RgbImage whole = noisePhoto(Eigen::Quaterniond::Identity());
    RgbImage photo(whole.width(), whole.height());
    const int quarter = whole.width() / 4;
    for (int y = 0; y < whole.height(); ++y) {
        for (int x = 0; x < whole.width(); ++x) {
            std::copy_n(whole.at((x + shiftPx) % quarter, y), 3, photo.at(x, y));
        }
    }
    return photo;
}

std::vector<Eigen::Vector3d> directions(int count, test::Random& random) {
    std::vector<Eigen::Vector3d> result;
    for (int i = 0; i < count; ++i) {
        result.push_back(random.direction());
    }
    return result;
}

} // namespace

TEST(Match, FindsEachFeatureAgainWhateverTheRotation) {
    test::Random random(3);
    SCOPED_TRACE(random.seed());
    const Features a = made(directions(300, random), random);
    for (int trial = 0; trial < 5; ++trial) {
        const Eigen::Quaterniond bFromA = random.rotation();
        const auto matches = matchFeatures(a, turned(a, bFromA), {});
        ASSERT_EQ(matches.size(), 300U);
        for (const Correspondence& match : matches) {
            EXPECT_EQ(match.featureA, match.featureB);
            EXPECT_LT((bFromA * match.inA - match.inB).norm(), 1e-5);
            EXPECT_NEAR(match.sigmaRad, 1e-3, 1e-8);
        }
    }
}

TEST(Match, SeesTheRotationOfTwoPhotosOfOnePlace) {
    FeatureOptions options;
    options.width = 512;
    const Features a = detectFeatures(noisePhoto(Eigen::Quaterniond::Identity()), options);
    for (const double degrees : {0.0, 73.0, 180.0}) {
        const Features b = detectFeatures(noisePhoto(yaw(degrees)), options);
        const auto rotation = coarseRotation(a, b, {});
        ASSERT_TRUE(rotation) << degrees;
        EXPECT_LT(rotation->aFromB.angularDistance(yaw(degrees)), 0.01) << degrees;
        const auto matches = matchFeatures(a, b, {});
        EXPECT_GT(matches.size(), 200U);
        const auto right = std::count_if(matches.begin(), matches.end(), [&](const Correspondence& match) {
            return (match.inA - yaw(degrees) * match.inB).norm() < 5 * match.sigmaRad;
        });
        EXPECT_GT(static_cast<double>(right), 0.95 * static_cast<double>(matches.size())) << degrees;
    }
}

/// White walls and a long step: the strongest features of either photo are not among those of the other.
TEST(Retrieval, LooksAgainAtPhotosThatFewOthersLookLike) {
    test::Random random(8);
    SCOPED_TRACE(random.seed());
    const Features shared = made(directions(600, random), random);
    const auto behindOthers = [&](const Eigen::Quaterniond& rotation) {
        Features photo = made(directions(400, random), random);
        const Features seen = turned(shared, rotation);
        photo.bearings.insert(photo.bearings.end(), seen.bearings.begin(), seen.bearings.end());
        photo.sigmasRad.resize(1000, 1e-3F);
        photo.responses.resize(1000, 1);
        photo.descriptors.insert(photo.descriptors.end(), seen.descriptors.begin(), seen.descriptors.end());
        return photo;
    };
    const std::vector<Features> photos = {behindOthers(yaw(20)), behindOthers(yaw(80))};
    RetrievalOptions once;
    once.fewAlike = 0;
    EXPECT_EQ(likeness(photos, once, noProgress(), {}).votes(0, 1), 0);
    EXPECT_GT(likeness(photos, {}, noProgress(), {}).votes(0, 1), 50);
}

/// A room that looks alike to four sides must not be taken for one turned by a quarter.
TEST(Match, SeesNoRotationWhereSeveralWouldDo) {
    test::Random random(5);
    SCOPED_TRACE(random.seed());
    const Features wall = made(directions(60, random), random);
    const auto allAround = [&](double firstDegrees) {
        Features room = turned(wall, yaw(firstDegrees));
        for (const double degrees : {90.0, 180.0, 270.0}) {
            const Features next = turned(wall, yaw(firstDegrees + degrees));
            room.bearings.insert(room.bearings.end(), next.bearings.begin(), next.bearings.end());
            room.sigmasRad.insert(room.sigmasRad.end(), next.sigmasRad.begin(), next.sigmasRad.end());
            room.responses.insert(room.responses.end(), next.responses.begin(), next.responses.end());
            room.descriptors.insert(room.descriptors.end(), next.descriptors.begin(), next.descriptors.end());
        }
        for (std::uint8_t& value : room.descriptors) { // the camera's noise
            value = static_cast<std::uint8_t>(value + random.integer(0, 8));
        }
        return room;
    };
    MatchOptions options;
    options.mostRatio = 1; // else the alike features are left out at once
    EXPECT_FALSE(coarseRotation(allAround(0), allAround(30), options));
}

/// The same with pictures: four equal quarters, seen twice.
TEST(Match, SeesNoRotationInARoomOfOneRepeatedTile) {
    FeatureOptions options;
    options.width = 512;
    const Features a = detectFeatures(tiledPhoto(0), options);
    const Features b = detectFeatures(tiledPhoto(20), options);
    EXPECT_GT(a.count(), 500);
    EXPECT_FALSE(coarseRotation(a, b, {}));
    const auto matches = matchFeatures(a, b, {});
    EXPECT_LT(matches.size(), static_cast<std::size_t>(a.count()) / 8);
}

TEST(Match, SeesNoRotationInAMirrorImage) {
    FeatureOptions options;
    options.width = 512;
    const RgbImage photo = noisePhoto(Eigen::Quaterniond::Identity());
    RgbImage mirrored = photo;
    for (int y = 0; y < photo.height(); ++y) {
        for (int x = 0; x < photo.width(); ++x) {
            std::copy_n(photo.at(photo.width() - 1 - x, y), 3, mirrored.at(x, y));
        }
    }
    const Features a = detectFeatures(photo, options);
    const Features b = detectFeatures(mirrored, options);
    EXPECT_FALSE(coarseRotation(a, b, {}));
    EXPECT_LT(matchFeatures(a, b, {}).size(), 30U);
}

TEST(Match, LeavesOutFeaturesThatLookAlike) {
    test::Random random(7);
    SCOPED_TRACE(random.seed());
    Features a = made(directions(200, random), random);
    for (std::uint8_t& value : a.descriptors) {
        value = 40;
    }
    EXPECT_TRUE(matchFeatures(a, a, {}).empty());
}

TEST(Match, OfUnrelatedPhotosIsAlmostEmpty) {
    test::Random random(11);
    SCOPED_TRACE(random.seed());
    const Features a = made(directions(400, random), random);
    const Features b = made(directions(400, random), random);
    EXPECT_FALSE(coarseRotation(a, b, {}));
    EXPECT_LT(matchFeatures(a, b, {}).size(), 10U);
}

TEST(Match, WithAGuessKeepsWithinReach) {
    test::Random random(13);
    SCOPED_TRACE(random.seed());
    const Features a = made(directions(200, random), random);
    const Features b = turned(a, yaw(40));
    EXPECT_TRUE(matchFeatures(a, b, {}, yaw(140)).size() < 20U);
    EXPECT_EQ(matchFeatures(a, b, {}, yaw(-40)).size(), 200U);
}

TEST(Match, OfNothingIsEmpty) {
    test::Random random(17);
    const Features some = made(directions(10, random), random);
    EXPECT_TRUE(matchFeatures({}, some, {}).empty());
    EXPECT_TRUE(matchFeatures(some, {}, {}).empty());
    EXPECT_FALSE(coarseRotation({}, some, {}));
}

TEST(Match, RefusesFeaturesOfDifferentDetectors) {
    test::Random random(19);
    const Features a = made(directions(10, random), random);
    Features b = a;
    b.detector = Detector::Orb;
    b.descriptorBytes = 32;
    b.descriptors.resize(320);
    expectError(ErrorKind::InvalidInput, "different kinds", [&] { matchFeatures(a, b, {}); });
}

TEST(Match, RefusesOptionsOutOfRange) {
    MatchOptions options;
    options.mostRatio = 0;
    expectError(ErrorKind::InvalidInput, "mostRatio", [&] { options.validate(); });
    options = {};
    options.reach = Radians(std::nan(""));
    expectError(ErrorKind::InvalidInput, "reach", [&] { options.validate(); });
}

/// Two photos of the practice room 20 cm apart: nine of ten matches lie in the epipolar plane of the truth.
TEST(Match, AgreesWithTheTruePosesOfThePracticeRoom) {
    const practice::PracticeRoom room;
    const Rigid3 roomFromA{yaw(20), {2.0, 1.8, 1.2}};
    const Rigid3 roomFromB{yaw(-160) * Eigen::Quaterniond(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX())),
                           {2.2, 1.8, 1.2}};
    FeatureOptions options;
    options.width = 1024;
    options.most = 1000;
    const Features a = detectFeatures(room.spherical(roomFromA, {1024, 512}, {.threads = 2}), options);
    const Features b = detectFeatures(room.spherical(roomFromB, {1024, 512}, {.threads = 2}), options);
    const auto matches = matchFeatures(a, b, {});
    EXPECT_GT(matches.size(), 250U);
    const Rigid3 aFromB = roomFromA.inverse() * roomFromB;
    const auto right = std::count_if(matches.begin(), matches.end(), [&](const Correspondence& match) {
        const Eigen::Vector3d normal = aFromB.translation.normalized().cross(match.inA);
        const double offPlane = normal.dot(aFromB.rotation * match.inB);
        return std::abs(offPlane) < 4 * match.sigmaRad;
    });
    EXPECT_GT(static_cast<double>(right), 0.85 * static_cast<double>(matches.size()));
}

TEST(MatchPairs, GivesThePairsInTheirOrder) {
    test::Random random(6);
    std::vector<Features> photos;
    for (int i = 0; i < 4; ++i) {
        std::vector<Eigen::Vector3d> bearings(80);
        std::ranges::generate(bearings, [&] { return random.direction(); });
        photos.push_back(made(bearings, random));
    }
    photos[2].descriptors = photos[1].descriptors;
    const std::vector<std::pair<int, int>> pairs = {{1, 2}, {0, 3}};
    const MatchOptions anywhere{.isGuided = false};
    const auto matched = matchPairs(photos, pairs, anywhere, 2, noProgress(), {});
    ASSERT_EQ(matched.size(), 2U);
    EXPECT_EQ(std::pair(matched[0].a, matched[0].b), pairs[0]);
    EXPECT_EQ(std::pair(matched[1].a, matched[1].b), pairs[1]);
    EXPECT_EQ(matched[0].matches.size(), 80U);
    expectError(ErrorKind::InvalidInput, "before the second",
                [&] { matchPairs(photos, std::vector{std::pair(2, 1)}, {}, 2, noProgress(), {}); });
    expectError(ErrorKind::InvalidInput, "of 4",
                [&] { matchPairs(photos, std::vector{std::pair(0, 4)}, {}, 2, noProgress(), {}); });
}

TEST(Effort, HasANameThatFindsItAgain) {
    for (const Effort effort : {Effort::Draft, Effort::Normal, Effort::Fine, Effort::Exact}) {
        EXPECT_EQ(effortNamed(name(effort)), effort);
    }
    test::expectError(ErrorKind::InvalidInput, "draft, normal, fine and exact", [] { effortNamed("hard"); });
}

TEST(Effort, OptionsAreValidAndEachRungLooksAtMore) {
    EffortOptions before;
    before.features.width = 0;
    before.features.most = 0;
    for (const Effort effort : {Effort::Draft, Effort::Normal, Effort::Fine, Effort::Exact}) {
        const EffortOptions options = optionsFor(effort);
        EXPECT_NO_THROW(options.features.validate());
        EXPECT_NO_THROW(options.match.validate());
        EXPECT_NO_THROW(options.neighbours.validate());
        EXPECT_GT(options.features.width, before.features.width);
        EXPECT_GT(options.features.most, before.features.most);
        before = options;
    }
}

namespace {

/// Where a ray from a lens meets a wall one metre to its left; empty beyond the wall's ends.
std::optional<Eigen::Vector3d> onWall(const Eigen::Vector3d& lens, const Eigen::Vector3d& bearing) {
    if (bearing.y() < 0.05) {
        return std::nullopt;
    }
    const Eigen::Vector3d at = lens + bearing / bearing.y();
    return std::abs(at.z()) < 1.5 && std::abs(at.x() - 1) < 4 ? std::optional(at) : std::nullopt;
}

/// A photo of a wall of noise, in a world that is grey.
RgbImage wallPhoto(const Eigen::Vector3d& lens) {
    constexpr int kWidth = 1024;
    RgbImage photo(kWidth, kWidth / 2);
    for (int y = 0; y < photo.height(); ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto at = onWall(lens, direction(EquirectSize{kWidth, kWidth / 2}, Eigen::Vector2d(x, y)));
            const double value =
                at ? 0.5 * test::spaceNoise(*at * 6) + 0.5 * test::spaceNoise(*at * 15) : 0.5;
            std::fill_n(photo.at(x, y), 3, static_cast<std::uint8_t>(std::lround(255 * value)));
        }
    }
    return photo;
}

/// Number of matches that show one point of the wall.
int rightMatches(const RgbImage& a, const RgbImage& b, const Eigen::Vector3d& bFromA, bool isWide) {
    FeatureOptions options;
    options.width = 1024;
    options.isWide = isWide;
    MatchOptions match;
    match.isGuided = false;
    int right = 0;
    for (const Correspondence& found :
         matchFeatures(detectFeatures(a, options), detectFeatures(b, options), match)) {
        const auto inA = onWall(Eigen::Vector3d::Zero(), found.inA);
        const auto inB = onWall(bFromA, found.inB);
        right += inA && inB && (*inA - *inB).norm() < 0.05 ? 1 : 0;
    }
    return right;
}

} // namespace

TEST(WideMatch, KnowsAWallAgainThatIsSeenFromAslant) {
    const Eigen::Vector3d aside(2.2, 0, 0);
    const RgbImage a = wallPhoto(Eigen::Vector3d::Zero());
    const RgbImage b = wallPhoto(aside);
    const int usual = rightMatches(a, b, aside, false);
    const int wide = rightMatches(a, b, aside, true);
    EXPECT_GT(wide, 3 * usual);
    EXPECT_GT(wide, 60);
}

TEST(WideMatch, MatchesEachThingOnce) {
    const RgbImage photo = wallPhoto(Eigen::Vector3d::Zero());
    FeatureOptions options;
    options.width = 1024;
    options.isWide = true;
    const Features features = detectFeatures(photo, options);
    ASSERT_EQ(features.firstOf.size(), features.bearings.size());
    MatchOptions match;
    match.isGuided = false;
    std::set<int> things;
    for (const Correspondence& found : matchFeatures(features, features, match)) {
        EXPECT_EQ(found.featureA, found.featureB);
        EXPECT_EQ(features.thing(found.featureA), found.featureA);
        EXPECT_TRUE(things.insert(found.featureA).second);
    }
    EXPECT_GT(things.size(), 200U);
}

TEST(Renumber, GivesOneThingOneNumberInAllLooks) {
    test::Random random(5);
    SCOPED_TRACE(random.seed());
    const std::vector<Eigen::Vector3d> all = directions(40, random);
    const Features first = made({all.begin(), all.begin() + 30}, random);
    const Features second = made({all.begin() + 20, all.end()}, random);
    std::vector<std::vector<Eigen::Vector3f>> known{{}, first.bearings, first.bearings};
    const std::vector looked{second, second};
    std::vector<PhotoPair> pairs{{0, 1, matchFeatures(second, second, {})}};
    ASSERT_EQ(pairs[0].matches.size(), 20U);
    renumber(looked, std::vector{1, 2}, 7, known, pairs);

    EXPECT_EQ(pairs[0].a, 1);
    EXPECT_EQ(pairs[0].b, 2);
    EXPECT_EQ(pairs[0].look, 7);
    for (std::size_t i = 0; i < 20; ++i) { // Ten that the first look knew, and ten new ones.
        EXPECT_EQ(pairs[0].matches[i].featureA, static_cast<int>(20 + i));
        EXPECT_EQ(pairs[0].matches[i].featureB, static_cast<int>(20 + i));
    }
    EXPECT_TRUE(known[0].empty());
    EXPECT_EQ(known[1].size(), 40U);
}

} // namespace spherewalk::align
