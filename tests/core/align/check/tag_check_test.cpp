// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/synthetic_survey.h"

#include "spherewalk/align/content_check.h"
#include "spherewalk/align/tag_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace spherewalk::align {

namespace {

/// A survey whose tags are stretched.
TagFrame frameOf(double byX, double byY, bool isExchanged = false) {
    SyntheticSurvey survey = syntheticSurvey({});
    for (PhotoPrior& photo : survey.photos) {
        photo.positionM.x() *= byX;
        photo.positionM.y() *= byY;
        if (isExchanged) {
            std::swap(photo.positionM.x(), photo.positionM.y());
        }
    }
    return tagFrame(survey.photos, estimatePairs(survey.pairs));
}

} // namespace

TEST(TagCheck, TellsThatTheAxesHaveOneScale) {
    const TagFrame frame = frameOf(1, 1);
    EXPECT_FALSE(frame.isMirrored);
    ASSERT_TRUE(frame.yOverX);
    EXPECT_NEAR(frame.yOverX->value, 1, 3 * frame.yOverX->sigma);
    EXPECT_LT(frame.yOverX->sigma, 0.03);
}

TEST(TagCheck, TellsHowMuchLongerOneAxisIs) {
    for (const auto& [byX, byY] : {std::pair(1., 1.25), {1., 0.8}, {1.25, 1.}, {1.1, 1.}}) {
        const TagFrame frame = frameOf(byX, byY);
        EXPECT_FALSE(frame.isMirrored);
        ASSERT_TRUE(frame.yOverX);
        EXPECT_NEAR(frame.yOverX->value, byY / byX, 0.03) << byX << " " << byY;
    }
}

TEST(TagCheck, TellsMirroredAxesAndExchangedOnes) {
    EXPECT_TRUE(frameOf(-1, 1).isMirrored);
    EXPECT_TRUE(frameOf(1, -1).isMirrored);
    EXPECT_TRUE(frameOf(1, 1, true).isMirrored);
    EXPECT_FALSE(frameOf(-1, -1).isMirrored);
}

TEST(TagCheck, TellsTheScaleByTheFloor) {
    const SyntheticSurvey survey = syntheticSurvey({});
    for (const double scale : {0.8, 1., 1.25}) {
        std::vector<std::optional<Rigid3>> solved;
        for (const Rigid3& pose : survey.roomFromPhoto) {
            Rigid3 scaled = pose;
            scaled.translation.head<2>() *= scale;
            solved.emplace_back(scaled);
        }
        const auto found = scaleByFloor(solved, survey.pairs, fittingMatches(solved, survey.pairs));
        ASSERT_TRUE(found) << scale;
        EXPECT_NEAR(found->value, scale, 0.03);
    }
}

TEST(TagCheck, NamesPhotosThatWereTakenAtOnePlace) {
    SyntheticSurvey survey = syntheticSurvey({});
    const auto estimates = estimatePairs(survey.pairs);
    EXPECT_TRUE(photosAtOnePlace(survey.photos, estimates).empty());
    std::vector<PairEstimate> still = estimates;
    still.front().parallaxRad = 0.0005;
    const std::vector<OnePlace> found = photosAtOnePlace(survey.photos, still);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().a, still.front().a);
    EXPECT_EQ(found.front().b, still.front().b);
}

} // namespace spherewalk::align
