// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/statistics.h"
#include "spherewalk/place/surface.h"
#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <limits>

namespace spherewalk::place {
namespace {

/// What photos with exact depths see of the furnished practice room.
class PracticeSurface : public testing::Test {
  protected:
    PracticeSurface() {
        for (const double x : {1.0, 2.5, 4.0}) {
            for (const double y : {1.2, 2.8}) {
                const Rigid3 pose{Eigen::Quaterniond::Identity(), {x, y, 1.2}};
                const DepthImage range = room.sphericalRange(pose, {512, 256});
                Image<float, 1> inverse(512, 256);
                std::transform(range.values().begin(), range.values().end(), inverse.values().begin(),
                               [](float rangeM) { return 1 / rangeM; });
                depths.emplace_back(render::DepthMap(inverse), pose, LensPair{}, 1.0);
            }
        }
        surface = surfaceOf(fused(depths, {0.04}, noProgress(), {}));
        surface.weigh(depths, 0.04);
    }

    practice::PracticeRoom room;
    std::vector<SeenDepth> depths;
    Surface surface;
};

TEST_F(PracticeSurface, LiesWhereTheRoomIs) {
    std::vector<double> errors;
    for (const SurfaceVertex& vertex : surface.vertices) {
        errors.push_back(room.surfaceDistanceM(vertex.pInRoom));
    }
    EXPECT_GT(errors.size(), 50000U);
    EXPECT_LT(quantile(errors, 0.5), 0.005);
    EXPECT_LT(quantile(errors, 0.95), 0.02);
}

TEST_F(PracticeSurface, HasTheTableAndTheFloorBelowIt) {
    // The middle of the table of the practice room's plan stands at (3.85, 1.15).
    const auto near = [&](double z) {
        return std::count_if(surface.vertices.begin(), surface.vertices.end(),
                             [&](const SurfaceVertex& vertex) {
                                 return (vertex.pInRoom - Eigen::Vector3d(3.85, 1.15, z)).norm() < 0.1;
                             });
    };
    EXPECT_GT(near(room.cast({3.85, 1.15, 1.5}, {0, 0, -1}, 0.001).rangeM < 1 ? 0.75 : 0), 10);
    EXPECT_GT(near(0), 10);
    EXPECT_EQ(near(0.4), 0);
}

} // namespace
} // namespace spherewalk::place
