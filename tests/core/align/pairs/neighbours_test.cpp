// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/align/match_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherewalk::align {

using test::expectError;

namespace {

using Positions = std::vector<Eigen::Vector3d>;

Positions grid(int columns, int rows, double stepM) {
    Positions positions;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            positions.emplace_back(x * stepM, y * stepM, 1.2);
        }
    }
    return positions;
}

bool areConnected(std::size_t photos, const std::vector<std::pair<int, int>>& pairs) {
    std::vector<int> part(photos);
    std::iota(part.begin(), part.end(), 0);
    for (const auto& [a, b] : pairs) {
        const int from = part[static_cast<std::size_t>(a)];
        const int to = part[static_cast<std::size_t>(b)];
        std::replace(part.begin(), part.end(), from, to);
    }
    return std::adjacent_find(part.begin(), part.end(), std::not_equal_to<>()) == part.end();
}

int pairsOf(int photo, const std::vector<std::pair<int, int>>& pairs) {
    return static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [photo](const auto& pair) {
        return pair.first == photo || pair.second == photo;
    }));
}

} // namespace

TEST(Neighbours, OfAGridAreTheEightAround) {
    const auto pairs = neighbours(grid(5, 5, 0.2));
    EXPECT_EQ(pairs.size(), 2U * 5 * 4 + 2U * 4 * 4);
    EXPECT_EQ(pairsOf(12, pairs), 8);
}

TEST(Neighbours, AreTheSameWithTheCartsScatter) {
    test::Random random(1);
    SCOPED_TRACE(random.seed());
    Positions positions = grid(5, 5, 0.2);
    for (Eigen::Vector3d& position : positions) {
        position += random.vector(0.003);
    }
    EXPECT_EQ(neighbours(positions), neighbours(grid(5, 5, 0.2)));
}

TEST(Neighbours, ArePairsOnceAndSorted) {
    test::Random random(2);
    SCOPED_TRACE(random.seed());
    Positions positions;
    for (int i = 0; i < 100; ++i) {
        positions.push_back(random.vector(1));
    }
    NeighbourOptions options;
    options.farDirections = 4;
    const auto pairs = neighbours(positions, options);
    EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
    EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
    EXPECT_TRUE(
        std::all_of(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.first < pair.second; }));
    EXPECT_TRUE(areConnected(positions.size(), pairs));
}

TEST(Neighbours, ReachAcrossRailsThatAreFartherApartThanTheirStops) {
    Positions positions;
    for (int rail = 0; rail < 3; ++rail) {
        for (int stop = 0; stop < 8; ++stop) {
            positions.emplace_back(0.2 * stop, 0.6 * rail, 1.2);
        }
    }
    const auto pairs = neighbours(positions);
    EXPECT_TRUE(std::find(pairs.begin(), pairs.end(), std::pair(3, 11)) != pairs.end());
    EXPECT_TRUE(areConnected(positions.size(), pairs));
}

TEST(Neighbours, FarAwayFromTheOriginAreTheSame) {
    Positions positions = grid(4, 4, 0.2);
    for (Eigen::Vector3d& position : positions) {
        position += Eigen::Vector3d(1e6, -2e6, 0);
    }
    EXPECT_EQ(neighbours(positions), neighbours(grid(4, 4, 0.2)));
}

TEST(Neighbours, ConnectPartsByTheShortestWay) {
    Positions positions = grid(3, 1, 0.2);
    for (const Eigen::Vector3d& position : grid(3, 1, 0.2)) {
        positions.push_back(position + Eigen::Vector3d(10, 0, 0));
    }
    const auto pairs = neighbours(positions);
    EXPECT_TRUE(std::find(pairs.begin(), pairs.end(), std::pair(2, 3)) != pairs.end());
    EXPECT_TRUE(areConnected(6, pairs));
}

TEST(Neighbours, IncludeThoseAtTheSamePlace) {
    const Positions positions = {{0, 0, 1}, {0, 0, 1}, {0.001, 0, 1}, {0.3, 0, 1}};
    const auto pairs = neighbours(positions);
    for (const auto& pair : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        EXPECT_TRUE(std::find(pairs.begin(), pairs.end(), pair) != pairs.end());
    }
    EXPECT_TRUE(areConnected(4, pairs));
}

TEST(Neighbours, FarOnesAreTwoToThreeSteps) {
    NeighbourOptions options;
    options.farDirections = 4;
    const auto pairs = neighbours(grid(7, 1, 0.2), options);
    EXPECT_TRUE(std::find(pairs.begin(), pairs.end(), std::pair(0, 2)) != pairs.end());
    EXPECT_FALSE(std::find(pairs.begin(), pairs.end(), std::pair(0, 4)) != pairs.end());
}

TEST(Neighbours, OfOneOrNoPhotoAreNone) {
    EXPECT_TRUE(neighbours(Positions{}).empty());
    EXPECT_TRUE(neighbours(Positions{{1, 2, 3}}).empty());
}

TEST(Neighbours, RefusePositionsThatAreNotFinite) {
    expectError(ErrorKind::InvalidInput, "not finite", [] {
        neighbours(Positions{{0, 0, 0}, {std::nan(""), 0, 0}});
    });
}

namespace {

/// A pair that so many of a hundred matches hold.
PairEstimate held(int a, int b, int inliers) {
    PairEstimate estimate;
    estimate.a = a;
    estimate.b = b;
    estimate.verdict = PairVerdict::Constraint;
    estimate.inliers = inliers;
    estimate.inlierShare = inliers / 100.0;
    return estimate;
}

} // namespace

TEST(NeighboursApart, AreThosePairsThatNoEstimateJoins) {
    const Positions positions = grid(4, 1, 0.5);
    const auto all = neighbours(positions);
    EXPECT_EQ(neighboursApart(positions, {}), all);
    for (const auto& [a, b] : neighboursApart(positions, std::vector{held(0, 1, 90), held(2, 3, 90)})) {
        EXPECT_TRUE(a < 2 && b >= 2) << a << " and " << b;
    }
    const std::vector joined{held(0, 1, 90), held(1, 2, 90), held(2, 3, 90)};
    EXPECT_TRUE(neighboursApart(positions, joined).empty());
}

TEST(NeighboursApart, AreLookedAtAgainWhereOneWeakPairAloneJoinsTwoParts) {
    const Positions positions = grid(4, 1, 0.5);
    const auto apart =
        neighboursApart(positions, std::vector{held(0, 1, 90), held(1, 2, 18), held(2, 3, 90)});
    ASSERT_FALSE(apart.empty());
    for (const auto& [a, b] : apart) {
        EXPECT_TRUE(a < 2 && b >= 2) << a << " and " << b;
    }
    const std::vector confirmed{held(0, 1, 18), held(1, 2, 18), held(2, 3, 18), held(0, 2, 18),
                                held(1, 3, 18)};
    EXPECT_TRUE(neighboursApart(positions, confirmed).empty());
}

TEST(LoosePairs, AreThoseOfPhotosThatFewPairsHoldWell) {
    // Photos 0 to 3 hold each other; 4 hangs on one of them by a weak pair.
    std::vector<PairEstimate> estimates;
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(0, 3), std::pair(1, 2),
                               std::pair(1, 3), std::pair(2, 3)}) {
        estimates.push_back(held(a, b, 80));
    }
    EXPECT_TRUE(loosePairs(4, estimates, 80).empty());
    EXPECT_EQ(loosePairs(4, estimates, 81).size(), 6U);
    estimates.push_back(held(3, 4, 20));
    estimates.push_back(held(2, 4, 0));
    estimates.back().verdict = PairVerdict::TooFew;
    EXPECT_EQ(loosePairs(5, estimates, 80), (std::vector<std::pair<int, int>>{{2, 4}, {3, 4}}));
}

} // namespace spherewalk::align
