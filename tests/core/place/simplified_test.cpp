// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "seen_room.h"

#include "spherewalk/place/surface.h"

#include <gtest/gtest.h>

namespace spherewalk::place {

using test::SeenRoom;

TEST(Flatten, MovesWhatIsNearAWallOntoItAndNothingElse) {
    const SeenRoom room;
    Surface surface = room.surface();
    test::Random random(7);
    for (SurfaceVertex& vertex : surface.vertices) {
        vertex.pInRoom += random.uniform(-0.01, 0.01) * vertex.normal.cast<double>();
    }
    SurfaceVertex aside;
    aside.pInRoom = {1.5, 0.02, 1};
    aside.normal = {-1, 0, 0};
    surface.vertices.push_back(aside);
    flatten(surface, room.shape, 0.04);
    EXPECT_EQ(surface.vertices.back().pInRoom, aside.pInRoom) << "it looks another way";
    surface.vertices.pop_back();
    std::size_t flat = 0;
    for (const SurfaceVertex& vertex : surface.vertices) {
        flat += room.distanceM(vertex.pInRoom) < 1e-9 ? 1 : 0;
    }
    EXPECT_GT(static_cast<double>(flat), 0.97 * static_cast<double>(surface.vertices.size()));
}

TEST(Simplified, NeedsFewTrianglesForAFlatRoom) {
    for (const Eigen::Vector3d& origin : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e6, -1e6, 0)}) {
        const SeenRoom room(origin);
        Surface surface = room.surface();
        flatten(surface, room.shape, 0.04);
        const Surface simple = simplified(surface, 0.01);
        EXPECT_LT(simple.triangles.size(), surface.triangles.size() / 20);
        EXPECT_NEAR(simple.areaM2(), surface.areaM2(), 0.02 * surface.areaM2());
        for (const SurfaceVertex& vertex : simple.vertices) {
            EXPECT_LT(room.distanceM(vertex.pInRoom), 0.03);
            EXPECT_GT(vertex.photos, 0) << "it is one of those before";
        }
    }
}

TEST(Simplified, OfNothingIsNothing) {
    EXPECT_TRUE(simplified({}, 0.01).triangles.empty());
}

TEST(Furniture, IsWhatStandsAwayFromFloorWallsAndCeiling) {
    const SeenRoom room;
    Surface surface = room.surface();
    EXPECT_TRUE(furnitureOf(surface, room.shape, 0.06).triangles.empty()) << "the room is empty";
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    for (const auto& [x, z] : {std::pair{1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}) {
        SurfaceVertex vertex;
        vertex.pInRoom = {x, 1, z};
        surface.vertices.push_back(vertex);
    }
    surface.triangles.push_back({first, first + 1, first + 2});
    const Surface furniture = furnitureOf(surface, room.shape, 0.06);
    ASSERT_EQ(furniture.triangles.size(), 1U) << "a board that stands on the floor";
    EXPECT_NEAR(furniture.areaM2(), 0.5, 1e-9);
}

} // namespace spherewalk::place
