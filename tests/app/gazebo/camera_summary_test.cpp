// SPDX-License-Identifier: GPL-3.0-or-later
#include "published_camera.h"

#include "spherewalk/base/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::gazebo {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Milliseconds = std::chrono::duration<double, std::milli>;

TEST(Latencies, QuantilesAreOfTheFramesInTheirOrderOfLength) {
    Latencies latencies;
    EXPECT_EQ(latencies.quantile(0.5), 0);
    for (int i = 100; i >= 0; --i) {
        latencies.add(Milliseconds(i));
    }
    EXPECT_EQ(latencies.quantile(0), 0);
    EXPECT_EQ(latencies.quantile(0.5), 50);
    EXPECT_EQ(latencies.quantile(0.99), 99);
    EXPECT_EQ(latencies.quantile(1), 100);
}

TEST(Latencies, OldFramesAreForgotten) {
    Latencies latencies;
    for (int i = 0; i < 100'000; ++i) {
        latencies.add(Milliseconds(i < 30'000 ? 1000 : 2));
    }
    EXPECT_EQ(latencies.quantile(1), 2);
}

TEST(CameraSummary, SaysWhatWentWrongAndNothingElse) {
    simulator::CameraCounters counters;
    counters.frames = 7;
    EXPECT_THAT(summary(counters, {}), AllOf(HasSubstr("Gave 7 frames"), Not(HasSubstr("\n"))));
    counters.dropped = 3;
    counters.refused[static_cast<std::size_t>(simulator::Refusal::Encoding)] = 2;
    EXPECT_THAT(summary(counters, {}),
                AllOf(HasSubstr("3 frames were left out"), HasSubstr("2 inputs were refused: encoding.")));
    EXPECT_EQ(toJson(counters, {})["refused"]["encoding"], 2);
}

} // namespace
} // namespace spherewalk::gazebo
