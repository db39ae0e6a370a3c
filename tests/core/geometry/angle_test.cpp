// SPDX-License-Identifier: Apache-2.0
#include "random.h"

#include "spherewalk/geometry/angle.h"

#include <gtest/gtest.h>

namespace spherewalk {

using std::numbers::pi;

TEST(Angle, ConvertsBetweenDegreesAndRadians) {
    EXPECT_DOUBLE_EQ(Radians(Degrees(180)).value(), pi);
    EXPECT_DOUBLE_EQ(Degrees(Radians(pi / 2)).value(), 90);
}

TEST(Angle, WrapsIntoTheHalfOpenCircleWithPiItself) {
    EXPECT_EQ(wrapped(Radians(pi)).value(), pi);
    EXPECT_EQ(wrapped(Radians(-pi)).value(), pi);
    EXPECT_TRUE(std::isnan(wrapped(Radians(std::nan(""))).value()));
    test::Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const double angle = random.uniform(-1e4, 1e4);
        const double wrap = wrapped(Radians(angle)).value();
        ASSERT_GT(wrap, -pi);
        ASSERT_LE(wrap, pi);
        ASSERT_NEAR(std::sin(wrap), std::sin(angle), 1e-11) << angle;
        ASSERT_NEAR(std::cos(wrap), std::cos(angle), 1e-11) << angle;
    }
}

} // namespace spherewalk
