// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_schedule.h"
#include "random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::simulator {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

class Schedule : public testing::Test {
  protected:
    void want(double rateHz, Pace pace, std::optional<Stamp> overlayWait = {}) {
        options.rateHz = rateHz;
        options.pace = pace;
        if (overlayWait) {
            options.overlay.emplace();
            options.overlay->by = ObjectsBy::Alone;
            options.overlay->wait = *overlayWait;
        }
    }

    /// The pose's place says its time.
    void pose(Stamp stamp) {
        const auto seconds = std::chrono::duration<double>(stamp).count();
        schedule.addPose(stamp, {Rigid3{Eigen::Quaterniond::Identity(), Eigen::Vector3d(seconds, 0, 0)}}, {});
    }

    void overlay(Stamp stamp) {
        if (OverlayParts* parts = schedule.partsOf(stamp)) {
            parts->colour = RgbImage(1, 1);
            parts->depth = DepthImage(1, 1);
        }
    }

    /// The stamps of all frames that can be rendered now, in milliseconds.
    std::vector<std::int64_t> frames() {
        std::vector<std::int64_t> result;
        while (const auto frame = schedule.next()) {
            EXPECT_EQ(frame->roomFromCameras.front().translation.x(),
                      std::chrono::duration<double>(frame->stamp).count());
            withOverlay.push_back(!frame->overlays.empty());
            result.push_back(frame->stamp / 1ms);
        }
        return result;
    }

    CameraOptions options;
    FrameSchedule schedule{options};
    std::vector<bool> withOverlay;
};

TEST_F(Schedule, AFrameIsDueAtTheFirstPoseAtOrAfterEachMultiple) {
    want(30, Pace::Every);
    for (int ms = 0; ms <= 140; ++ms) {
        pose(ms * 1ms);
    }
    EXPECT_THAT(frames(), ElementsAre(0, 34, 67, 100, 134));
    EXPECT_EQ(schedule.counters().dropped, 0U);
}

TEST_F(Schedule, StampsThatWereRoundedDownAreDue) {
    want(30, Pace::Every);
    for (std::int64_t k = 0; k < 100'000; k += 999) { // an hour
        schedule.addPose(Stamp(k * 1'000'000'000 / 30), {Rigid3()}, {});
        EXPECT_TRUE(schedule.next()) << k;
    }
}

TEST_F(Schedule, GivesTheRateWhateverTheStepsOfTheSimulationAre) {
    test::Random random(7);
    for (int round = 0; round < 50; ++round) {
        want(random.uniform(1, 120), Pace::Every);
        FrameSchedule own(options);
        const double stepS = random.uniform(0.1, 1) / options.rateHz;
        int count = 0;
        for (double time = 0; time < 20; time += stepS) {
            own.addPose(Stamp(std::llround(1e9 * time)), {Rigid3()}, {});
            count += own.next() ? 1 : 0;
        }
        EXPECT_NEAR(count, 20 * options.rateHz, 1.5) << options.rateHz << " " << stepS;
    }
}

TEST_F(Schedule, SaysBeforeAPoseWhetherItIsThatOfAFrame) {
    want(30, Pace::Every);
    EXPECT_TRUE(schedule.isDue(0ms));
    const auto takes = [&](Stamp stamp) {
        const bool isDue = schedule.isDue(stamp);
        pose(stamp);
        EXPECT_FALSE(schedule.isDue(stamp)) << "the same pose once more";
        EXPECT_EQ(!frames().empty(), isDue) << stamp / 1ms;
        return isDue;
    };
    int due = 0;
    for (int ms = 0; ms <= 1000; ++ms) {
        due += takes(ms * 1ms) ? 1 : 0;
    }
    EXPECT_EQ(due, 31);
    EXPECT_TRUE(takes(0ms)) << "time went back";
    EXPECT_FALSE(takes(1ms));
}

TEST_F(Schedule, WithoutARateEachPoseIsAFrameAndTheSameStampIsOnlyOne) {
    want(0, Pace::Every);
    for (const Stamp stamp : {0ms, 1ms, 1ms, 7ms}) {
        pose(stamp);
    }
    EXPECT_THAT(frames(), ElementsAre(0, 1, 7));
}

TEST_F(Schedule, ASlowMachineTakesTheNewestAndCountsWhatItDrops) {
    want(10, Pace::Newest);
    pose(0ms);
    EXPECT_THAT(frames(), ElementsAre(0));
    for (const Stamp stamp : {100ms, 150ms, 200ms, 310ms}) {
        pose(stamp);
    }
    EXPECT_THAT(frames(), ElementsAre(310));
    EXPECT_EQ(schedule.counters().dropped, 2U);
}

TEST_F(Schedule, TimeThatGoesBackIsANewStart) {
    want(10, Pace::Every);
    pose(5000ms);
    pose(5100ms);
    pose(20ms);
    pose(90ms);
    pose(100ms);
    EXPECT_THAT(frames(), ElementsAre(20, 100));
    EXPECT_EQ(schedule.counters().restarts, 1U);
}

TEST_F(Schedule, AnOverlayIsTakenWhetherItComesBeforeOrAfterItsPose) {
    want(10, Pace::Newest, 200ms);
    overlay(0ms);
    EXPECT_THAT(frames(), IsEmpty());
    pose(0ms);
    EXPECT_THAT(frames(), ElementsAre(0));
    pose(100ms);
    EXPECT_THAT(frames(), IsEmpty());
    overlay(100ms);
    EXPECT_THAT(frames(), ElementsAre(100));
    EXPECT_THAT(withOverlay, ElementsAre(true, true));
}

TEST_F(Schedule, AFrameIsWholeOrNotAtAll) {
    want(10, Pace::Newest, 200ms);
    pose(0ms);
    schedule.partsOf(0ms)->colour = RgbImage(1, 1);
    EXPECT_THAT(frames(), IsEmpty());
}

TEST_F(Schedule, WithoutItsOverlayAFrameIsRenderedOnceTheWaitIsOver) {
    want(10, Pace::Newest, 200ms);
    for (const Stamp stamp : {0ms, 50ms, 199ms}) {
        pose(stamp);
        EXPECT_THAT(frames(), IsEmpty());
    }
    pose(200ms);
    EXPECT_THAT(frames(), ElementsAre(0));
    EXPECT_THAT(withOverlay, ElementsAre(false));
}

TEST_F(Schedule, AFrameMovesToThePoseInItsSlotThatHasAnOverlay) {
    want(10, Pace::Newest, 200ms);
    for (int ms = 0; ms < 100; ms += 10) {
        pose(ms * 1ms);
    }
    overlay(55ms); // of no pose
    overlay(70ms);
    EXPECT_THAT(frames(), ElementsAre(70));
    EXPECT_THAT(withOverlay, ElementsAre(true));
    overlay(80ms);
    EXPECT_THAT(frames(), IsEmpty()); // the slot has had its frame
}

TEST_F(Schedule, AnOverlayBetweenTwoPosesIsOfThePoseBetweenThemWhereThatIsWanted) {
    want(30, Pace::Every, 500ms);
    options.overlay->interpolatesPoses = true;
    pose(34ms);
    pose(50ms);
    overlay(40ms);
    overlay(55ms); // beyond the newest pose, and later in the same slot
    const auto frame = schedule.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->stamp, 40ms);
    EXPECT_NEAR(frame->roomFromCameras.front().translation.x(), 0.040, 1e-12);
    EXPECT_FALSE(frame->overlays.empty());
    EXPECT_FALSE(schedule.next());
}

TEST_F(Schedule, OverlaysThatFitNothingAreCountedAndForgotten) {
    want(10, Pace::Newest, 200ms);
    pose(0ms);
    for (int ms = 1; ms <= 1000; ++ms) {
        overlay(ms * 1ms);
    }
    overlay(Stamp::max());
    EXPECT_GT(schedule.counters().overlaysUnused, 900U);
    pose(5000ms);
    EXPECT_THAT(frames(), ElementsAre(0));
    pose(5300ms);
    overlay(5300ms);
    EXPECT_THAT(frames(), ElementsAre(5300));
    EXPECT_THAT(withOverlay, ElementsAre(false, true));
}

TEST_F(Schedule, AMissingOverlayCostsOneFrameItsOverlayAndTheNextOnesNothing) {
    for (const Stamp wait : {0ms, 100ms, 500ms, 1000ms, 10'000ms}) {
        want(0, Pace::Every, wait);
        FrameSchedule own(options);
        std::vector<std::int64_t> given;
        std::vector<std::int64_t> without;
        for (int k = 0; k < 2000; ++k) { // 100 poses a second
            const bool isLost = k == 3 || k == 1000;
            if (OverlayParts* parts = isLost ? nullptr : own.partsOf(k * 10ms)) {
                parts->colour = RgbImage(1, 1);
                parts->depth = DepthImage(1, 1);
            }
            own.addPose(k * 10ms, {Rigid3()}, {});
            while (const auto frame = own.next()) {
                given.push_back(frame->stamp / 10ms);
                if (frame->overlays.empty()) {
                    without.push_back(given.back());
                }
            }
        }
        EXPECT_THAT(without, ElementsAre(3, 1000)) << wait / 1ms;
        ASSERT_EQ(given.size(), 2000U) << wait / 1ms;
        EXPECT_TRUE(std::is_sorted(given.begin(), given.end()));
        EXPECT_EQ(own.counters().overlaysUnused, 0U);
    }
}

TEST_F(Schedule, OverlaysThatComeFasterThanFramesAreRenderedAreKeptForTheFirstFrames) {
    want(0, Pace::Every, 10s);
    for (int k = 0; k < 100; ++k) {
        pose(k * 10ms);
        overlay(k * 10ms);
    }
    ASSERT_EQ(frames().size(), 100U) << "the others do not wait for overlays that were forgotten";
    EXPECT_EQ(std::count(withOverlay.begin(), withOverlay.begin() + 32, true), 32);
    EXPECT_EQ(std::count(withOverlay.begin() + 32, withOverlay.end(), false), 68);
    EXPECT_EQ(schedule.counters().overlaysUnused, 68U);
    pose(2000ms);
    overlay(2000ms);
    EXPECT_THAT(frames(), ElementsAre(2000));
    EXPECT_TRUE(withOverlay.back());
}

TEST_F(Schedule, AnOverlayThatComesAfterItsFrameIsDroppedAndTakesNoRoom) {
    want(0, Pace::Every, 100ms);
    pose(0ms);
    pose(100ms);
    EXPECT_THAT(frames(), ElementsAre(0));
    for (int round = 0; round < 100; ++round) {
        overlay(0ms);
        overlay(50ms); // of no pose
    }
    EXPECT_EQ(schedule.counters().overlaysUnused, 2U);
    overlay(100ms);
    EXPECT_THAT(frames(), ElementsAre(100));
    EXPECT_THAT(withOverlay, ElementsAre(false, true));
}

TEST_F(Schedule, AfterANewStartTheFirstOverlayMayComeBeforeItsPose) {
    want(0, Pace::Every, 500ms);
    for (int round = 0; round < 3; ++round) {
        for (int ms = 0; ms < 300; ms += 100) { // in lock-step
            overlay(ms * 1ms);
            pose(ms * 1ms);
            EXPECT_THAT(frames(), ElementsAre(ms)) << round;
        }
    }
    EXPECT_EQ(std::count(withOverlay.begin(), withOverlay.end(), false), 0);
    EXPECT_EQ(schedule.counters().restarts, 2U);
    EXPECT_EQ(schedule.counters().overlaysUnused, 0U);
}

TEST_F(Schedule, AnOverlayFromBeforeANewStartIsNotLaidIntoALaterFrame) {
    want(0, Pace::Every, 500ms);
    pose(5000ms);
    pose(0ms);
    EXPECT_EQ(schedule.counters().dropped, 1U) << "the frame that waited when time went back";
    overlay(5000ms); // was under way when time went back
    for (int ms = 0; ms <= 5000; ms += 100) {
        pose(ms * 1ms);
        EXPECT_THAT(frames(), IsEmpty());
        overlay(ms * 1ms);
        EXPECT_THAT(frames(), ElementsAre(ms));
    }
    EXPECT_EQ(schedule.counters().overlaysUnused, 1U);
}

TEST_F(Schedule, WhatWaitsIsBounded) {
    want(0, Pace::Every);
    for (int ms = 0; ms < 1000; ++ms) {
        pose(ms * 1ms);
    }
    EXPECT_EQ(frames().size() + schedule.counters().dropped, 1000U);
    EXPECT_GT(schedule.counters().dropped, 500U);
}

TEST(RigSchedule, WaitsForTheOverlaysOfAllCameras) {
    CameraOptions options;
    options.rateHz = 0;
    options.overlay.emplace();
    options.overlay->by = ObjectsBy::Alone;
    FrameSchedule schedule(options, 2);
    const auto overlay = [&](Stamp stamp, std::size_t camera) {
        OverlayParts* parts = schedule.partsOf(stamp, camera);
        ASSERT_NE(parts, nullptr);
        parts->colour = RgbImage(1, 1);
        parts->depth = DepthImage(1, 1);
    };
    schedule.addPose(10ms, {Rigid3(), Rigid3()}, {});
    overlay(10ms, 1);
    EXPECT_FALSE(schedule.next());
    overlay(10ms, 0);
    const auto frame = schedule.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->overlays.size(), 2U);
    EXPECT_EQ(frame->roomFromCameras.size(), 2U);
}

} // namespace
} // namespace spherewalk::simulator
