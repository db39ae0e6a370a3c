// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/statistics.h"

#include <gtest/gtest.h>

namespace spherewalk {

using Values = std::vector<double>;

TEST(Statistics, AQuantileIsOneOfTheValues) {
    EXPECT_EQ(quantile(Values{3}, 0.5), 3);
    EXPECT_EQ(quantile(Values{5, 1, 4, 2, 3}, 0.5), 3);
    EXPECT_EQ(quantile(Values{5, 1, 4, 2, 3}, 0.3), 2);
    EXPECT_EQ(quantile(Values{5, 1, 4, 2, 3}, 0.99), 5);
}

TEST(Statistics, SharesOfNoneAndAllAreTheLeastAndTheGreatest) {
    EXPECT_EQ(quantile(Values{5, 1, 4, 2, 3}, 0), 1);
    EXPECT_EQ(quantile(Values{5, 1, 4, 2, 3}, 1), 5);
}

TEST(Statistics, AQuantileLeavesTheCallersValuesInOrder) {
    const std::vector<int> values{9, 1, 5};
    EXPECT_EQ(quantile(values, 0.5), 5);
    EXPECT_EQ(values, (std::vector<int>{9, 1, 5}));
}

TEST(Statistics, TheMedianOfAnEvenCountIsTheUpperOfTwo) {
    EXPECT_EQ(median(Values{1, 2, 3, 4}), 3);
    EXPECT_EQ(median(Values{}), 0);
}

} // namespace spherewalk
