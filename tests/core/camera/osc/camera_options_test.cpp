// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc/camera_options.h"
#include "random.h"

#include <gtest/gtest.h>

namespace spherewalk::camera {
namespace {

using namespace std::chrono;

TEST(CameraClock, SpellsAndReadsZonesOnBothSides) {
    const auto time = sys_days(2026y / 1 / 2) + 3h + 4min + 5s;
    EXPECT_EQ(cameraTime(time, minutes(-210)), "2026:01:01 23:34:05-03:30");
    EXPECT_EQ(cameraTime(time, minutes(60)), "2026:01:02 04:04:05+01:00");
    EXPECT_EQ(parseCameraTime("2026:01:01 23:34:05-03:30"), time);
}

TEST(CameraClock, ReadsWhatItSpells) {
    test::Random random(7);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 200; ++i) {
        const system_clock::time_point time =
            sys_days(1970y / 1 / 1) + seconds(random.integer(0, 2'000'000'000));
        EXPECT_EQ(parseCameraTime(cameraTime(time, minutes(15 * random.integer(-48, 56)))), time);
    }
}

TEST(CameraClock, ReadsNothingElse) {
    for (const char* spelled :
         {"", "2026-01-02 03:04:05+01:00", "2026:13:02 03:04:05+01:00", "2026:01:02 03:04:05 01:00",
          "2026:01:02 03:04:05", "2026:01:02 xx:04:05+01:00"}) {
        EXPECT_FALSE(parseCameraTime(spelled)) << spelled;
    }
}

TEST(CameraClock, KnowsThisComputersZone) {
    EXPECT_LE(abs(localZone(sys_days(2026y / 7 / 1))), 14h);
}

} // namespace
} // namespace spherewalk::camera
