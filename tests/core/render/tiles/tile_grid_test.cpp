// SPDX-License-Identifier: Apache-2.0
#include "random.h"
#include "sphere/exact_view.h"
#include "tiles/tile_grid.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::render {
namespace {

using Eigen::Vector2d;

const EquirectSize kGridPhoto{1800, 900}; // the last column and row of tiles are cut

/// The tiles of the four pixels that a bilinear sample at each of the view's pixels reads.
TileSet touchedBy(const TileGrid& grid, const CameraModel& camera, const Projection& projection) {
    TileSet tiles(grid);
    const auto [width, height] = grid.photo();
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            const auto pixel = projection.photoPixel(Vector2d(x, y));
            for (int i = 0; pixel && i < 4; ++i) {
                int u = static_cast<int>(std::floor(pixel->x())) + i % 2;
                int v = static_cast<int>(std::floor(pixel->y())) + i / 2;
                if (v < 0 || v >= height) {
                    v = v < 0 ? -1 - v : 2 * height - 1 - v;
                    u += width / 2;
                }
                u = (u % width + width) % width;
                tiles.insert(v / TileGrid::kTileHeight * grid.columns() + u / TileGrid::kTileWidth);
            }
        }
    }
    return tiles;
}

CameraModel randomCamera(test::Random& random) {
    const double fov = random.uniform(0.02, 2.6);
    CameraIntrinsics k = CameraIntrinsics::pinhole(random.integer(1, 90), random.integer(1, 70), fov);
    switch (random.integer(0, 3)) {
    case 0:
        k.lens = LensModel::PlumbBob;
        k.fx = k.fy = std::max(2.0, k.fx); // a lens that sees nothing beside its axis is refused
        k.distortion = {random.uniform(-0.3, 0.1), random.uniform(-0.05, 0.05), 0.001, -0.002, 0};
        break;
    case 1:
        k.lens = LensModel::Equidistant;
        k.distortion = {0.01, -0.01, 0, 0};
        k.fx = k.fy = k.width / random.uniform(0.5, 7);
        break;
    default:
        break;
    }
    return CameraModel(k);
}

TEST(ViewFootprint, HoldsEveryTileThatAViewTouches) {
    test::Random random(91);
    const TileGrid grid(kGridPhoto);
    int touched = 0;
    int found = 0;
    for (int round = 0; round < 500; ++round) {
        const CameraModel camera = randomCamera(random);
        const double radius = 2;
        // Up to 0.95 of the radius from the photo, where the projection bends most.
        const Rigid3 pose{random.rotation(),
                          random.direction() * radius * std::min(1.0, random.uniform(0, 1.1)) * 0.95};
        const SceneKind scene = round % 3 == 0 ? SceneKind::None : SceneKind::Sphere;
        const Projection projection(camera, pose, {random.rotation(), {0, 0, 0}}, kGridPhoto, scene, radius);
        const PhotoDirectionAt at = [&](const Vector2d& p) { return projection.photoDirection(p); };
        const TileSet expected = touchedBy(grid, camera, projection);
        const TileSet got = ViewFootprint(camera).tiles(grid, at);
        expected.forEach([&](int tile) {
            ASSERT_TRUE(got.contains(tile))
                << "tile " << tile << ", round " << round << ", seed " << random.seed();
        });
        touched += expected.count();
        found += got.count();
    }
    EXPECT_LT(found, 2 * touched);
}

TEST(ViewFootprint, LooksAtPolesAndSeam) {
    const TileGrid grid(kGridPhoto);
    const CameraModel camera(CameraIntrinsics::pinhole(64, 48, 1));
    for (int pitch = -90; pitch <= 90; pitch += 5) {
        for (int yaw = 0; yaw < 360; yaw += 30) {
            const Rigid3 pose{rotation({Degrees(yaw), Degrees(pitch), Degrees(0)}) * bodyFromOptical(),
                              {0, 0, 0}};
            const Projection projection(camera, pose, {}, kGridPhoto, SceneKind::None, 1);
            const PhotoDirectionAt at = [&](const Vector2d& p) { return projection.photoDirection(p); };
            const TileSet got = ViewFootprint(camera).tiles(grid, at);
            touchedBy(grid, camera, projection).forEach([&](int tile) {
                ASSERT_TRUE(got.contains(tile)) << pitch << ", " << yaw;
            });
        }
    }
}

TEST(ViewFootprint, OfALevel90DegreeViewIsAboutAnEighthOfThePhoto) {
    const EquirectSize photo{5376, 2688};
    const CameraModel camera(CameraIntrinsics::pinhole(640, 480, std::numbers::pi / 2));
    const Projection projection(camera, {bodyFromOptical(), {0, 0, 0}}, {}, photo, SceneKind::None, 1);
    const TileGrid grid(photo);
    const TileSet tiles =
        ViewFootprint(camera).tiles(grid, [&](const Vector2d& p) { return projection.photoDirection(p); });
    EXPECT_GT(tiles.count(), grid.count() / 10);
    EXPECT_LT(tiles.count(), grid.count() / 7);
}

TEST(TileSet, BoxesGoOnAcrossTheSeamAndAreCutAtThePoles) {
    const TileGrid grid(kGridPhoto);
    EXPECT_EQ(grid.columns(), 15);
    EXPECT_EQ(grid.rows(), 15);
    TileSet set(grid);
    set.insertBox(-3, 70, -2, 71);
    EXPECT_EQ(set.count(), 1);
    EXPECT_TRUE(set.contains(15 + 14));
    set = TileSet(grid);
    set.insertBox(1795, -50, 1805, 899);
    EXPECT_EQ(set.count(), 30);
    set = TileSet(grid);
    set.insertBox(10, 899, 12, 950);
    EXPECT_EQ(set.count(), 1);
    EXPECT_TRUE(set.contains(14 * 15));
    for (const double bad : {std::nan(""), -std::numeric_limits<double>::infinity()}) {
        set = TileSet(grid);
        set.insertBox(5, 5, bad, 6);
        set.insertBox(5, 1000, 6, 1001);
        EXPECT_TRUE(set.empty());
    }
    set.insertBox(0, 0, 1e9, 1);
    EXPECT_EQ(set.count(), 15);
}

TEST(TileSet, GrowsAcrossTheSeam) {
    const TileGrid grid(kGridPhoto);
    TileSet set(grid);
    set.insert(15 * 3);
    const TileSet grown = set.grown();
    EXPECT_EQ(grown.count(), 9);
    EXPECT_TRUE(grown.contains(15 * 2 + 14));
}

TEST(TileBlocks, CoverTheSetWithoutOverlap) {
    test::Random random(12);
    const TileGrid grid(kGridPhoto);
    for (int round = 0; round < 300; ++round) {
        TileSet set(grid);
        for (int i = random.integer(0, 4); i >= 0; --i) {
            const double x = random.uniform(-900, 1800);
            const double y = random.uniform(0, 900);
            set.insertBox(x, y, x + random.uniform(0, 700), y + random.uniform(0, 400));
        }
        const int maxRows = random.integer(1, 20);
        std::vector<int> covered(static_cast<std::size_t>(grid.count()));
        int total = 0;
        for (const TileBlock& block : blocksOf(set, maxRows)) {
            EXPECT_LE(block.endRow - block.row, maxRows);
            for (int row = block.row; row < block.endRow; ++row) {
                for (int column = block.column; column < block.endColumn; ++column) {
                    const int tile = row * grid.columns() + column;
                    total += 1;
                    covered[static_cast<std::size_t>(tile)] += set.contains(tile) ? 1 : 0;
                }
            }
        }
        set.forEach(
            [&](int tile) { EXPECT_EQ(covered[static_cast<std::size_t>(tile)], 1) << random.seed(); });
        EXPECT_LE(total, 2 * set.count());
    }
}

} // namespace
} // namespace spherewalk::render
