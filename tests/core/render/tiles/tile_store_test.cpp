// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "made_tiles.h"
#include "random.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace spherewalk::render {
namespace {

using test::hasPixels;
using test::MadeTiles;
using Missing = TileStore::Missing;

const EquirectSize kStorePhoto{1000, 500}; // 8 x 8 tiles

TileSet randomTiles(const TileGrid& grid, test::Random& random) {
    TileSet set(grid);
    const double x = random.uniform(0, grid.photo().width);
    const double y = random.uniform(0, grid.photo().height);
    set.insertBox(x, y, x + random.uniform(1, 400), y + random.uniform(1, 200));
    return set;
}

TileSet oneTile(const TileGrid& grid, int tile) {
    TileSet set(grid);
    set.insert(tile);
    return set;
}

class Tiles : public testing::Test {
  protected:
    std::shared_ptr<MadeTiles> source = std::make_shared<MadeTiles>(kStorePhoto);
    TileGrid grid{kStorePhoto};
};

TEST_F(Tiles, AreTheSourcesPixelsHoweverOftenTheyLeft) {
    test::Random random(5);
    TileStore store(source, 3'000'000);
    for (int round = 0; round < 400; ++round) {
        const auto photo = static_cast<std::size_t>(random.integer(0, 3));
        const TileSet tiles = randomTiles(grid, random);
        const TileLease lease = store.acquire({photo}, tiles, Missing::Decode, 1 + round % 3);
        ASSERT_TRUE(lease.isComplete());
        ASSERT_TRUE(hasPixels(lease.plane(), photo, tiles)) << round << " seed " << random.seed();
    }
    const LoadCounters counters = store.counters();
    EXPECT_EQ(counters.hits + counters.late, 400U);
    EXPECT_EQ(counters.waits, counters.late);
    EXPECT_GT(counters.hits, 0U);
    EXPECT_GT(counters.droppedTiles, 0U);
    EXPECT_LE(counters.residentBytes, 3'000'000U);
}

TEST_F(Tiles, AreDecodedOnceWhileTheyStay) {
    TileStore store(source, 100'000'000);
    const TileSet all = TileSet::all(grid);
    store.acquire({7}, all, Missing::Decode, 1);
    const auto pixels = source->pixels.load();
    EXPECT_EQ(pixels, 1000 * 500);
    EXPECT_EQ(store.acquire({7}, all, Missing::Decode).waitedMs(), 0);
    EXPECT_EQ(source->pixels, pixels);
    EXPECT_EQ(store.counters().hits, 1U);
}

TEST_F(Tiles, LeastRecentlyUsedLeaveFirst) {
    TileStore store(source, 55 * 4096 * 52 / 10); // a tile of this photo takes 52 pages
    const auto use = [&](std::size_t photo) {
        return store.acquire({photo}, oneTile(grid, 9), Missing::Decode).waitedMs() > 0;
    };
    std::size_t fit = 0;
    while (store.counters().droppedTiles == 0) {
        EXPECT_TRUE(use(fit++));
        ASSERT_LT(fit, 1000U);
    }
    const std::size_t last = fit - 1; // which made the first leave
    EXPECT_FALSE(use(last));
    EXPECT_FALSE(use(1));
    EXPECT_TRUE(use(0));
    EXPECT_FALSE(use(last));
    EXPECT_FALSE(use(1)); // used before 0 came back
}

TEST_F(Tiles, InUseStayBeyondTheBudget) {
    TileStore store(source, 0);
    const TileSet tiles = oneTile(grid, 20);
    const TileLease first = store.acquire({1}, tiles, Missing::Decode);
    const TileLease second = store.acquire({2}, tiles, Missing::Decode);
    EXPECT_TRUE(hasPixels(first.plane(), 1, tiles));
    EXPECT_TRUE(hasPixels(second.plane(), 2, tiles));
    EXPECT_GT(store.counters().residentBytes, 0U);
    EXPECT_EQ(store.counters().droppedTiles, 0U);
}

TEST_F(Tiles, LeaveNothingBehindWhenAllHaveLeft) {
    TileStore store(source, 0);
    {
        TileLease lease = store.acquire({1}, TileSet::all(grid), Missing::Decode);
        EXPECT_GE(store.counters().residentBytes, 1'500'000U);
        lease = store.acquire({2}, oneTile(grid, 0), Missing::Decode);
    }
    EXPECT_EQ(store.counters().residentBytes, 0U);
}

TEST_F(Tiles, LeftOutAreNamed) {
    TileStore store(source, 100'000'000);
    store.acquire({1}, oneTile(grid, 5), Missing::Decode);
    TileSet two = oneTile(grid, 5);
    two.insert(6);
    const TileLease lease = store.acquire({1}, two, Missing::LeaveOut);
    EXPECT_FALSE(lease.isComplete());
    EXPECT_EQ(lease.missing(), oneTile(grid, 6));
    EXPECT_TRUE(hasPixels(lease.plane(), 1, oneTile(grid, 5)));
    EXPECT_EQ(store.counters().late, 2U);
    EXPECT_EQ(store.counters().waits, 1U);
}

TEST_F(Tiles, OfAPhotoWithoutPartsComeAllAtOnce) {
    source->decodesInParts = false;
    TileStore store(source, 100'000'000);
    const TileLease lease = store.acquire({1}, oneTile(grid, 3), Missing::Decode);
    EXPECT_EQ(source->decodes, 1);
    EXPECT_EQ(store.acquire({1}, TileSet::all(grid), Missing::Decode).waitedMs(), 0);
    EXPECT_TRUE(hasPixels(lease.plane(), 1, TileSet::all(grid)));
}

TEST_F(Tiles, AnErrorIsToldEveryTimeAndLeavesTheRestUsable) {
    TileStore store(source, 100'000'000);
    const TileLease good = store.acquire({1}, oneTile(grid, 3), Missing::Decode);
    source->onDecode = [](std::size_t) { throw Error(ErrorKind::Corrupt, "torn"); };
    for (int round = 0; round < 2; ++round) {
        test::expectError(ErrorKind::Corrupt, "torn",
                          [&] { store.acquire({1}, TileSet::all(grid), Missing::Decode); });
        test::expectError(ErrorKind::Corrupt, "torn",
                          [&] { store.acquire({2}, TileSet::all(grid), Missing::Decode); });
    }
    store.prefetch({2}, TileSet::all(grid), {});
    EXPECT_EQ(store.counters().prefetchErrors, 1U);
    source->onDecode = {};
    EXPECT_TRUE(hasPixels(good.plane(), 1, oneTile(grid, 3)));
    EXPECT_TRUE(store.acquire({2}, TileSet::all(grid), Missing::Decode).isComplete());
}

TEST_F(Tiles, PrefetchedAreHits) {
    TileStore store(source, 100'000'000);
    test::Random random(4);
    const TileSet tiles = randomTiles(grid, random);
    store.prefetch({3}, tiles, {});
    EXPECT_EQ(store.acquire({3}, tiles, Missing::Decode).waitedMs(), 0);
    EXPECT_EQ(store.counters().hits, 1U);
    EXPECT_EQ(store.counters().prefetchedTiles, static_cast<std::uint64_t>(tiles.count()));
}

TEST_F(Tiles, AreNotPrefetchedWhileAViewIsMade) {
    TileStore store(source, 100'000'000);
    std::stop_source stop;
    std::jthread background;
    {
        const TileStore::ViewInProgress view(store);
        background = std::jthread([&] { store.prefetch({1}, TileSet::all(grid), {}); });
        // The view's own decoding goes on, and nothing but it.
        EXPECT_TRUE(store.acquire({2}, TileSet::all(grid), Missing::Decode, 1).isComplete());
        EXPECT_EQ(store.counters().prefetchedTiles, 0U);
        store.prefetch({3}, TileSet::all(grid), [&] {
            stop.request_stop();
            return stop.get_token();
        }());
        EXPECT_EQ(store.counters().prefetchedTiles, 0U);
    }
    background.join();
    EXPECT_EQ(store.counters().prefetchedTiles, 64U);
}

TEST_F(Tiles, ArePrefetchedEvenWithNextToNoBudget) {
    TileStore store(source, 1);
    store.prefetch({0}, TileSet::all(grid), {});
    EXPECT_EQ(store.counters().prefetchedTiles, static_cast<std::uint64_t>(grid.count()));
    EXPECT_EQ(store.counters().residentBytes, 0U);
}

TEST_F(Tiles, WantedByManyThreadsAreRightInAllOfThem) {
    TileStore store(source, 700'000);
    std::vector<std::jthread> threads;
    std::atomic<int> wrong{0};
    for (unsigned i = 0; i < 4; ++i) {
        threads.emplace_back([&, i] {
            test::Random random(100 + i);
            for (int round = 0; round < 60; ++round) {
                const auto photo = static_cast<std::size_t>(random.integer(0, 2));
                const TileSet tiles = randomTiles(grid, random);
                if (i == 0) {
                    store.prefetch({photo}, tiles, {});
                    continue;
                }
                const auto missing = round % 4 == 0 ? Missing::LeaveOut : Missing::Decode;
                const TileLease lease = store.acquire({photo}, tiles, missing, 1 + round % 2);
                if (lease.isComplete() && !hasPixels(lease.plane(), photo, tiles)) {
                    ++wrong;
                }
            }
        });
    }
    threads.clear();
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(store.counters().residentBytes, 700'000U);
}

} // namespace
} // namespace spherewalk::render
