// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/counted.h"
#include "spherewalk/base/text.h"
#include "spherewalk/base/uuid.h"

#include <gtest/gtest.h>

#include <limits>
#include <locale>

namespace spherewalk {

TEST(Text, WritesNumbersSoThatTheyReadBackAsTheSame) {
    for (const double number : {0.1, 1e6 + 0.123456789, -3.0, 1e-300, std::numeric_limits<double>::max()}) {
        EXPECT_EQ(parseNumber(text(number)), number);
    }
    EXPECT_EQ(text("a ", 3, " b ", 2.5), "a 3 b 2.5");
}

TEST(Text, ParsesWholeNumbersOnlyAndNothingElse) {
    EXPECT_EQ(parseNumber("-1.5e3"), -1500);
    EXPECT_EQ(parseNumber("+2"), 2);
    for (const char* bad : {"", "1,5", "1.5m", " 1", "nan", "inf", "1e999", "+", "--1", "0x10"}) {
        EXPECT_FALSE(parseNumber(bad)) << bad;
    }
}

TEST(Text, SaysDurationsAndSizesAsPeopleDo) {
    using std::chrono::seconds;
    EXPECT_EQ(humanDuration(seconds(8)), "8 s");
    EXPECT_EQ(humanDuration(seconds(200)), "3 min 20 s");
    EXPECT_EQ(humanDuration(seconds(2 * 3600 + 17 * 60)), "2 h 17 min");
    EXPECT_EQ(humanBytes(999), "999 bytes");
    EXPECT_EQ(humanBytes(4362617), "4.4 MB");
    EXPECT_EQ(humanBytes(999960), "1.0 MB");
    EXPECT_EQ(humanBytes(UINT64_MAX), "18.4 EB");
}

TEST(Text, WritesMomentsInUtc) {
    const std::chrono::system_clock::time_point moment{std::chrono::milliseconds(1767323045678)};
    EXPECT_EQ(isoUtc(moment), "2026-01-02T03:04:05.678Z");
    EXPECT_EQ(isoUtc(std::chrono::system_clock::time_point(std::chrono::milliseconds(-1))),
              "1969-12-31T23:59:59.999Z");
}

TEST(Text, PrintsForeignTextWithoutControlCharactersOrBrokenUtf8) {
    EXPECT_EQ(printable("Küche\n\x1b[2J"), "Küche??[2J");
    EXPECT_EQ(printable("\xff\xc3"), "??");
    EXPECT_EQ(printable(std::string(200, 'x'), 10), "xxxxxxxxxx...");
    EXPECT_EQ(printable("ééé", 3), "é...");
}

TEST(Uuid, IsVersion4AndNeverTheSame) {
    const std::string uuid = randomUuid();
    ASSERT_EQ(uuid.size(), 36U);
    EXPECT_EQ(uuid[14], '4');
    EXPECT_NE(std::string("89ab").find(uuid[19]), std::string::npos);
    EXPECT_NE(uuid, randomUuid());
}

TEST(Text, CountsOneAndMany) {
    EXPECT_EQ(counted(0, "photo was", "photos were"), "0 photos were");
    EXPECT_EQ(counted(1, "photo was", "photos were"), "1 photo was");
    EXPECT_EQ(counted(std::size_t{2}, "photo was", "photos were"), "2 photos were");
}

} // namespace spherewalk
