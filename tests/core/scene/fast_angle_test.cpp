// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast_angle.h"
#include "random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spherewalk::scene {

TEST(FastAngle, IsTheAngleInSinglePrecision) {
    test::Random random(4);
    for (int i = 0; i < 100'000; ++i) {
        const auto y = static_cast<float>(random.uniform(-1, 1));
        const auto x = static_cast<float>(random.uniform(-1, 1));
        const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
        ASSERT_NEAR(fastAngle(y, x), exact, 4e-7) << y << ", " << x;
    }
}

TEST(FastAngle, IsRightOnTheAxes) {
    constexpr double kPi = std::numbers::pi;
    EXPECT_NEAR(fastAngle(0, 1), 0, 1e-9);
    EXPECT_NEAR(fastAngle(1, 0), kPi / 2, 3e-7);
    EXPECT_NEAR(fastAngle(-1, 0), -kPi / 2, 3e-7);
    EXPECT_NEAR(fastAngle(0, -1), kPi, 3e-7);
    EXPECT_EQ(fastAngle(0, 0), 0);
}

} // namespace spherewalk::scene
