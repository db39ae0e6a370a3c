// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo/camera_time.h"
#include "random.h"

#include <gtest/gtest.h>

namespace spherewalk::practice {
namespace {

using namespace std::chrono_literals;

ZonedTime momentOf(int year, unsigned month, unsigned day, std::chrono::seconds ofDay,
                   std::chrono::minutes zone) {
    return {std::chrono::sys_days(std::chrono::year(year) / static_cast<int>(month) / static_cast<int>(day)) +
                ofDay,
            zone};
}

TEST(CameraTime, IsSpelledInItsZone) {
    const ZonedTime time = momentOf(2026, 1, 2, 3h + 4min + 5s, 0min);
    EXPECT_EQ(exifTime(time), "2026:01:02 03:04:05");
    EXPECT_EQ(exifTime({time.utc, 90min}), "2026:01:02 04:34:05");
    EXPECT_EQ(exifTime({time.utc, -240min}), "2026:01:01 23:04:05") << "the day before";
    EXPECT_EQ(exifTime({time.utc + 999ms, 0min}), "2026:01:02 03:04:05") << "fractions are cut off";
    EXPECT_EQ(exifTime(momentOf(2024, 2, 29, 23h, 120min)), "2024:03:01 01:00:00");
}

TEST(CameraTime, ZonesHaveASign) {
    EXPECT_EQ(zoneText(0min), "+00:00");
    EXPECT_EQ(zoneText(90min), "+01:30");
    EXPECT_EQ(zoneText(-210min), "-03:30");
    EXPECT_EQ(zoneText(14h), "+14:00");
}

TEST(CameraTime, IsReadAsItIsSpelled) {
    test::Random random(31);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 500; ++i) {
        const ZonedTime time{std::chrono::sys_seconds(std::chrono::seconds(random.integer(0, 2'000'000'000))),
                             std::chrono::minutes(random.integer(-14 * 60, 14 * 60))};
        const std::string spelled = exifTime(time) + zoneText(time.zone);
        const std::optional<ZonedTime> read = parseDateTimeZone(spelled);
        ASSERT_TRUE(read) << spelled;
        EXPECT_EQ(read->utc, time.utc) << spelled;
        EXPECT_EQ(read->zone, time.zone) << spelled;
    }
}

TEST(CameraTime, IsRefusedInAnyOtherForm) {
    const std::string good = "2026:01:02 03:04:05+01:00";
    ASSERT_TRUE(parseDateTimeZone(good));
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string wrong = good;
        wrong[i] = 'x';
        EXPECT_FALSE(parseDateTimeZone(wrong)) << wrong;
        EXPECT_FALSE(parseDateTimeZone(good.substr(0, i))) << i;
    }
    EXPECT_FALSE(parseDateTimeZone(good + " "));
    EXPECT_FALSE(parseDateTimeZone("2026-01-02T03:04:05+01:00"));
}

TEST(CameraTime, IsRefusedWhereThereIsNoSuchMoment) {
    for (const char* wrong :
         {"2026:02:29 00:00:00+00:00", "2026:13:01 00:00:00+00:00", "2026:00:10 00:00:00+00:00",
          "2026:04:31 00:00:00+00:00", "2026:01:00 00:00:00+00:00", "2026:01:02 24:00:00+00:00",
          "2026:01:02 00:60:00+00:00", "2026:01:02 00:00:60+00:00", "2026:01:02 00:00:00+14:01"}) {
        EXPECT_FALSE(parseDateTimeZone(wrong)) << wrong;
    }
    EXPECT_TRUE(parseDateTimeZone("2024:02:29 23:59:59-14:00"));
}

} // namespace
} // namespace spherewalk::practice
