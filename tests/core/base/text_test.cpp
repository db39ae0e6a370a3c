// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>
#include <utility>

namespace spherewalk {

TEST(Text, WritesNumbersSoThatTheyReadBackAsTheSame) {
    for (const double number : {0.1, 1e6 + 0.123456789, -3.0, 1e-300, std::numeric_limits<double>::max()}) {
        EXPECT_EQ(parseNumber(text(number)), number);
    }
    EXPECT_EQ(text("a ", 3, " b ", 2.5), "a 3 b 2.5");
}

TEST(Text, WritesNumbersWithoutAnExponentUnlessThatIsShorter) {
    const std::pair<double, const char*> cases[] = {{10, "10"},
                                                    {360, "360"},
                                                    {-0.0, "-0"},
                                                    {1234567, "1234567"},
                                                    {100000, "1e+05"},
                                                    {1e22, "1e+22"},
                                                    {0.001, "0.001"},
                                                    {1e-5, "1e-05"},
                                                    {1234.5678, "1234.5678"},
                                                    {2.5e-7, "2.5e-07"},
                                                    {NAN, "nan"},
                                                    {-1e3, "-1000"},
                                                    {1.0 / 3, "0.3333333333333333"}};
    for (const auto& [number, words] : cases) {
        EXPECT_EQ(text(number), words);
    }
}

TEST(Text, ParsesWholeNumbersOnlyAndNothingElse) {
    EXPECT_EQ(parseNumber("-1.5e3"), -1500);
    EXPECT_EQ(parseNumber("+2"), 2);
    for (const char* bad : {"", "1,5", "1.5m", " 1", "nan", "inf", "1e999", "+", "--1", "0x10"}) {
        EXPECT_FALSE(parseNumber(bad)) << bad;
    }
}

TEST(Text, SaysSizesAsPeopleDo) {
    EXPECT_EQ(humanBytes(999), "999 bytes");
    EXPECT_EQ(humanBytes(4362617), "4.4 MB");
    EXPECT_EQ(humanBytes(999960), "1.0 MB");
    EXPECT_EQ(humanBytes(UINT64_MAX), "18.4 EB");
}

TEST(Text, PrintsForeignTextWithoutControlCharactersOrBrokenUtf8) {
    EXPECT_EQ(printable("Küche\n\x1b[2J"), "Küche??[2J");
    EXPECT_EQ(printable("\xff\xc3"), "??");
    EXPECT_EQ(printable(std::string(200, 'x'), 10), "xxxxxxxxxx...");
    EXPECT_EQ(printable("ééé", 3), "é...");
}

TEST(Text, CountsOneAndMany) {
    EXPECT_EQ(counted(0, "photo was", "photos were"), "0 photos were");
    EXPECT_EQ(counted(1, "photo was", "photos were"), "1 photo was");
    EXPECT_EQ(counted(std::size_t{2}, "photo was", "photos were"), "2 photos were");
}

TEST(Text, EveryNumberReadsBackAsItself) {
    FixedRandom random(21);
    for (int i = 0; i < 10000; ++i) {
        const double number = random.uniform(-1, 1) * std::pow(10, random.uniform(-300, 300));
        ASSERT_EQ(parseNumber(text(number)), number) << text(number);
    }
}

TEST(Text, FixedDigitsAreTheNearestDecimal) {
    FixedRandom random(22);
    for (int i = 0; i < 1000; ++i) {
        const double number = random.uniform(-1e6, 1e6);
        const int digits = static_cast<int>(random.below(7));
        const std::string spelt = fixed(number, digits);
        ASSERT_NEAR(parseNumber(spelt).value(), number, 0.501 * std::pow(10, -digits)) << spelt;
        const std::size_t point = spelt.find('.');
        ASSERT_EQ(point == std::string::npos ? 0 : spelt.size() - point - 1,
                  static_cast<std::size_t>(digits));
    }
}

TEST(Text, ReadsDigitsOnlyWhereAllAreDigits) {
    EXPECT_EQ(digitsAt("R0012345", 1, 7), 12345);
    EXPECT_EQ(digitsAt("12", 0, 0), 0);
    EXPECT_EQ(digitsAt("1-3", 0, 3), -1);
    EXPECT_EQ(digitsAt("1 3", 1, 2), -1);
}

TEST(Text, PrintableTextStaysPrintableAndShort) {
    FixedRandom random(23);
    for (int i = 0; i < 2000; ++i) {
        std::string foreign(random.below(60), ' ');
        for (char& c : foreign) {
            c = static_cast<char>(random.below(256));
        }
        const std::string shown = printable(foreign, 40);
        ASSERT_LE(shown.size(), 43U);
        ASSERT_EQ(printable(shown, shown.size()), shown); // nothing is left to be replaced
        for (const char c : shown) {
            ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
        }
    }
}

} // namespace spherewalk
