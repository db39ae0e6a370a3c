// SPDX-License-Identifier: GPL-3.0-or-later
// What is there twice: a texture that repeats itself, and furniture of one kind.
#include "check/furnished_survey.h"
#include "free/placing.h"
#include "made/synthetic_survey.h"
#include "random.h"

#include "spherewalk/align/free_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::align {

namespace {

/// Photos half a metre apart, each leaning by hand. Nothing says where they were taken.
SyntheticSurvey byHand() {
    SyntheticSurveyOptions options;
    options.seed = 31;
    options.columns = 6;
    options.rows = 3;
    options.stepM = 0.5;
    options.reachM = 1.7;
    options.tiltSigma = Degrees(5);
    options.positionSigmaM = 0.01;
    options.heightSigmaM = 0.03;
    options.points = 2000;
    SyntheticSurvey survey = syntheticSurvey(options);
    for (PhotoPrior& photo : survey.photos) {
        photo.positionM = Eigen::Vector3d::Zero();
        photo.placement = -1;
        photo.levelFromPhoto.reset();
    }
    return survey;
}

/// Lets both photos show the same as if they stood at one place.
void makeAlike(const SyntheticSurvey& survey, PhotoPair& pair) {
    const Eigen::Quaterniond& a = survey.roomFromPhoto[static_cast<std::size_t>(pair.a)].rotation;
    const Eigen::Quaterniond& b = survey.roomFromPhoto[static_cast<std::size_t>(pair.b)].rotation;
    for (Correspondence& match : pair.matches) {
        match.inB = b.conjugate() * (a * match.inA);
        match.featureB += 100000; // Other bricks.
    }
}

} // namespace

// Three steps apart in a row of photos the walls look the same.
TEST(Lookalikes, DoNotCutARoomInWhichMostPhotosAgree) {
    SyntheticSurvey survey = byHand();
    int alike = 0;
    for (PhotoPair& pair : survey.pairs) {
        if (pair.a >= 6 && pair.a < 12 && pair.b == pair.a + 3 && pair.b < 12) {
            makeAlike(survey, pair);
            ++alike;
        }
    }
    ASSERT_EQ(alike, 3);
    const FreePlaces places =
        freePlaces(survey.photos, survey.pairs, estimatePairs(survey.pairs), {}, noProgress(), {});
    for (std::size_t i = 0; i < places.photos.size(); ++i) {
        ASSERT_TRUE(places.photos[i].roomFromPhoto.has_value()) << places.photos[i].why;
        EXPECT_EQ(places.photos[i].doubt, "");
        const Eigen::Vector3d way =
            places.photos[i].roomFromPhoto->translation - places.photos[0].roomFromPhoto->translation;
        const Eigen::Vector3d truth =
            survey.roomFromPhoto[i].translation - survey.roomFromPhoto[0].translation;
        EXPECT_NEAR(way.norm(), truth.norm(), 0.05) << i;
    }
}

// Every fourth thing stands in both rooms, and the photos of one are taken for photos of the other.
TEST(Lookalikes, AreLeftOutWhereThePlacesBearThemOut) {
    test::Random random{77};
    FurnishedSurvey rooms{{4, 5, 0.7, 1.5}, random};
    rooms.expose(random);
    const auto isBetween = [](const PhotoPair& pair) { return (pair.a < 12) != (pair.b < 12); };
    for (PhotoPair& pair : rooms.pairs) {
        if (isBetween(pair)) {
            std::erase_if(pair.matches, [](const Correspondence& match) { return match.featureA % 4 != 0; });
        }
    }
    FreePlaces places;
    for (const std::optional<Rigid3>& pose : rooms.roomFromPhoto) {
        places.photos.emplace_back().roomFromPhoto = pose;
    }
    places.scaleBy = ScaleBy::Floor;
    const std::vector<PairEstimate> estimates = estimatePairs(rooms.pairs);
    const std::vector<PairEstimate> fewer = PlaceAgreement(places, rooms.pairs).withoutLookalikes(estimates);
    ASSERT_EQ(fewer.size(), estimates.size());
    int leftOut = 0;
    for (std::size_t i = 0; i < fewer.size(); ++i) {
        const bool isLeftOut = fewer[i].verdict != estimates[i].verdict;
        EXPECT_TRUE(!isLeftOut || isBetween(rooms.pairs[i])) << i;
        leftOut += isLeftOut ? 1 : 0;
    }
    EXPECT_GT(leftOut, 0);
    // Elsewhere nothing bears them out, so that it is not known which is wrong.
    for (std::size_t i = 12; i < places.photos.size(); ++i) {
        places.photos[i].roomFromPhoto->translation += Eigen::Vector3d(0.5, 0.3, 0);
    }
    EXPECT_THAT(PlaceAgreement(places, rooms.pairs).withoutLookalikes(estimates), ::testing::IsEmpty());
}

} // namespace spherewalk::align
