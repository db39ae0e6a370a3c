// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "furnished_survey.h"

#include "spherewalk/align/content_check.h"
#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <set>

namespace spherewalk::align {

namespace {

using spherewalk::test::expectError;
using spherewalk::test::Random;
using test::FurnishedOptions;
using test::FurnishedSurvey;

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
        const bool isFound = pointsAtChair(survey, changes, photo);
        found += isFound ? 1 : 0;
        EXPECT_TRUE(isFound && photosOf(changes) == std::set<int>{photo})
            << "seed " << seed << ", photo " << photo << "\n"
            << listed(survey, changes);
    }
    std::printf("6 vanished chairs, %d found\n", found);
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

} // namespace spherewalk::align
