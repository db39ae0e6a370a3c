// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/error_colour.h"
#include "spherewalk/measure/rank_correlation.h"

#include <gtest/gtest.h>

#include <vector>

namespace spherewalk::measure {

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

TEST(ErrorColour, TellsWithinFromBeyondAndUnknown) {
    EXPECT_EQ(errorColour(2, 2), "#ffffbf");
    EXPECT_EQ(errorColour(0, 2), errorColour(0.5, 2)); // the bluest from a quarter on
    EXPECT_EQ(errorColour(8, 2), errorColour(1e9, 2));
    EXPECT_NE(errorColour(0.5, 2), errorColour(8, 2));
    EXPECT_NE(errorColour(std::nullopt, 2), errorColour(2, 2));
}

} // namespace spherewalk::measure
