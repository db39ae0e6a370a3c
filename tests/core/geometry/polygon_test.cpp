// SPDX-License-Identifier: Apache-2.0
#include "random.h"

#include "spherewalk/geometry/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk {

using Eigen::Vector2d;
using testing::HasSubstr;

namespace {

const Polygon kLShape{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};

Polygon moved(Polygon polygon, const Vector2d& by) {
    for (Vector2d& vertex : polygon) {
        vertex += by;
    }
    return polygon;
}

} // namespace

TEST(Polygon, KnowsItsAreaInsideAndEdgesAlsoAMillionMetresAway) {
    for (const Vector2d& by : {Vector2d(0, 0), Vector2d(1e6, -1e6)}) {
        const Polygon polygon = moved(kLShape, by);
        EXPECT_NEAR(signedArea(polygon), 12, 1e-8);
        EXPECT_TRUE(contains(polygon, by + Vector2d(1, 3)));
        EXPECT_FALSE(contains(polygon, by + Vector2d(3, 3)));
        EXPECT_TRUE(contains(polygon, by + Vector2d(2, 3)));
        EXPECT_NEAR(distanceToEdge(polygon, by + Vector2d(3, 3)), 1, 1e-9);
        EXPECT_NEAR(distanceToEdge(polygon, by + Vector2d(1, 1)), 1, 1e-9);
        EXPECT_EQ(distanceToEdge(polygon, by + Vector2d(1, 3), by + Vector2d(3, 3)), 0);
        EXPECT_NEAR(distanceToEdge(polygon, by + Vector2d(0.5, 0.5), by + Vector2d(3.5, 0.5)), 0.5, 1e-9);
        EXPECT_FALSE(defect(polygon));
    }
    Polygon clockwise(kLShape.rbegin(), kLShape.rend());
    EXPECT_NEAR(signedArea(clockwise), -12, 1e-12);
}

TEST(Polygon, ContainsAgreesWithTheSignOfACountedWinding) {
    test::Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const Vector2d p(random.uniform(-1, 5), random.uniform(-1, 5));
        double winding = 0;
        for (std::size_t k = 0; k < kLShape.size(); ++k) {
            const Vector2d a = kLShape[k] - p;
            const Vector2d b = kLShape[(k + 1) % kLShape.size()] - p;
            winding += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
        ASSERT_EQ(contains(kLShape, p), std::abs(winding) > 3) << p.transpose();
    }
}

TEST(Polygon, NamesItsDefect) {
    EXPECT_THAT(*defect({{0, 0}, {1, 1}}), HasSubstr("2 corners"));
    EXPECT_THAT(*defect({{0, 0}, {1, 0}, {std::nan(""), 1}}), HasSubstr("not a number"));
    EXPECT_THAT(*defect({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
                HasSubstr("wall after corner 1 crosses the wall after corner 3"));
    EXPECT_THAT(*defect({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), HasSubstr("same point"));
    EXPECT_THAT(*defect({{0, 0}, {2, 0}, {1, 0}}), HasSubstr("turns back"));
    EXPECT_THAT(*defect({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), HasSubstr("crosses"));
}

} // namespace spherewalk
