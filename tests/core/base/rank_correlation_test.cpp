// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace spherewalk {

TEST(RankCorrelation, LooksAtTheOrderAlone) {
    const std::vector<double> a{1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(rankCorrelation(a, std::vector<double>{-5, 0, 1, 1e9}).value(), 1);
    EXPECT_DOUBLE_EQ(rankCorrelation(a, std::vector<double>{9, 7, 3, 1}).value(), -1);
    EXPECT_NEAR(rankCorrelation(a, std::vector<double>{2, 1, 4, 3}).value(), 0.6, 1e-12);
}

TEST(RankCorrelation, SharesRanksAmongEqualValues) {
    // Ranks 0.5, 0.5, 2 against 0, 1, 2.
    EXPECT_NEAR(rankCorrelation(std::vector<double>{1, 1, 2}, std::vector<double>{1, 2, 3}).value(),
                0.8660254, 1e-6);
}

TEST(RankCorrelation, IsUnknownOfFewOrEqualValues) {
    EXPECT_FALSE(rankCorrelation(std::vector<double>{1, 2}, std::vector<double>{1, 2}));
    EXPECT_FALSE(rankCorrelation(std::vector<double>{1, 1, 1}, std::vector<double>{1, 2, 3}));
}

TEST(RankCorrelation, IsTheSameBothWaysAndChangesItsSignWithTheOrder) {
    std::mt19937 random(4);
    std::uniform_int_distribution whole(0, 12);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int round = 0; round < 50; ++round) {
        std::vector<double> a;
        std::vector<double> b;
        std::vector<double> falling;
        for (int i = 0; i < 20; ++i) {
            a.push_back(whole(random)); // with equal values
            b.push_back(uniform(random));
            falling.push_back(-std::exp(b.back()));
        }
        const double correlation = rankCorrelation(a, b).value();
        EXPECT_LE(std::abs(correlation), 1 + 1e-12);
        EXPECT_NEAR(rankCorrelation(b, a).value(), correlation, 1e-12);
        EXPECT_NEAR(rankCorrelation(a, falling).value(), -correlation, 1e-12);
        EXPECT_NEAR(rankCorrelation(a, a).value(), 1, 1e-12);
    }
}

TEST(RankCorrelation, IsUnknownOfListsOfDifferentLengths) {
    EXPECT_FALSE(rankCorrelation(std::vector<double>{1, 2, 3}, std::vector<double>{1, 2, 3, 4}));
    EXPECT_FALSE(rankCorrelation({}, {}));
}

TEST(RankCorrelation, OrdersByRankAloneHoweverFarValuesLieApart) {
    const std::vector<double> far{-1e300, 0, 1e-300, 1e300};
    EXPECT_NEAR(rankCorrelation(far, std::vector<double>{1, 2, 3, 4}).value(), 1, 1e-12);
    EXPECT_NEAR(rankCorrelation(far, std::vector<double>{4, 3, 2, 1}).value(), -1, 1e-12);
}

} // namespace spherewalk
