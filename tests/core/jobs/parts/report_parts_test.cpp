// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/report_parts.h"
#include "warnings.h"

#include "spherewalk/base/json.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::jobs {

namespace {

RgbImage evenPicture(int width, int height, std::uint8_t level) {
    RgbImage picture(width, height);
    std::fill(picture.values().begin(), picture.values().end(), level);
    return picture;
}

} // namespace

TEST(ReportParts, ShowADashOrNullForWhatIsNotKnown) {
    EXPECT_EQ(orDash(std::nullopt), "-");
    EXPECT_EQ(orDash(1.005), "1.00");
    EXPECT_EQ(orDash(-2.5, 0), "-2");
    EXPECT_EQ(orDash(0.126, 1), "0.1");
    EXPECT_TRUE(orNull(std::nullopt).is_null());
    EXPECT_EQ(orNull(0.5), Json(0.5));
    EXPECT_EQ(orNull(0), Json(0.0));
}

TEST(ReportParts, AreGreyWherePicturesAreAlike) {
    const RgbImage same = difference(evenPicture(4, 3, 90), evenPicture(4, 3, 90), 4);
    EXPECT_EQ(same.width(), 4);
    EXPECT_EQ(same.height(), 3);
    for (const std::uint8_t value : same.values()) {
        EXPECT_EQ(value, 128);
    }
}

TEST(ReportParts, AreBrighterWhereTheFirstPictureIsAndStayInRange) {
    for (int a = 0; a < 256; a += 15) {
        for (int b = 0; b < 256; b += 15) {
            const auto level = [](int value) { return evenPicture(1, 1, static_cast<std::uint8_t>(value)); };
            const int shown = difference(level(a), level(b), 4).values()[0];
            EXPECT_EQ(shown, std::clamp(128 + 4 * (a - b), 0, 255)) << a << " beside " << b;
        }
    }
}

TEST(ReportParts, HandOnEachWarningOnce) {
    test::Warnings warnings;
    EachWarningOnce once(warnings);
    ProgressStep first(once, 0, 0.5);
    ProgressStep second(once, 0.5, 1);
    first.warning("A lens is dirty.");
    first.warning("A photo is dark.");
    second.warning("A lens is dirty.");
    EXPECT_EQ(warnings.sentences, (std::vector<std::string>{"A lens is dirty.", "A photo is dark."}));
}

} // namespace spherewalk::jobs
