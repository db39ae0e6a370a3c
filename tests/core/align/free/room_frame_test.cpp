// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"

#include "spherewalk/base/fixed_random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace spherewalk::align {

TEST(Floor, IsFoundBelowALongCorridor) {
    std::vector<Eigen::Vector3d> photos;
    std::vector<Eigen::Vector3d> points;
    FixedRandom random(6);
    for (int i = 0; i < 20; ++i) {
        photos.emplace_back(i, 0, 1.5);
        for (int point = 0; point < 10; ++point) {
            points.emplace_back(i + random.uniform(), 2 * random.uniform() - 1, 0);
            points.emplace_back(i + random.uniform(), 1, 1 + random.uniform());
        }
    }
    const auto floor = floorBelow(photos, points, Eigen::Vector3d::UnitZ(), Degrees(3));
    ASSERT_TRUE(floor);
    EXPECT_NEAR(floor->lensHeight, 1.5, 1e-6);
}

// Three of 400 points lie on it by chance once in 1500 draws.
TEST(Floor, IsFoundWhereFewPointsLieOnIt) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
        SCOPED_TRACE(seed);
        FixedRandom random(seed);
        std::vector<Eigen::Vector3d> photos;
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < 10; ++i) {
            photos.emplace_back(0.5 * i, 0, 1.2);
        }
        for (int i = 0; i < 400; ++i) {
            const double height = i < 36 ? 0.003 * random.sumNormal() : 0.05 + random.uniform();
            points.emplace_back(7 * random.uniform() - 1, 4 * random.uniform() - 2, height);
        }
        const auto floor = floorBelow(photos, points, Eigen::Vector3d::UnitZ(), Degrees(3));
        ASSERT_TRUE(floor.has_value());
        EXPECT_NEAR(floor->at, 0, 0.02);
        EXPECT_NEAR(floor->lensHeight, 1.2, 0.02);
    }
}

} // namespace spherewalk::align
