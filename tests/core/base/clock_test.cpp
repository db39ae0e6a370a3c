// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/clock.h"
#include "spherewalk/base/fixed_random.h"

#include <gtest/gtest.h>

namespace spherewalk {

using Moment = std::chrono::system_clock::time_point;

TEST(Clock, WritesMomentsInUtc) {
    EXPECT_EQ(isoUtc(Moment(std::chrono::milliseconds(1767323045678))), "2026-01-02T03:04:05.678Z");
    EXPECT_EQ(isoUtc(Moment(std::chrono::milliseconds(-1))), "1969-12-31T23:59:59.999Z");
}

TEST(Clock, EveryMomentReadsBackAsItself) {
    FixedRandom random(31);
    for (int i = 0; i < 10000; ++i) {
        const Moment moment(
            std::chrono::milliseconds(static_cast<std::int64_t>(random.uniform(-8e12, 9e12))));
        ASSERT_EQ(parseIsoUtc(isoUtc(moment)), moment) << isoUtc(moment);
    }
}

TEST(Clock, RefusesWhatIsNoMoment) {
    for (const char* bad :
         {"", "2026-01-02", "2026-01-02T03:04:05Z", "2026-01-02 03:04:05.678Z", "2026-02-30T00:00:00.000Z",
          "2026-13-01T00:00:00.000Z", "2026-01-02T24:00:00.000Z", "2026-01-02T00:60:00.000Z",
          "2026-01-02T00:00:60.000Z", "2026-01-02T03:04:05.678+", "x026-01-02T03:04:05.678Z",
          "9999-01-02T03:04:05.678Z", "0001-01-02T03:04:05.678Z"}) {
        EXPECT_FALSE(parseIsoUtc(bad)) << bad;
    }
    EXPECT_TRUE(parseIsoUtc("2024-02-29T23:59:59.999Z"));
}

TEST(Clock, SaysDurationsAsPeopleDo) {
    using std::chrono::duration;
    using std::chrono::seconds;
    EXPECT_EQ(humanDuration(seconds(-5)), "0 s");
    EXPECT_EQ(humanDuration(seconds(8)), "8 s");
    EXPECT_EQ(humanDuration(duration<double>(59.4)), "59 s");
    EXPECT_EQ(humanDuration(duration<double>(59.6)), "1 min 0 s");
    EXPECT_EQ(humanDuration(seconds(200)), "3 min 20 s");
    EXPECT_EQ(humanDuration(seconds(3599)), "59 min 59 s");
    EXPECT_EQ(humanDuration(seconds(2 * 3600 + 17 * 60)), "2 h 17 min");
}

TEST(Clock, MonotonicTimeNeverGoesBack) {
    Clock& clock = systemClock();
    for (int i = 0; i < 1000; ++i) {
        const Clock::TimePoint before = clock.now();
        ASSERT_LE(before, clock.now());
    }
}

} // namespace spherewalk
