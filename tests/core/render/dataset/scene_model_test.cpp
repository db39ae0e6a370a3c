// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "sphere/exact_view.h"

#include "spherewalk/base/text.h"
#include "spherewalk/render/ladder.h"

#include <cmath>

namespace spherewalk::render {

using Eigen::Vector3d;
using Vector3l = Eigen::Matrix<long double, 3, 1>;

namespace {

/// The textbook formula in long double.
Vector3l exactDirection(const Vector3d& offset, const Vector3d& ray, double radius) {
    const Vector3l o = offset.cast<long double>();
    const Vector3l d = ray.cast<long double>().normalized();
    const long double b = o.dot(d);
    const long double t = -b + std::sqrt(b * b + static_cast<long double>(radius) * radius - o.squaredNorm());
    return o + t * d;
}

} // namespace

TEST(SphereModel, TurnsOnlyWhenTheCameraStandsAtThePhoto) {
    test::Random random(21);
    for (int i = 0; i < 1000; ++i) {
        const Vector3d ray = random.direction();
        ASSERT_LT((directionOnSphere(Vector3d::Zero(), ray, 3) - ray).norm(), 1e-15);
    }
}

TEST(SphereModel, AgreesWithLongDoubleUpToTheEdgeOfTheSphere) {
    test::Random random(22);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const double radius = std::exp(random.uniform(-7, 14)); // a millimetre to a thousand kilometres
        const double share = i % 2 == 0 ? random.uniform(0, 1) : std::pow(10, random.uniform(-12, 0));
        const Vector3d offset = random.direction() * (share * kLargestDisplacement * radius);
        const Vector3d ray =
            i % 3 == 0 ? Vector3d(offset.normalized() * (i % 6 == 0 ? 1 : -1)) : random.direction();
        const Vector3l exact = exactDirection(offset, ray, radius).normalized();
        const Vector3d got = directionOnSphere(offset, ray, radius).normalized();
        worst = std::max(worst, static_cast<double>((got.cast<long double>() - exact).norm()));
    }
    RecordProperty("worst_rad", std::to_string(worst));
    EXPECT_LT(worst, 5e-15); // 4e-12 of a pixel of a 5376 x 2688 photo
}

TEST(SphereModel, KnowsHowFarARayGoes) {
    test::Random random(24);
    SCOPED_TRACE(random.seed());
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const double radius = std::exp(random.uniform(-7, 14));
        const Vector3d offset = random.direction() * (random.uniform(0, kLargestDisplacement) * radius);
        const Vector3d ray =
            i % 3 == 0 ? Vector3d(offset.normalized() * (i % 6 == 0 ? 1 : -1)) : random.direction();
        const Vector3l d = ray.cast<long double>().normalized();
        const long double exact = (exactDirection(offset, ray, radius) - offset.cast<long double>()).dot(d);
        const double got = radius * DisplacedCamera(offset, radius).distance(ray);
        worst = std::max(worst, static_cast<double>(std::abs(got - exact) / exact));
    }
    RecordProperty("worst_relative", text(worst));
    EXPECT_LT(worst, 2e-14);
    // From where it is taken to stand, if it is outside.
    EXPECT_NEAR(DisplacedCamera({50, 0, 0}, 2).distance({1, 0, 0}), 0.05, 1e-12);
}

TEST(SphereModel, PutsThingsOnTheSphereWhereTheyBelong) {
    // A camera 1 m ahead in a sphere of 2 m that looks left sees the point (1, sqrt(3), 0).
    const Vector3d d = directionOnSphere({1, 0, 0}, {0, 1, 0}, 2);
    EXPECT_LT((2 * d.normalized() - Vector3d(1, std::sqrt(3), 0)).norm(), 1e-14);
}

TEST(SphereModel, StaysFiniteOutsideOfTheSphere) {
    test::Random random(23);
    for (const double distance : {1.0, 1.9, 2.0, 5.0, 1e6}) {
        for (int i = 0; i < 100; ++i) {
            const Vector3d away = random.direction();
            const Vector3d ray = random.direction();
            const Vector3d d = directionOnSphere(away * distance, ray, 2);
            ASSERT_TRUE(d.allFinite());
            ASSERT_NEAR(d.norm(), 1, 1e-12);
        }
    }
}

TEST(SceneKind, IsSpeltOneWay) {
    for (const SceneKind kind :
         {SceneKind::None, SceneKind::Sphere, SceneKind::Room, SceneKind::Depth, SceneKind::Blend}) {
        EXPECT_EQ(sceneKind(name(kind)), kind);
    }
    test::expectError(ErrorKind::InvalidInput, "\"cube\" is unknown", [] { sceneKind("cube"); });
}

} // namespace spherewalk::render
