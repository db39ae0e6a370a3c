// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"

#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/geometry/rotation.h"

namespace spherewalk {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using std::numbers::pi;

TEST(Rotation, YawTurnsLeftPitchLowersTheNoseRollRaisesTheLeftSide) {
    const double angle = 0.3;
    const Vector3d nose = Vector3d::UnitX();
    const Vector3d left = Vector3d::UnitY();
    EXPECT_GT((rotation({Radians(angle), {}, {}}) * nose).y(), 0.29);
    EXPECT_LT((rotation({{}, Radians(angle), {}}) * nose).z(), -0.29);
    EXPECT_GT((rotation({{}, {}, Radians(angle)}) * left).z(), 0.29);
    EXPECT_NEAR(angleBetween(rotation({Radians(1), {}, {}}), yawRotation(Radians(1))).value(), 0, 1e-15);
}

TEST(Rotation, OpticalAxesAreForwardRightDown) {
    const Quaterniond bodyFromCamera = bodyFromOptical();
    EXPECT_LT((bodyFromCamera * Vector3d::UnitZ() - Vector3d::UnitX()).norm(), 1e-15);
    EXPECT_LT((bodyFromCamera * Vector3d::UnitX() + Vector3d::UnitY()).norm(), 1e-15);
    EXPECT_LT((bodyFromCamera * Vector3d::UnitY() + Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(Rotation, YawPitchRollRoundTripsEverywhereAndAtThePoles) {
    test::Random random(2);
    for (int i = 0; i < 10000; ++i) {
        const Quaterniond q = random.rotation();
        ASSERT_LT(angleBetween(rotation(yawPitchRoll(q)), q).value(), 1e-14) << i;
    }
    for (const double pitch : {pi / 2, -pi / 2, pi / 2 - 1e-9, -pi / 2 + 1e-13}) {
        for (const double yaw : {0.0, 1.0, pi, -2.5}) {
            const Quaterniond q = rotation({Radians(yaw), Radians(pitch), Radians(0.4)});
            const YawPitchRoll angles = yawPitchRoll(q);
            EXPECT_LT(angleBetween(rotation(angles), q).value(), 2e-12) << pitch << " " << yaw;
            EXPECT_LE(std::abs(angles.pitch.value()), pi / 2);
        }
    }
}

TEST(AngleBetween, IsExactFromTinyToOpposite) {
    test::Random random(3);
    for (const double angle : {0.0, 1e-12, 1e-6, 0.1, 3.0, pi - 1e-9, pi}) {
        const Vector3d axis = random.direction();
        const Quaterniond turned = random.rotation();
        const Quaterniond further = turned * Quaterniond(Eigen::AngleAxisd(angle, axis));
        EXPECT_NEAR(angleBetween(turned, further).value(), angle, 4e-16 + 1e-15 * angle);
        EXPECT_NEAR(angleBetween(turned, Quaterniond(-further.coeffs())).value(), angle,
                    4e-16 + 1e-15 * angle);
        const Vector3d across = axis.unitOrthogonal();
        const Vector3d other = std::cos(angle) * across + std::sin(angle) * axis.cross(across);
        EXPECT_NEAR(angleBetween(Vector3d(across * 1e6), other).value(), angle, 1e-15);
    }
}

TEST(Rotation, RefusesWhatIsNoUnitQuaternion) {
    EXPECT_NEAR(checkedQuaternion(0.999, 0, 0, 0, "x").norm(), 1, 1e-15);
    for (const double w : {0.0, 2.0, std::nan(""), HUGE_VAL}) {
        test::expectError(ErrorKind::InvalidInput, "rotation of photo 3",
                          [&] { checkedQuaternion(w, 0, 0, 0, "photo 3"); });
    }
}

TEST(Rigid3, ComposesAndInvertsFarFromTheOrigin) {
    test::Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const Rigid3 roomFromA{random.rotation(), random.vector(1e6)};
        const Rigid3 aFromB{random.rotation(), random.vector()};
        const Vector3d pInB = random.vector();
        const Vector3d pInRoom = roomFromA * (aFromB * pInB);
        ASSERT_LT(((roomFromA * aFromB) * pInB - pInRoom).norm(), 2e-9);
        ASSERT_LT(((roomFromA * aFromB).inverse() * pInRoom - pInB).norm(), 4e-9);
    }
}

} // namespace spherewalk
