// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/fixed_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace spherewalk {

TEST(FixedRandom, GivesThePublishedSequenceOfSplitMix64) {
    FixedRandom random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317ULL);
    EXPECT_EQ(random.next(), 3203168211198807973ULL);
    EXPECT_EQ(random.next(), 9817491932198370423ULL);
}

// Photos of the practice camera and saved alignments depend on these numbers.
TEST(FixedRandom, KeepsTheNumbersThatSurveysWereMadeWith) {
    FixedRandom stream(7, 3);
    EXPECT_EQ(stream.next(), 1636221917143832206ULL);
    EXPECT_EQ(stream.next(), 18012553578726050756ULL);
    FixedRandom random(9);
    EXPECT_EQ(random.sumNormal(), 0x1.35acd7f72d634p-2);
    EXPECT_EQ(random.permutation(8), (std::vector<int>{2, 6, 4, 1, 0, 7, 3, 5}));
    EXPECT_DOUBLE_EQ(FixedRandom(9, 9).normal(2), -0.9099434864710183);
}

TEST(FixedRandom, UniformNumbersFillTheirIntervalEvenly) {
    FixedRandom random(3);
    std::vector<int> counts(10);
    for (int i = 0; i < 100000; ++i) {
        const double number = random.uniform(-2, 3);
        ASSERT_GE(number, -2);
        ASSERT_LT(number, 3);
        ++counts[static_cast<std::size_t>((number + 2) * 2)];
    }
    for (const int count : counts) {
        EXPECT_NEAR(count, 10000, 500);
    }
}

TEST(FixedRandom, BothKindsOfNormalNumbersHaveTheirMeanAndSpread) {
    FixedRandom random(4);
    double sum = 0;
    double squares = 0;
    double sumOfSums = 0;
    double squaresOfSums = 0;
    constexpr int kCount = 100000;
    for (int i = 0; i < kCount; ++i) {
        const double number = random.normal(3);
        sum += number;
        squares += number * number;
        const double other = random.sumNormal();
        sumOfSums += other;
        squaresOfSums += other * other;
    }
    EXPECT_NEAR(sum / kCount, 0, 0.05);
    EXPECT_NEAR(squares / kCount, 9, 0.2);
    EXPECT_NEAR(sumOfSums / kCount, 0, 0.02);
    EXPECT_NEAR(squaresOfSums / kCount, 1, 0.02);
}

TEST(FixedRandom, StreamsOfOneSeedShareNoNumbers) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t stream = 0; stream < 100; ++stream) {
        FixedRandom random(5, stream);
        for (int i = 0; i < 100; ++i) {
            EXPECT_TRUE(seen.insert(random.next()).second) << stream;
        }
    }
}

TEST(FixedRandom, APermutationHoldsEachIndexOnce) {
    FixedRandom random(6);
    for (int count = 0; count < 50; ++count) {
        std::vector<int> order = random.permutation(count);
        std::sort(order.begin(), order.end());
        for (int i = 0; i < count; ++i) {
            EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
        }
    }
}

TEST(FixedRandom, BelowReachesEveryIndexAndNoOther) {
    FixedRandom random(7);
    std::set<std::size_t> seen;
    for (int i = 0; i < 1000; ++i) {
        seen.insert(random.below(7));
    }
    EXPECT_EQ(seen.size(), 7U);
    EXPECT_EQ(*seen.rbegin(), 6U);
}

} // namespace spherewalk
