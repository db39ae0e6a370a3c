// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "parts/csv.h"
#include "random.h"

#include "spherewalk/base/text.h"

namespace spherewalk::jobs {

using test::expectError;

namespace {

using Fields = std::vector<std::string>;

/// The fields of all records, without their line numbers.
std::vector<Fields> recordsOf(std::string_view csv) {
    std::vector<Fields> records;
    for (const CsvLine& line : parseCsv(csv, "t.csv")) {
        records.push_back(line.fields);
    }
    return records;
}

std::vector<int> numbersOf(std::string_view csv) {
    std::vector<int> numbers;
    for (const CsvLine& line : parseCsv(csv, "t.csv")) {
        numbers.push_back(line.number);
    }
    return numbers;
}

/// A field of letters, separators, quotes, line breaks and bytes beyond ASCII. It neither begins nor ends
/// with a blank, which an unquoted field would lose.
std::string randomField(test::Random& random) {
    static const std::vector<std::string> kPieces{"a",    "Z", "0",        ",",   "\"", "\"\"", "\n",
                                                  "\r\n", ";", "\xc3\xa9", "x y", "\\", "'",    "#"};
    std::string field;
    for (int i = random.integer(0, 8); i > 0; --i) {
        field += kPieces[static_cast<std::size_t>(random.integer(0, static_cast<int>(kPieces.size()) - 1))];
    }
    return field;
}

} // namespace

TEST(Csv, ReadsFieldsBetweenCommas) {
    EXPECT_EQ(recordsOf("a,b,c\n1,2,3\n"), (std::vector<Fields>{{"a", "b", "c"}, {"1", "2", "3"}}));
    EXPECT_EQ(recordsOf("a,,c\n,\n"), (std::vector<Fields>{{"a", "", "c"}, {"", ""}}));
}

TEST(Csv, HasTheSameRecordsWhateverEndsItsLines) {
    const std::vector<Fields> records{{"a", "b"}, {"c", "d"}};
    EXPECT_EQ(recordsOf("a,b\nc,d\n"), records);
    EXPECT_EQ(recordsOf("a,b\nc,d"), records) << "without the last line break";
    EXPECT_EQ(recordsOf("a,b\r\nc,d\r\n"), records);
    EXPECT_EQ(recordsOf("a,b\r\nc,d"), records);
    EXPECT_EQ(recordsOf("a,b\nc,d\r\n"), records) << "mixed";
}

TEST(Csv, LeavesBlankLinesOutAndCountsThem) {
    EXPECT_EQ(recordsOf("\n\na\n \t\n\r\nb\n\n"), (std::vector<Fields>{{"a"}, {"b"}}));
    EXPECT_EQ(numbersOf("\n\na\n \t\n\r\nb\n\n"), (std::vector<int>{3, 6}));
    EXPECT_TRUE(recordsOf("").empty());
    EXPECT_TRUE(recordsOf("\r\n\r\n").empty());
}

TEST(Csv, KeepsALineThatIsOnlyAnEmptyQuotedField) {
    EXPECT_EQ(recordsOf("\"\"\na\n"), (std::vector<Fields>{{""}, {"a"}}));
}

TEST(Csv, TakesBlanksAwayOnlyAroundUnquotedFields) {
    EXPECT_EQ(recordsOf(" a b \t,\t c\n"), (std::vector<Fields>{{"a b", "c"}}));
    EXPECT_EQ(recordsOf("\" a \",\"\tb\"\n"), (std::vector<Fields>{{" a ", "\tb"}}));
    EXPECT_EQ(recordsOf("  \" a \"\n"), (std::vector<Fields>{{" a "}})) << "blanks before the quote";
}

TEST(Csv, ReadsQuotedCommasQuotesAndLineBreaks) {
    EXPECT_EQ(recordsOf("\"a,b\",\"say \"\"no\"\"\"\n"), (std::vector<Fields>{{"a,b", "say \"no\""}}));
    EXPECT_EQ(recordsOf("\"two\nlines\",x\n"), (std::vector<Fields>{{"two\nlines", "x"}}));
    EXPECT_EQ(recordsOf("\"carriage\r\nreturn\"\n"), (std::vector<Fields>{{"carriage\r\nreturn"}}));
    EXPECT_EQ(recordsOf("\"\"\"\"\n"), (std::vector<Fields>{{"\""}}));
    EXPECT_EQ(recordsOf("\"\",\"\"\n"), (std::vector<Fields>{{"", ""}}));
}

TEST(Csv, TakesAQuoteInsideAnUnquotedFieldAsItStands) {
    EXPECT_EQ(recordsOf("5\" rail,b\n"), (std::vector<Fields>{{"5\" rail", "b"}}));
}

TEST(Csv, NumbersARecordByItsFirstLine) {
    EXPECT_EQ(numbersOf("a\n\"b\nb\nb\"\nc\n"), (std::vector<int>{1, 2, 5}));
    EXPECT_EQ(numbersOf("a\r\n\"b\r\nb\"\r\nc\r\n"), (std::vector<int>{1, 2, 4}));
}

TEST(Csv, IgnoresTheByteOrderMarkOfSpreadsheetsAndNoOther) {
    EXPECT_EQ(recordsOf("\xef\xbb\xbf"
                        "file,x\n"),
              (std::vector<Fields>{{"file", "x"}}));
    EXPECT_EQ(recordsOf("\xef\xbb\xbf\"file\",x\n"), (std::vector<Fields>{{"file", "x"}}));
    EXPECT_EQ(recordsOf("a,\xef\xbb\xbf"
                        "b\n"),
              (std::vector<Fields>{{"a", "\xef\xbb\xbf"
                                         "b"}}));
}

TEST(Csv, KeepsNulBytes) {
    using namespace std::string_view_literals;
    const std::vector<Fields> records = recordsOf("a\0b,\"\0\"\n\0\n"sv);
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0], (Fields{std::string("a\0b"sv), std::string("\0"sv)}));
    EXPECT_EQ(records[1], (Fields{std::string("\0"sv)}));
}

TEST(Csv, ReadsFieldsOfMegabytes) {
    const std::string huge(3 << 20, 'x');
    const std::vector<Fields> records = recordsOf("a," + huge + "\n\"" + huge + "\n\",b\n");
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0][1], huge);
    EXPECT_EQ(records[1][0], huge + "\n");
    EXPECT_EQ(records[1][1], "b");
}

TEST(Csv, ReadsManyFieldsInALine) {
    const std::string commas(20'000, ',');
    EXPECT_EQ(recordsOf(commas).at(0).size(), 20'001U);
}

TEST(Csv, NamesTheLineOfAQuoteThatIsNeverClosed) {
    expectError(ErrorKind::InvalidInput, "t.csv: a quote that opens in line 3 is never closed",
                [] { parseCsv("a,b\n\n\"c,d\ne\n\nf", "t.csv"); });
    expectError(ErrorKind::InvalidInput, "line 1", [] { parseCsv("\"", "t.csv"); });
    expectError(ErrorKind::InvalidInput, "line 2", [] { parseCsv("a\nb,\"c\"\"\n", "t.csv"); });
}

TEST(CsvField, IsQuotedOnlyIfItHasToBe) {
    EXPECT_EQ(csvField("photo.jpg"), "photo.jpg");
    EXPECT_EQ(csvField(""), "");
    EXPECT_EQ(csvField("a,b"), "\"a,b\"");
    EXPECT_EQ(csvField("say \"no\""), "\"say \"\"no\"\"\"");
    EXPECT_EQ(csvField("two\nlines"), "\"two\nlines\"");
    EXPECT_EQ(csvField("carriage\rreturn"), "\"carriage\rreturn\"");
}

TEST(CsvField, IsReadBackAsItWasWritten) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        std::vector<Fields> table(static_cast<std::size_t>(random.integer(1, 5)));
        std::string csv;
        for (Fields& record : table) {
            record.push_back("first"); // a line is never blank
            for (int i = random.integer(0, 4); i > 0; --i) {
                record.push_back(randomField(random));
            }
            for (std::size_t i = 0; i < record.size(); ++i) {
                csv += (i == 0 ? "" : ",") + csvField(record[i]);
            }
            csv += random.integer(0, 1) == 0 ? "\n" : "\r\n";
        }
        ASSERT_EQ(recordsOf(csv), table) << csv;
    }
}

TEST(Csv, NeverFailsButForAnOpenQuote) {
    constexpr std::string_view kLetters = "a,\"\n\r \t";
    for (unsigned seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        std::string csv;
        for (int i = random.integer(0, 30); i > 0; --i) {
            csv +=
                kLetters[static_cast<std::size_t>(random.integer(0, static_cast<int>(kLetters.size()) - 1))];
        }
        try {
            int last = 0;
            for (const CsvLine& line : parseCsv(csv, "t.csv")) {
                ASSERT_GT(line.number, last) << csv;
                ASSERT_FALSE(line.fields.empty()) << csv;
                last = line.number;
            }
        } catch (const Error& error) {
            ASSERT_THAT(error.sentence(), testing::HasSubstr("never closed")) << csv;
        }
    }
}

} // namespace spherewalk::jobs
