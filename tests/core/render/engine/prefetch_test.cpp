// SPDX-License-Identifier: Apache-2.0
#include "engine/tile_supply.h"
#include "made_tiles.h"
#include "random.h"
#include "sphere/exact_view.h"
#include "tiles/tile_grid.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <future>

namespace spherewalk::render {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Missing = TileStore::Missing;

const EquirectSize kPhoto{2048, 1024};

/// A corridor with a photo every 20 cm along x, as one camera sees it.
class Corridor {
  public:
    static constexpr double kStepM = 0.2;

    static std::size_t photoAt(const Vector3d& p) {
        return static_cast<std::size_t>(std::max(0.0, std::round(p.x() / kStepM)));
    }

    TileNeed need(const Rigid3& pose) const {
        const std::size_t photo = photoAt(pose.translation);
        return {{photo}, tiles(pose, photo)};
    }

    TileSet tiles(const Rigid3& pose, std::size_t photo) const {
        const Rigid3 roomFromPhoto{Eigen::Quaterniond::Identity(),
                                   Vector3d(kStepM * static_cast<double>(photo), 0, 0)};
        const Projection projection(m_camera, pose, roomFromPhoto, kPhoto, SceneKind::Sphere, 2);
        return m_footprint.tiles(grid, [&](const Vector2d& p) { return projection.photoDirection(p); });
    }

    TileGrid grid{kPhoto};

  private:
    CameraModel m_camera{CameraIntrinsics::pinhole(64, 48, 1)};
    ViewFootprint m_footprint{m_camera};
};

Rigid3 ahead(double x, double yaw = 0) {
    return {yawRotation(Radians(yaw)) * bodyFromOptical(), Vector3d(x, 0, 0)};
}

Prefetcher::MakePlan always(std::vector<TileNeed> plan) {
    return [plan = std::move(plan)](const std::stop_token&) { return plan; };
}

TEST(CameraMotion, PredictsTheMotionItWasTakenFrom) {
    test::Random random(6);
    for (int round = 0; round < 200; ++round) {
        const Rigid3 from{random.rotation(), random.vector(1e6)};
        CameraMotion motion{random.vector(3), random.vector(0.8)};
        const double seconds = random.uniform(0.01, 0.3);
        const CameraMotion seen = motionBetween(from, predicted(from, motion, seconds), seconds);
        EXPECT_LT((seen.velocity - motion.velocity).norm(), 1e-6);
        EXPECT_LT((seen.turnRate - motion.turnRate).norm(), 1e-6) << random.seed();
    }
}

TEST(CameraMotion, OfAJumpOrNoTimeIsNone) {
    for (const double seconds : {0.0, -1.0, std::nan("")}) {
        EXPECT_EQ(motionBetween(ahead(0), ahead(1, 1), seconds).velocity, Vector3d::Zero());
    }
    EXPECT_EQ(motionBetween(ahead(0), ahead(1e6, 1), 0.03).turnRate, Vector3d::Zero());
    EXPECT_EQ(motionBetween(ahead(1), ahead(1), 0.03).turnRate, Vector3d::Zero());
}

TEST(PrefetchPlan, NamesThePhotosOnThePathSoonestFirstAndOnce) {
    const Corridor corridor;
    const auto need = [&](const Rigid3& pose) { return corridor.need(pose); };
    const auto plan = prefetchPlan(ahead(1), {{2, 0, 0}, {0, 0, 0}}, {0.5, 0.02, 4000}, {}, need);
    ASSERT_EQ(plan.size(), 6U);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        EXPECT_EQ(plan[i].level.photo, 5 + i);
        EXPECT_FALSE(plan[i].tiles.empty());
    }
    const auto again = prefetchPlan(ahead(1), {{2, 0, 0}, {0, 0, 0}}, {0.5, 0.02, 4000}, {}, need);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        EXPECT_EQ(plan[i].tiles, again[i].tiles);
    }
}

TEST(PrefetchPlan, LooksWhereTheCameraTurns) {
    const Corridor corridor;
    const auto need = [&](const Rigid3& pose) { return corridor.need(pose); };
    const auto plan = prefetchPlan(ahead(1), {{0, 0, 0}, {0, 0, 3}}, {0.5, 0.02, 4000}, {}, need);
    ASSERT_EQ(plan.size(), 1U);
    corridor.tiles(ahead(1, 1.5), 5).forEach([&](int tile) { EXPECT_TRUE(plan[0].tiles.contains(tile)); });
    EXPECT_LT(plan[0].tiles.count(), corridor.grid.count() / 2);
}

TEST(PrefetchPlan, EndsBeforeItHasTooManyTiles) {
    const Corridor corridor;
    const auto need = [&](const Rigid3& pose) { return corridor.need(pose); };
    int tiles = 0;
    const auto plan = prefetchPlan(ahead(1), {{50, 0, 0}, {0, 0, 0}}, {10, 0.02, 100}, {}, need);
    for (const TileNeed& one : plan) {
        tiles += one.tiles.count();
    }
    EXPECT_GT(tiles, 50);
    EXPECT_LE(tiles, 100);
    EXPECT_TRUE(prefetchPlan(ahead(1), {}, {0.5, 0, 100}, {}, need).empty());
}

// A clock moved by hand: 30 views a second; between two views the plan is done, as far as the time of the
// interval allows by a stated time for each tile.
class WalkByHand : public testing::TestWithParam<double> {};

TEST_P(WalkByHand, HasNoLateViewButTheFirst) {
    const Corridor corridor;
    auto source = std::make_shared<test::MadeTiles>(kPhoto);
    TileStore store(source, 64 << 20);
    constexpr double kFrame = 1.0 / 30;
    constexpr double kSecondsPerTile = 0.0003;
    double now = 0;
    Rigid3 before = ahead(0);
    for (int frame = 0; frame < 60; ++frame, now += kFrame) {
        const Rigid3 pose = ahead(GetParam() * now, 0.5 * now);
        const TileNeed need = corridor.need(pose);
        store.acquire(need.level, need.tiles, Missing::Decode, 1);
        const CameraMotion motion = motionBetween(before, pose, kFrame);
        before = pose;
        double left = kFrame;
        for (const TileNeed& next : prefetchPlan(pose, motion, {0.2, kFrame, 4000}, {},
                                                 [&](const Rigid3& p) { return corridor.need(p); })) {
            if (left <= 0) {
                break;
            }
            const auto done = store.counters().prefetchedTiles;
            store.prefetch(next.level, next.tiles, {});
            left -= kSecondsPerTile * static_cast<double>(store.counters().prefetchedTiles - done);
        }
    }
    // The motion is known from the second view on.
    EXPECT_LE(store.counters().late, 2U);
    EXPECT_GE(store.counters().hits, 58U);
}

INSTANTIATE_TEST_SUITE_P(Speeds, WalkByHand, testing::Values(1.0, 3.0, 10.0, 20.0));

TEST(Prefetcher, DecodesItsPlanInOrder) {
    const Corridor corridor;
    auto source = std::make_shared<test::MadeTiles>(kPhoto);
    std::mutex mutex;
    std::vector<std::size_t> order;
    source->onDecode = [&](std::size_t photo) {
        const std::scoped_lock lock(mutex);
        if (order.empty() || order.back() != photo) {
            order.push_back(photo);
        }
    };
    TileStore store(source, 256 << 20);
    Prefetcher prefetcher(store);
    const TileSet tiles = corridor.tiles(ahead(1), 5);
    prefetcher.setPlan(always({{{4}, tiles}, {{9}, tiles}, {{2}, tiles}}));
    prefetcher.waitUntilIdle();
    EXPECT_EQ(order, (std::vector<std::size_t>{4, 9, 2}));
    EXPECT_EQ(store.acquire({9}, tiles, Missing::Decode).waitedMs(), 0);
}

TEST(Prefetcher, LeavesAnOldPlanAfterOneBlock) {
    const Corridor corridor;
    auto source = std::make_shared<test::MadeTiles>(kPhoto);
    std::promise<void> begun; // GCC 10 has no latch
    std::promise<void> replaced;
    std::once_flag once;
    source->onDecode = [&](std::size_t) {
        std::call_once(once, [&] {
            begun.set_value();
            replaced.get_future().wait();
        });
    };
    TileStore store(source, 256 << 20);
    Prefetcher prefetcher(store);
    const TileSet all = TileSet::all(corridor.grid);
    prefetcher.setPlan(always({{{1}, all}, {{2}, all}}));
    begun.get_future().wait();
    prefetcher.setPlan(always({{{3}, corridor.tiles(ahead(1), 5)}}));
    replaced.set_value();
    prefetcher.waitUntilIdle();
    EXPECT_FALSE(store.acquire({2}, all, Missing::LeaveOut).isComplete());
    EXPECT_EQ(store.acquire({2}, all, Missing::LeaveOut).missing().count(), corridor.grid.count());
    EXPECT_LT(store.acquire({1}, all, Missing::LeaveOut).missing().count(), corridor.grid.count());
    EXPECT_TRUE(store.acquire({3}, corridor.tiles(ahead(1), 5), Missing::LeaveOut).isComplete());
}

TEST(Prefetcher, DoesWhatIsToDoWhenIdle) {
    auto source = std::make_shared<test::MadeTiles>(kPhoto);
    TileStore store(source, 256 << 20);
    int left = 3;
    Prefetcher prefetcher(store, [&](const std::stop_token&) { return --left > 0; });
    prefetcher.setPlan(always({}));
    prefetcher.waitUntilIdle();
    EXPECT_EQ(left, 0);
}

TEST(Prefetcher, EndsWhileItsPlanIsLong) {
    const Corridor corridor;
    auto source = std::make_shared<test::MadeTiles>(kPhoto);
    TileStore store(source, 16 << 20);
    {
        Prefetcher prefetcher(store);
        std::vector<TileNeed> plan;
        for (std::size_t photo = 0; photo < 10000; ++photo) {
            plan.push_back({{photo}, TileSet::all(corridor.grid)});
        }
        prefetcher.setPlan(always(plan));
    }
    EXPECT_LT(store.counters().prefetchedTiles, 10000U * 16U);
}

} // namespace
} // namespace spherewalk::render
