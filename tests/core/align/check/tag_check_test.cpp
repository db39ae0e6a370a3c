// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/synthetic_survey.h"
#include "random.h"

#include "spherewalk/align/content_check.h"
#include "spherewalk/align/tag_check.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

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

TEST(TagCheck, TellsASmallStretchBySolvedPlacesAlsoWithWrongTags) {
    test::Random random(5);
    for (const double stretch : {1., 1.02, 0.8, 1.25}) {
        for (const double farM : {0., 1e6}) {
            std::vector<Eigen::Vector2d> tagged;
            std::vector<Eigen::Vector2d> solved;
            for (int i = 0; i < 25; ++i) {
                const Eigen::Vector2d place(0.2 * (i % 5), 0.2 * (i / 5));
                tagged.emplace_back(farM + place.x() + random.normal(0.003),
                                    stretch * place.y() + random.normal(0.003));
                solved.emplace_back(Eigen::Rotation2Dd(0.3) * (1.04 * place) - Eigen::Vector2d(farM, 2));
                tagged.back() += i % 7 == 3 ? Eigen::Vector2d(0.2, -0.1) : Eigen::Vector2d(0, 0);
            }
            const std::optional<Scale> found = yOverX(tagged, solved);
            ASSERT_TRUE(found);
            EXPECT_LT(found->sigma, 0.008);
            EXPECT_NEAR(found->value, stretch, 4 * found->sigma);
        }
    }
}

TEST(TagCheck, OfPhotosOnOneLineOrFewTellsNoStretch) {
    test::Random random(6);
    std::vector<Eigen::Vector2d> line;
    std::vector<Eigen::Vector2d> tagged;
    for (int i = 0; i < 12; ++i) {
        line.emplace_back(0.2 * i, 0);
        tagged.emplace_back(0.2 * i + random.normal(0.003), random.normal(0.003));
    }
    EXPECT_FALSE(yOverX(tagged, line));
    EXPECT_FALSE(yOverX(std::span(tagged).first(5), std::span(line).first(5)));
    const std::vector<Eigen::Vector2d> one(12, {1, 1});
    EXPECT_FALSE(yOverX(one, one));
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

namespace {

/// The estimates as if the second photo of the first pair had been taken where the first was.
std::vector<PairEstimate> withoutMove(const std::vector<PairEstimate>& estimates) {
    const PairEstimate& first = estimates.front();
    std::vector<PairEstimate> still{first};
    still.front().aFromB = Eigen::Quaterniond::Identity();
    still.front().parallaxRad = 0.0005;
    for (const PairEstimate& pair : estimates) {
        if (pair.a == first.b || pair.b == first.b) {
            continue;
        }
        still.push_back(pair);
        if (pair.a == first.a || pair.b == first.a) {
            still.push_back(pair);
            (pair.a == first.a ? still.back().a : still.back().b) = first.b;
        }
    }
    return still;
}

} // namespace

TEST(TagCheck, NamesPhotosThatWereTakenAtOnePlace) {
    const SyntheticSurvey survey = syntheticSurvey({});
    const auto estimates = estimatePairs(survey.pairs);
    EXPECT_TRUE(photosAtOnePlace(survey.photos, estimates).empty());
    const std::vector<OnePlace> found = photosAtOnePlace(survey.photos, withoutMove(estimates));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().a, estimates.front().a);
    EXPECT_EQ(found.front().b, estimates.front().b);
}

TEST(TagCheck, BelievesNoPairThatThirdPhotosContradict) {
    const SyntheticSurvey survey = syntheticSurvey({});
    auto estimates = estimatePairs(survey.pairs);
    estimates.front().parallaxRad = 0.0005; // as of two doors that look alike
    EXPECT_TRUE(photosAtOnePlace(survey.photos, estimates).empty());
}

} // namespace spherewalk::align
