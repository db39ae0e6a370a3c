// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <limits>

namespace spherewalk {

namespace {

Rigid3 somePose(test::Random& random) {
    return {random.rotation(), random.vector(3)};
}

void expectSame(const Rigid3& a, const Rigid3& b) {
    EXPECT_LT((a.translation - b.translation).norm(), 1e-12);
    EXPECT_LT(angleBetween(a.rotation, b.rotation).value(), 1e-12);
}

} // namespace

TEST(Rigid3, APoseIsAPlaceAndARotation) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(isPose({}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond(0, 0, 0, 0), {0, 0, 0}}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond(kNan, 0, 0, 0), {0, 0, 0}}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond::Identity(), {0, kNan, 0}}));
    EXPECT_FALSE(isPose({Eigen::Quaterniond(1.0005, 0, 0, 0), {0, 0, 0}}, 1e-6));
}

TEST(Rigid3, TheInverseUndoesThePoseFromBothSides) {
    test::Random random(11);
    for (int i = 0; i < 1000; ++i) {
        const Rigid3 pose = somePose(random);
        expectSame(pose * pose.inverse(), {});
        expectSame(pose.inverse() * pose, {});
    }
}

TEST(Rigid3, AProductActsAsItsFactorsDoOneAfterTheOther) {
    test::Random random(12);
    for (int i = 0; i < 1000; ++i) {
        const Rigid3 aFromB = somePose(random);
        const Rigid3 bFromC = somePose(random);
        const Eigen::Vector3d pInC = random.vector(2);
        EXPECT_LT(((aFromB * bFromC) * pInC - aFromB * (bFromC * pInC)).norm(), 1e-12);
    }
}

TEST(Rigid3, KeepsDistances) {
    test::Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const Rigid3 pose = somePose(random);
        const Eigen::Vector3d p = random.vector();
        const Eigen::Vector3d q = random.vector();
        EXPECT_NEAR((pose * p - pose * q).norm(), (p - q).norm(), 1e-12);
    }
}

TEST(Rigid3, InterpolationEndsAtItsPosesAndTurnsEvenly) {
    test::Random random(14);
    for (int i = 0; i < 1000; ++i) {
        const Rigid3 a = somePose(random);
        const Rigid3 b = somePose(random);
        expectSame(interpolated(a, b, 0), a);
        expectSame(interpolated(a, b, 1), b);
        const double share = random.uniform(0, 1);
        const Rigid3 between = interpolated(a, b, share);
        EXPECT_LT((between.translation - (a.translation + share * (b.translation - a.translation))).norm(),
                  1e-12);
        const double whole = angleBetween(a.rotation, b.rotation).value();
        EXPECT_NEAR(angleBetween(a.rotation, between.rotation).value(), share * whole, 1e-9);
    }
}

TEST(Rigid3, IsNoPoseBeyondTheMoon) {
    const auto at = [](double x) { return Rigid3{Eigen::Quaterniond::Identity(), {x, 0, 0}}; };
    EXPECT_TRUE(isPose(at(-1e9)));
    EXPECT_FALSE(isPose(at(1.1e9)));
    EXPECT_FALSE(isPose(at(1e160)));
    EXPECT_FALSE(isPose(at(std::nan(""))));
    EXPECT_FALSE(isPose({Eigen::Quaterniond(2, 0, 0, 0), {0, 0, 0}}));
}

} // namespace spherewalk
