// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/furnished_survey.h"
#include "expect_error.h"
#include "random.h"

#include "spherewalk/align/content_check.h"
#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <map>
#include <set>

namespace spherewalk::align {

namespace {

Correspondence seen(const Rigid3& a, const Rigid3& b, const Eigen::Vector3d& pInRoom) {
    Correspondence match;
    match.inA = (a.inverse() * pInRoom).normalized();
    match.inB = (b.inverse() * pInRoom).normalized();
    match.sigmaRad = 0.0005;
    return match;
}

} // namespace

TEST(FittingMatches, FitWhereBothPhotosSeeOneThingInFrontOfThem) {
    test::Random random(41);
    SCOPED_TRACE(random.seed());
    const Eigen::Vector3d origin(1e6, -1e6, 0);
    const std::vector<std::optional<Rigid3>> photos{
        Rigid3{random.rotation(), origin}, Rigid3{random.rotation(), origin + Eigen::Vector3d(0.2, 0.1, 0)},
        Rigid3{random.rotation(), origin + Eigen::Vector3d(0, 0, 1e-4)}, std::nullopt};
    PhotoPair apart{0, 1, {}};
    PhotoPair together{0, 2, {}};
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d thing = origin + random.uniform(1, 5) * random.direction();
        apart.matches.push_back(seen(*photos[0], *photos[1], thing));
        together.matches.push_back(seen(*photos[0], *photos[2], thing));
    }
    PhotoPair unknown{0, 3, apart.matches};
    // Behind: what b sees, from the other side.
    PhotoPair behind{0, 1, {}};
    PhotoPair aside{0, 1, {}};
    const Eigen::Vector3d way = photos[1]->translation - photos[0]->translation;
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d across = way.cross(random.direction()).normalized();
        Correspondence match = seen(*photos[0], *photos[1], origin + 2 * across);
        aside.matches.push_back(match);
        aside.matches.back().inB =
            Eigen::AngleAxisd(0.01, photos[1]->rotation.conjugate() * way.normalized()) * match.inB;
        match.inB = photos[1]->rotation.conjugate() * (across + 0.1 * way.normalized()).normalized();
        behind.matches.push_back(match);
    }
    const auto fits = fittingMatches(photos, std::vector<PhotoPair>{apart, together, unknown, behind, aside});
    const auto count = [&](std::size_t pair) {
        return std::count(fits[pair].begin(), fits[pair].end(), true);
    };
    EXPECT_EQ(count(0), 200);
    EXPECT_EQ(count(1), 200);
    EXPECT_EQ(count(2), 0);
    EXPECT_EQ(count(3), 0);
    EXPECT_EQ(count(4), 0);
}

namespace {

using test::expectError;
using test::Random;

std::vector<ChangedContent> check(const FurnishedSurvey& survey) {
    return changedContent(survey.roomFromPhoto, survey.pairs, survey.isInlier, {2});
}

std::set<int> photosOf(const std::vector<ChangedContent>& changes) {
    std::set<int> photos;
    for (const ChangedContent& change : changes) {
        photos.insert(change.photo);
    }
    return photos;
}

std::string listed(const FurnishedSurvey& survey, const std::vector<ChangedContent>& changes) {
    std::string all;
    for (const ChangedContent& change : changes) {
        const Eigen::Vector3d inRoom =
            survey.roomFromPhoto[static_cast<std::size_t>(change.photo)]->rotation * change.directionInPhoto;
        all += "photo " + std::to_string(change.photo) + ", azimuth " +
               std::to_string(Degrees(Radians(std::atan2(inRoom.y(), inRoom.x()))).value()) + ", z " +
               std::to_string(inRoom.z()) + ", radius " + std::to_string(Degrees(change.radius).value()) +
               ", confidence " + std::to_string(change.confidence) + ": " + change.reason + "\n";
    }
    return all;
}

/// Whether some part found in the photo is where the others see the chair.
bool pointsAtChair(const FurnishedSurvey& survey, const std::vector<ChangedContent>& changes, int photo) {
    const Eigen::Vector3d chair =
        survey.roomFromPhoto[static_cast<std::size_t>(photo)]->inverse() * FurnishedSurvey::chairM();
    return std::ranges::any_of(changes, [&](const ChangedContent& change) {
        return change.photo == photo &&
               angleBetween(change.directionInPhoto, chair) < Radians(Degrees(12)) + change.radius;
    });
}

/// Lets neighbours see whatever the photo shows of the moved chair where the photo shows it: a second chair.
void addTwins(int photo, FurnishedSurvey& survey) {
    std::map<int, Eigen::Vector3d> foundElsewhere; // By the photo's feature: its bearing.
    for (std::size_t pair = 0; pair < survey.pairs.size(); ++pair) {
        for (std::size_t i = 0; i < survey.pairs[pair].matches.size(); ++i) {
            const Correspondence& match = survey.pairs[pair].matches[i];
            if (!survey.isInlier[pair][i] && survey.pairs[pair].a == photo) {
                foundElsewhere[match.featureA] = match.inA;
            } else if (!survey.isInlier[pair][i] && survey.pairs[pair].b == photo) {
                foundElsewhere[match.featureB] = match.inB;
            }
        }
    }
    const Rigid3& roomFromPhoto = *survey.roomFromPhoto[static_cast<std::size_t>(photo)];
    int next = 1'000'000; // No feature of the survey has this number.
    for (std::size_t pair = 0; pair < survey.pairs.size(); ++pair) {
        PhotoPair& both = survey.pairs[pair];
        if (both.a != photo && both.b != photo) {
            continue;
        }
        const int neighbour = both.a == photo ? both.b : both.a;
        const Rigid3 neighbourFromPhoto =
            survey.roomFromPhoto[static_cast<std::size_t>(neighbour)]->inverse() * roomFromPhoto;
        for (const auto& [feature, bearing] : foundElsewhere) {
            const Eigen::Vector3d inNeighbour = (neighbourFromPhoto * (2 * bearing)).normalized();
            both.matches.push_back(both.a == photo
                                       ? Correspondence{bearing, inNeighbour, 0.0008, feature, next}
                                       : Correspondence{inNeighbour, bearing, 0.0008, next, feature});
            survey.isInlier[pair].push_back(true);
            ++next;
        }
    }
}

/// Takes the other matches out of all pairs.
template <class Keeps>
void keepMatches(FurnishedSurvey& survey, const Keeps& keeps) {
    for (std::size_t pair = 0; pair < survey.pairs.size(); ++pair) {
        std::vector<Correspondence> matches;
        std::vector<bool> isInlier;
        for (std::size_t i = 0; i < survey.pairs[pair].matches.size(); ++i) {
            if (keeps(survey.pairs[pair], survey.pairs[pair].matches[i])) {
                matches.push_back(survey.pairs[pair].matches[i]);
                isInlier.push_back(survey.isInlier[pair][i]);
            }
        }
        survey.pairs[pair].matches = std::move(matches);
        survey.isInlier[pair] = std::move(isInlier);
    }
}

} // namespace

TEST(ContentCheck, FindsTheOnePhotoInWhichAChairMoved) {
    int found = 0;
    int falseAlarms = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        FurnishedSurvey survey({}, random);
        const int photo = random.integer(0, 24);
        const double heading = random.uniform(-3.1, 3.1);
        survey.chairAtM[static_cast<std::size_t>(photo)] =
            FurnishedSurvey::chairM() + 0.3 * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0);
        survey.expose(random);
        const std::vector<ChangedContent> changes = check(survey);
        const bool isFound = pointsAtChair(survey, changes, photo);
        found += isFound ? 1 : 0;
        std::set<int> others = photosOf(changes);
        others.erase(photo);
        falseAlarms += static_cast<int>(others.size());
        EXPECT_TRUE(isFound && others.empty())
            << "seed " << seed << ", photo " << photo << ", heading " << heading << "\n"
            << listed(survey, changes);
    }
    std::printf("6 moved chairs, %d found, %d other photos named\n", found, falseAlarms);
}

TEST(ContentCheck, FindsTheOnePhotoFromWhichAChairVanished) {
    int found = 0;
    for (unsigned seed = 11; seed <= 16; ++seed) {
        Random random(seed);
        FurnishedSurvey survey({}, random);
        const int photo = random.integer(0, 24);
        survey.chairAtM[static_cast<std::size_t>(photo)].reset();
        survey.expose(random);
        const std::vector<ChangedContent> changes = check(survey);
        found += pointsAtChair(survey, changes, photo) ? 1 : 0;
        EXPECT_TRUE(changes.empty() || photosOf(changes) == std::set<int>{photo})
            << "seed " << seed << ", photo " << photo << "\n"
            << listed(survey, changes);
    }
    std::printf("6 vanished chairs, %d found\n", found);
    EXPECT_GE(found, 3); // no more, so that real pictures of rooms where nothing moved raise no alarm
}

TEST(ContentCheck, RaisesNoAlarmBesideFurnitureThatHidesAndShows) {
    for (unsigned seed = 21; seed <= 28; ++seed) {
        Random random(seed);
        FurnishedOptions options;
        options.positionSigmaM = 0.002;
        FurnishedSurvey survey(options, random);
        survey.expose(random);
        const std::vector<ChangedContent> changes = check(survey);
        EXPECT_TRUE(changes.empty()) << "seed " << seed << "\n" << listed(survey, changes);
    }
}

TEST(ContentCheck, HardlyRaisesAnAlarmBesideFurnitureBetweenPhotosFarApart) {
    std::size_t alarms = 0; // In 96 photos.
    for (unsigned seed = 71; seed <= 78; ++seed) {
        Random random(seed);
        FurnishedOptions options;
        options.rows = 3;
        options.columns = 4;
        options.stepM = 0.8;
        options.neighboursM = 1.9;
        FurnishedSurvey survey(options, random);
        survey.expose(random);
        alarms += check(survey).size();
    }
    EXPECT_LE(alarms, 1U);
}

TEST(ContentCheck, MissesNothingWherePhotosWereNotSearched) {
    // An operator stands before the lens, and photos look any way.
    const auto isSearched = [](const Eigen::Vector3d& bearing) { return bearing.x() < 0.9; };
    std::size_t alarms = 0;
    for (unsigned seed = 51; seed <= 56; ++seed) {
        Random random(seed);
        FurnishedSurvey survey({}, random);
        survey.expose(random);
        keepMatches(survey, [&](const PhotoPair& /*pair*/, const Correspondence& match) {
            return isSearched(match.inA) && isSearched(match.inB);
        });
        alarms += check(survey).size();
        const std::vector<ChangedContent> changes =
            changedContent(survey.roomFromPhoto, survey.pairs, survey.isInlier, {2, isSearched});
        EXPECT_TRUE(changes.empty()) << "seed " << seed << "\n" << listed(survey, changes);
    }
    EXPECT_GT(alarms, 0U);
}

TEST(ContentCheck, MissesNothingThatAnotherLookDidNotFind) {
    // The pairs of one photo were compared in a look that found nothing ahead.
    constexpr int kPhoto = 7;
    std::size_t alarms = 0;
    for (unsigned seed = 51; seed <= 56; ++seed) {
        Random random(seed);
        FurnishedSurvey survey({}, random);
        survey.expose(random);
        keepMatches(survey, [](const PhotoPair& pair, const Correspondence& match) {
            return !(pair.a == kPhoto && match.inA.x() > 0.8) && !(pair.b == kPhoto && match.inB.x() > 0.8);
        });
        alarms += photosOf(check(survey)).count(kPhoto);
        for (PhotoPair& pair : survey.pairs) {
            pair.look = pair.a == kPhoto || pair.b == kPhoto ? 1 : 0;
        }
        EXPECT_EQ(photosOf(check(survey)).count(kPhoto), 0U) << "seed " << seed;
    }
    EXPECT_GT(alarms, 0U);
}

TEST(ContentCheck, TakesNothingForMovedThatNeighboursSeeWhereItIs) {
    // The photo sees no chair, and its neighbours' chair is taken for what really stands beside it.
    constexpr int kPhoto = 12;
    for (unsigned seed = 61; seed <= 64; ++seed) {
        Random random(seed);
        FurnishedSurvey survey({}, random);
        survey.chairAtM[kPhoto] = FurnishedSurvey::chairM() + Eigen::Vector3d(0, -0.5, 0);
        survey.expose(random);
        const auto saysMoved = [&] {
            return std::ranges::any_of(check(survey), [](const ChangedContent& change) {
                return change.photo == kPhoto && change.reason.find("it moved.") != std::string::npos;
            });
        };
        EXPECT_TRUE(saysMoved()) << "seed " << seed;
        addTwins(kPhoto, survey);
        EXPECT_FALSE(saysMoved()) << "seed " << seed;
    }
}

TEST(ContentCheck, AcceptsAChairThatMovedForAllLaterPhotos) {
    for (unsigned seed = 31; seed <= 34; ++seed) {
        Random random(seed);
        FurnishedSurvey survey({}, random);
        for (std::size_t photo = static_cast<std::size_t>(random.integer(6, 18)); photo < 25; ++photo) {
            survey.chairAtM[photo] = FurnishedSurvey::chairM() + Eigen::Vector3d(-0.1, 0.28, 0);
        }
        survey.expose(random);
        const std::vector<ChangedContent> changes = check(survey);
        EXPECT_TRUE(changes.empty()) << "seed " << seed << "\n" << listed(survey, changes);
    }
}

TEST(ContentCheck, JudgesNoPhotoOfTooFewNeighbours) {
    Random random(41);
    FurnishedOptions options;
    options.rows = 1;
    options.columns = 3;
    FurnishedSurvey survey(options, random);
    survey.chairAtM[1].reset();
    survey.expose(random);
    EXPECT_TRUE(check(survey).empty());
    EXPECT_TRUE(changedContent({}, {}, {}).empty());
}

TEST(ContentCheck, PassesOverPhotosWithoutPoseAndWhatIsNoNumber) {
    Random random(42);
    FurnishedSurvey survey({}, random);
    survey.expose(random);
    survey.roomFromPhoto[12].reset();
    survey.roomFromPhoto[3]->translation.x() = std::numeric_limits<double>::quiet_NaN();
    survey.pairs[3].matches[0].inA.x() = std::numeric_limits<double>::quiet_NaN();
    survey.pairs[4].matches[0].featureA = -1;
    EXPECT_TRUE(check(survey).empty());
}

TEST(ContentCheck, RefusesListsThatDoNotFitTogether) {
    Random random(43);
    FurnishedSurvey survey({}, random);
    survey.expose(random);
    survey.isInlier[0].pop_back();
    expectError(ErrorKind::InvalidInput, "are said to be inliers or not", [&] { check(survey); });
    survey.isInlier.pop_back();
    expectError(ErrorKind::InvalidInput, "inliers of", [&] { check(survey); });
}

TEST(ContentCheck, ChecksALargeSurveyAndPrintsItsTime) {
    Random random(44);
    FurnishedOptions options;
    options.rows = 20;
    options.columns = 20;
    options.stepM = 0.05; // so that the room holds them; the pairs are chosen by count below
    options.pointsOnWalls = 600;
    options.pointsPerM2 = 20;
    FurnishedSurvey survey(options, random);
    survey.expose(random);
    std::vector<PhotoPair> pairs;
    std::vector<std::vector<bool>> isInlier;
    for (std::size_t i = 0; i < survey.pairs.size(); ++i) {
        if (random.uniform(0, 1) * static_cast<double>(survey.pairs.size()) < 2400) {
            pairs.push_back(survey.pairs[i]);
            isInlier.push_back(survey.isInlier[i]);
        }
    }
    const auto start = std::chrono::steady_clock::now();
    const std::vector<ChangedContent> changes = changedContent(survey.roomFromPhoto, pairs, isInlier, {2});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_TRUE(changes.empty()) << listed(survey, changes);
    std::printf("400 photos, %zu pairs of about %zu matches: %.2f s on 2 threads\n", pairs.size(),
                pairs[0].matches.size(), taken.count());
}

} // namespace spherewalk::align
