// SPDX-License-Identifier: Apache-2.0
#include "pixels/photo_plane.h"
#include "random.h"
#include "tiles/tile_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace spherewalk::render {

namespace {

EquirectSize anyPanorama(test::Random& random) {
    const int height = random.integer(8, 700);
    return {2 * height, height};
}

int tileOf(const TileGrid& grid, int x, int y) {
    const int width = grid.photo().width;
    const int inPhoto = (x % width + width) % width;
    return y / TileGrid::kTileHeight * grid.columns() + inPhoto / TileGrid::kTileWidth;
}

TileSet anyTiles(const TileGrid& grid, test::Random& random) {
    TileSet set(grid);
    for (int i = random.integer(0, 6); i > 0; --i) {
        set.insert(random.integer(0, grid.count() - 1));
    }
    return set;
}

bool holds(const TileSet& all, const TileSet& part) {
    bool isHeld = true;
    part.forEach([&](int tile) { isHeld = isHeld && all.contains(tile); });
    return isHeld;
}

} // namespace

TEST(TileGrid, CoversEachPixelOnce) {
    test::Random random(901);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 40; ++round) {
        const TileGrid grid(anyPanorama(random));
        const auto [width, height] = grid.photo();
        std::vector<int> covered(static_cast<std::size_t>(width * height));
        for (int tile = 0; tile < grid.count(); ++tile) {
            const jpeg::PixelRect pixels = grid.pixels(tile);
            ASSERT_LE(pixels.x + pixels.width, width);
            ASSERT_LE(pixels.y + pixels.height, height);
            for (int y = pixels.y; y < pixels.y + pixels.height; ++y) {
                for (int x = pixels.x; x < pixels.x + pixels.width; ++x) {
                    ++covered[static_cast<std::size_t>(y * width + x)];
                    ASSERT_EQ(tileOf(grid, x, y), tile);
                }
            }
        }
        EXPECT_TRUE(std::ranges::all_of(covered, [](int count) { return count == 1; })) << width;
    }
}

TEST(TileGrid, PixelsOfABlockAreThoseOfItsTiles) {
    test::Random random(902);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 100; ++round) {
        const TileGrid grid(anyPanorama(random));
        const int column = random.integer(0, grid.columns() - 1);
        const int row = random.integer(0, grid.rows() - 1);
        const int endColumn = random.integer(column + 1, grid.columns());
        const int endRow = random.integer(row + 1, grid.rows());
        std::int64_t area = 0;
        for (int tile = 0; tile < grid.count(); ++tile) {
            const int ofColumn = tile % grid.columns();
            const int ofRow = tile / grid.columns();
            const jpeg::PixelRect pixels = grid.pixels(tile);
            const bool isWithin =
                ofColumn >= column && ofColumn < endColumn && ofRow >= row && ofRow < endRow;
            area += isWithin ? std::int64_t{pixels.width} * pixels.height : 0;
        }
        const jpeg::PixelRect block = grid.pixels(column, row, endColumn, endRow);
        EXPECT_EQ(std::int64_t{block.width} * block.height, area);
    }
}

TEST(TileSet, ABoxHoldsTheTilesOfAllItsPixels) {
    test::Random random(903);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 300; ++round) {
        const TileGrid grid(anyPanorama(random));
        const auto [width, height] = grid.photo();
        const double left = random.uniform(-1.5 * width, 1.5 * width);
        const double top = random.uniform(-20, height);
        const double right = left + random.uniform(0, 0.8 * width);
        const double bottom = std::max(top, 0.0) + random.uniform(0, 0.5 * height);
        TileSet set(grid);
        set.insertBox(left, top, right, bottom);
        for (int y = std::max(0, static_cast<int>(std::ceil(top))); y <= bottom && y < height; ++y) {
            for (int x = static_cast<int>(std::ceil(left)); x <= right; ++x) {
                ASSERT_TRUE(set.contains(tileOf(grid, x, y))) << x << ", " << y << " of " << width;
            }
        }
    }
}

TEST(TileSet, ABoxIsTheSameAWholeTurnFarther) {
    test::Random random(904);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 300; ++round) {
        const TileGrid grid(anyPanorama(random));
        const auto [width, height] = grid.photo();
        const double left = random.integer(-4 * width, 4 * width) / 4.0; // exact in double precision
        const double across = random.integer(0, 4 * width) / 4.0;
        TileSet set(grid);
        TileSet turned(grid);
        set.insertBox(left, 3, left + across, height / 2.0);
        turned.insertBox(left + width, 3, left + width + across, height / 2.0);
        EXPECT_EQ(set, turned) << left << " + " << across << " of " << width;
    }
}

TEST(TileSet, ACapHoldsEveryDirectionWithinIt) {
    test::Random random(905);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 200; ++round) {
        const TileGrid grid(anyPanorama(random));
        Eigen::Vector3d middle = random.direction();
        if (round % 4 == 0) { // beside a pole
            middle = (Eigen::Vector3d(0, 0, round % 8 == 0 ? 1 : -1) + random.vector(0.05)).normalized();
        }
        const double radius = random.uniform(0.001, 1);
        TileSet set(grid);
        set.insertCap(middle, Radians(radius));
        for (int i = 0; i < 200; ++i) {
            const Eigen::Vector3d axis = middle.cross(random.direction()).normalized();
            const double away = radius * (i % 2 == 0 ? 0.9999 : random.uniform(0, 1));
            const Eigen::Vector3d inside = Eigen::AngleAxisd(away, axis) * middle;
            const Eigen::Vector2d at = pixel(grid.photo(), inside);
            const int x = static_cast<int>(std::lround(at.x()));
            const int y = std::clamp(static_cast<int>(std::lround(at.y())), 0, grid.photo().height - 1);
            ASSERT_TRUE(set.contains(tileOf(grid, x, y)))
                << "round " << round << " pixel " << at.transpose() << " of " << grid.photo().width;
        }
    }
}

TEST(TileSet, ACapAboutAPoleGoesAllRoundIt) {
    const TileGrid grid(EquirectSize{2048, 1024});
    for (const double sign : {1.0, -1.0}) {
        TileSet set(grid);
        set.insertCap({0, 0, sign}, Degrees(2));
        for (int x = 0; x < 2048; ++x) {
            EXPECT_TRUE(set.contains(tileOf(grid, x, sign > 0 ? 0 : 1023))) << x;
        }
        EXPECT_EQ(set.count(), grid.columns());
    }
}

TEST(TileSet, MergesAndGrowsAsSetsDo) {
    test::Random random(906);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 100; ++round) {
        const TileGrid grid(anyPanorama(random));
        const TileSet one = anyTiles(grid, random);
        const TileSet other = anyTiles(grid, random);
        TileSet both = one;
        both.merge(other);
        EXPECT_TRUE(holds(both, one) && holds(both, other));
        EXPECT_LE(both.count(), one.count() + other.count());
        TileSet grownBoth = one.grown();
        grownBoth.merge(other.grown());
        EXPECT_EQ(both.grown(), grownBoth);
        EXPECT_TRUE(holds(one.grown(), one));
        EXPECT_EQ(TileSet::all(grid).grown(), TileSet::all(grid));
    }
}

TEST(TileSet, IsEmptyUntilATileIsPutInAndAfterItWasTakenOut) {
    const TileGrid grid(EquirectSize{512, 256});
    TileSet set(grid);
    EXPECT_TRUE(set.empty());
    EXPECT_TRUE(blocksOf(set, 4).empty());
    set.insert(5);
    set.insert(5);
    EXPECT_EQ(set.count(), 1);
    set.erase(5);
    EXPECT_TRUE(set.empty());
}

TEST(PlaneLayout, HoldsEveryPixelAndItsGuardWithinItsBytes) {
    constexpr int kGuard = PlaneLayout::kGuard;
    for (const int width : {16, 126, 128, 130, 5376, 16384}) {
        const PlaneLayout layout(EquirectSize{width, width / 2});
        EXPECT_EQ(layout.offset(-kGuard, -kGuard), 0U);
        const std::size_t last = layout.offset(width + kGuard - 1, width / 2 + kGuard - 1);
        EXPECT_LE(last + PlaneLayout::kPixelBytes + PlaneLayout::kSlackBytes, layout.bytes()) << width;
        EXPECT_GE(layout.stride(), width + 2 * kGuard);
        EXPECT_EQ(layout.stride() / 64 % 2, 1) << "rows fall on the same sets of the cache";
    }
}

TEST(SparsePlane, GivesBackWhatItTookInAnyOrder) {
    test::Random random(907);
    SCOPED_TRACE(random.seed());
    const TileGrid grid(EquirectSize{1800, 900});
    SparsePlane plane(grid.photo());
    EXPECT_EQ(plane.residentBytes(), 0U);
    std::vector<jpeg::PixelRect> held;
    for (int round = 0; round < 300; ++round) {
        const std::uint64_t before = plane.residentBytes();
        if (held.empty() || random.uniform(0, 1) < 0.6) {
            held.push_back(grid.pixels(random.integer(0, grid.count() - 1)));
            plane.occupy(held.back());
            EXPECT_GE(plane.residentBytes(), before);
        } else {
            std::swap(held[static_cast<std::size_t>(random.integer(0, static_cast<int>(held.size()) - 1))],
                      held.back());
            plane.vacate({&held.back(), 1});
            held.pop_back();
            EXPECT_LE(plane.residentBytes(), before);
        }
    }
    plane.vacate(held);
    EXPECT_EQ(plane.residentBytes(), 0U);
}

TEST(SparsePlane, KeepsPixelsWhileAnotherRectangleHoldsTheirMemory) {
    const EquirectSize size{512, 256};
    SparsePlane plane(size);
    const jpeg::PixelRect left{0, 0, 128, 64};
    const jpeg::PixelRect right{384, 0, 128, 64};
    plane.occupy(left);
    plane.occupy(right);
    const std::vector<std::uint8_t> rgb = {10, 20, 30};
    plane.write(0, 0, rgb);
    plane.vacate({&right, 1});
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(plane.view().stored(0, 0, c) + 128, rgb[static_cast<std::size_t>(c)]);
        EXPECT_EQ(plane.view().stored(512, 0, c) + 128, rgb[static_cast<std::size_t>(c)]) << "the seam";
        EXPECT_EQ(plane.view().stored(256, -1, c) + 128, rgb[static_cast<std::size_t>(c)]) << "the pole";
    }
}

} // namespace spherewalk::render
