// SPDX-License-Identifier: Apache-2.0
#include "random.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

namespace spherewalk {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

TEST(Equirect, CentreLooksForwardLeftHalfShowsTheLeftTopShowsUp) {
    const EquirectSize size{360, 180};
    EXPECT_LT((direction(size, {179.5, 89.5}) - Vector3d::UnitX()).norm(), 1e-15);
    EXPECT_LT((direction(size, {89.5, 89.5}) - Vector3d::UnitY()).norm(), 1e-15);
    EXPECT_LT((direction(size, {12, -0.5}) - Vector3d::UnitZ()).norm(), 1e-15);
    EXPECT_LT((pixel(size, Vector3d(0, -1, 0)) - Vector2d(269.5, 89.5)).norm(), 1e-12);
    EXPECT_LT((pixel(size, Vector3d(0, 0, -2)) - Vector2d(179.5, 179.5)).norm(), 1e-12);
}

TEST(Equirect, FollowsTheDocumentedFormula) {
    const EquirectSize size{5376, 2688};
    test::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vector2d at(random.uniform(-0.5, size.width - 0.5), random.uniform(-0.5, size.height - 0.5));
        const double azimuth = pi - 2 * pi * (at.x() + 0.5) / size.width;
        const double elevation = pi / 2 - pi * (at.y() + 0.5) / size.height;
        const Vector3d expected(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        ASSERT_LT((direction(size, at) - expected).norm(), 1e-15);
    }
}

TEST(Equirect, RoundTripsEveryPixelCentre) {
    for (const EquirectSize size : {EquirectSize{1, 1}, {2, 1}, {7, 3}, {512, 256}}) {
        for (int v = 0; v < size.height; ++v) {
            for (int u = 0; u < size.width; ++u) {
                const Vector2d at(u, v);
                ASSERT_LT((pixel(size, direction(size, at)) - at).norm(), 1e-9) << u << " " << v;
            }
        }
    }
}

TEST(Equirect, WrapsAtTheSeamAndStaysInTheRangeItStates) {
    const EquirectSize size{5376, 2688};
    EXPECT_EQ(pixel(size, Vector3d(-1, 0, 0)).x(), -0.5);
    EXPECT_EQ(pixel(size, Vector3d(-1, -0.0, 0)).x(), -0.5);
    EXPECT_NEAR(pixel(size, Vector3d(-1, -1e-15, 0)).x(), size.width - 0.5, 1e-9);
    EXPECT_LT((direction(size, {-0.5, 3}) - direction(size, {size.width - 0.5, 3})).norm(), 1e-12);
    test::Random random(6);
    for (int i = 0; i < 10000; ++i) {
        const Vector2d at = pixel(size, random.direction() * std::exp(random.normal(10)));
        ASSERT_GE(at.x(), -0.5);
        ASSERT_LE(at.x(), size.width - 0.5);
        ASSERT_GE(at.y(), -0.5);
        ASSERT_LE(at.y(), size.height - 0.5);
    }
}

TEST(Equirect, KeepsItsDigitsAtThePoles) {
    for (const double distance : {1e-3, 1e-8, 1e-12}) {
        const Vector3d nearPole(distance, 0, std::sqrt(1 - distance * distance));
        EXPECT_NEAR(pi / 2 - sphericalDirection(nearPole).elevation.value(), distance,
                    1e-3 * distance + 2e-16);
    }
}

// A mirrored or turned convention fails here: three directions in different octants must land in the right
// quarter.
TEST(Equirect, IsNeitherMirroredNorTurned) {
    const EquirectSize size{400, 200};
    const Vector2d frontLeftUp = pixel(size, Vector3d(1, 1, 1));
    EXPECT_NEAR(frontLeftUp.x(), 149.5, 1e-9);
    EXPECT_LT(frontLeftUp.y(), 99.5);
    const Vector2d backRightDown = pixel(size, Vector3d(-1, -1, -1));
    EXPECT_NEAR(backRightDown.x(), 349.5, 1e-9);
    EXPECT_GT(backRightDown.y(), 99.5);
    EXPECT_NEAR(pixel(size, Vector3d(-1, 1, 0)).x(), 49.5, 1e-9);
}

} // namespace spherewalk
