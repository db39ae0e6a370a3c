// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "vector_math.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::scene {

TEST(FastAngle, IsTheAngle) {
    test::Random random(4);
    for (int i = 0; i < 100'000; ++i) {
        const auto y = static_cast<float>(random.uniform(-1, 1));
        const auto x = static_cast<float>(random.uniform(-1, 1));
        const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
        ASSERT_NEAR(fastAngle(y, x), exact, 3e-6) << y << ", " << x;
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

TEST(FastPixel, IsWhereThePictureShowsADirection) {
    constexpr EquirectSize kSize{2048, 1024};
    test::Random random(9);
    for (int i = 0; i < 100'000; ++i) {
        const Eigen::Vector3d ray(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const Eigen::Vector3f given = ray.cast<float>(); // of any length
        const FastPixel at = fastPixel(given.x(), given.y(), given.z(), 2048);
        const Eigen::Vector2d exact = pixel(kSize, given.cast<double>());
        ASSERT_NEAR(std::remainder(at.u - exact.x(), 2048), 0, 1.4e-3) << ray.transpose();
        ASSERT_NEAR(at.v, std::max(0.0, exact.y()), 1.4e-3) << ray.transpose();
    }
}

TEST(FastPixel, StaysWithinATurnAndBelowTheFirstRow) {
    const auto isInRange = [](const FastPixel& at) { return at.u >= 0 && at.u <= 512 && at.v >= 0; };
    for (const float aside : {-1e-3F, -1e-8F, 0.0F, 1e-8F, 1e-3F}) {
        for (const float along : {-1.0F, 1.0F}) {
            EXPECT_TRUE(isInRange(fastPixel(along, aside, 0, 512))) << aside; // about the seam and opposite
            EXPECT_TRUE(isInRange(fastPixel(aside, 0, along, 512))) << aside; // about the poles
        }
    }
    EXPECT_TRUE(isInRange(fastPixel(0, 0, 0, 512)));
}

} // namespace spherewalk::scene
