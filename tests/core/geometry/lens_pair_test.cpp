// SPDX-License-Identifier: Apache-2.0
#include "random.h"

#include "spherewalk/geometry/lens_pair.h"

#include <gtest/gtest.h>

namespace spherewalk {

TEST(LensPair, ShowsAThingInTheDirectionFromItsLens) {
    const LensPair lenses{0.01};
    test::Random random(3);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d direction = random.direction();
        const Eigen::Vector3d thing = lenses.place(direction) + random.uniform(0.1, 50) * direction;
        EXPECT_LT((lenses.directionTo(thing).normalized() - direction).norm(), 1e-12);
        EXPECT_LT((lenses.directionTo(0.2 * thing, 0.2) - 0.2 * lenses.directionTo(thing)).norm(), 1e-12);
    }
}

TEST(LensPair, HasNoPlacesOfItsOwnWhereBothLensesStandInOne) {
    test::Random random(4);
    const Eigen::Vector3d thing = random.vector();
    EXPECT_EQ(LensPair().directionTo(thing), thing);
    EXPECT_EQ(LensPair().place(-thing), Eigen::Vector3d::Zero());
}

TEST(LensPair, StandsBeforeAndBehindTheMiddle) {
    const LensPair lenses{0.012};
    EXPECT_EQ(lenses.place({0.1, 3, -2}), Eigen::Vector3d(0.012, 0, 0));
    EXPECT_EQ(lenses.place({-1e-9, 1, 0}), Eigen::Vector3d(-0.012, 0, 0));
    EXPECT_EQ(lenses.place({0, 1, 0}), Eigen::Vector3d(0.012, 0, 0)); // the seam
}

} // namespace spherewalk
