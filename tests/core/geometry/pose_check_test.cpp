// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/geometry/pose_check.h"

#include <gtest/gtest.h>

#include <limits>

namespace spherewalk {

TEST(PoseCheck, AsksForAPlaceAndARotation) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(isPose({}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond(0, 0, 0, 0), {0, 0, 0}}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond(kNan, 0, 0, 0), {0, 0, 0}}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond::Identity(), {0, kNan, 0}}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond(1.0005, 0, 0, 0), {0, 0, 0}}, 1e-6));
}

} // namespace spherewalk
