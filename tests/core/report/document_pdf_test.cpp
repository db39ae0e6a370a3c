// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "pdf_reading.h"
#include "random.h"

#include "spherewalk/report/document.h"
#include "spherewalk/report/page_layout.h"

#include <algorithm>
#include <set>

namespace spherewalk::report {

using test::PdfPage;
using test::PdfWords;

namespace {

constexpr double kNumberMm = 297 - kMarginMm; ///< The base line of a page's number.
constexpr double kHairMm = 0.05;              ///< Coordinates in a PDF are rounded.

std::string madeWord(test::Random& random) {
    std::string word(static_cast<std::size_t>(random.integer(1, 11)), ' ');
    std::generate(word.begin(), word.end(), [&] { return static_cast<char>(random.integer('a', 'z')); });
    return word;
}

std::string madeSentence(test::Random& random, int mostWords) {
    std::string sentence = madeWord(random);
    for (int i = random.integer(0, mostWords - 1); i > 0; --i) {
        sentence += " " + madeWord(random);
    }
    return sentence;
}

Table madeTable(test::Random& random) {
    Table table;
    const int columns = random.integer(1, 14);
    for (int row = random.integer(1, 40); row >= 0; --row) {
        std::vector<std::string>& cells = row == 0 ? table.titles : table.rows.emplace_back();
        std::generate_n(std::back_inserter(cells), columns, [&] { return madeSentence(random, 2); });
    }
    table.leftColumns = static_cast<std::size_t>(random.integer(0, columns));
    return table;
}

Document madeDocument(test::Random& random) {
    Document document{madeSentence(random, 20), {}};
    for (int i = 0; i < 12; ++i) {
        switch (random.integer(0, 4)) {
        case 0:
            document.blocks.emplace_back(Heading{madeSentence(random, 12)});
            break;
        case 1:
            document.blocks.emplace_back(madeTable(random));
            break;
        case 2:
            document.blocks.emplace_back(PictureRow{{RgbImage(8, 6), RgbImage(6, 8)}, {"left", "right"}});
            break;
        default:
            document.blocks.emplace_back(Paragraph{madeSentence(random, 150)});
        }
    }
    return document;
}

bool isNumber(const PdfWords& words) {
    return std::abs(words.at.y() - kNumberMm) < kHairMm;
}

/// All words of the pages but their numbers, without blanks.
std::string lettersOf(const std::vector<PdfPage>& pages) {
    std::string letters;
    for (const PdfPage& page : pages) {
        for (const PdfWords& words : page.words) {
            letters += isNumber(words) ? "" : words.words;
        }
    }
    std::erase(letters, ' ');
    return letters;
}

bool overlap(const PdfWords& a, const PdfWords& b) {
    const auto top = [](const PdfWords& words) { return words.at.y() - 0.7 * words.heightMm; };
    return a.at.x() < b.rightMm() && b.at.x() < a.rightMm() && top(a) < b.at.y() && top(b) < a.at.y();
}

std::vector<PdfPage> pagesOf(const Document& document) {
    const Bytes bytes = pdf(document);
    return test::PdfReading(bytes).pages();
}

/// The page on which the words stand, counted from 0; -1 if they stand nowhere.
int pageOf(const std::vector<PdfPage>& pages, const std::string& words) {
    const auto found = std::find_if(pages.begin(), pages.end(), [&](const PdfPage& page) {
        return std::any_of(page.words.begin(), page.words.end(),
                           [&](const PdfWords& one) { return one.words == words; });
    });
    return found == pages.end() ? -1 : static_cast<int>(found - pages.begin());
}

class MadePdf : public testing::TestWithParam<unsigned> {
  protected:
    test::Random m_random{GetParam()};
    Document m_document = madeDocument(m_random);
    std::vector<PdfPage> m_pages = pagesOf(m_document);
};

} // namespace

TEST_P(MadePdf, KeepsAllWordsWithinTheMarginsOfA4) {
    ASSERT_FALSE(m_pages.empty());
    for (const PdfPage& page : m_pages) {
        EXPECT_NEAR(page.widthMm, 210, kHairMm);
        EXPECT_NEAR(page.heightMm, 297, kHairMm);
        for (const PdfWords& words : page.words) {
            EXPECT_GE(words.at.x(), kMarginMm - kHairMm) << words.words;
            EXPECT_LE(words.rightMm(), 210 - kMarginMm + kHairMm) << words.words;
            EXPECT_GE(words.at.y() - 0.7 * words.heightMm, kMarginMm - kHairMm) << words.words;
            EXPECT_LE(words.at.y(), kNumberMm + kHairMm) << words.words;
        }
    }
}

TEST_P(MadePdf, LaysNoWordsOverOthers) {
    for (const PdfPage& page : m_pages) {
        for (auto one = page.words.begin(); one != page.words.end(); ++one) {
            for (auto other = std::next(one); other != page.words.end(); ++other) {
                EXPECT_FALSE(overlap(*one, *other)) << one->words << " and " << other->words;
            }
        }
    }
}

TEST_P(MadePdf, SaysEachWordOnceAndInItsOrder) {
    std::string expected = m_document.title;
    const auto addAll = [&](const std::vector<std::string>& all) {
        for (const std::string& words : all) {
            expected += words;
        }
    };
    for (const Block& block : m_document.blocks) {
        if (const auto* heading = std::get_if<Heading>(&block)) {
            expected += heading->words;
        } else if (const auto* paragraph = std::get_if<Paragraph>(&block)) {
            expected += paragraph->words;
        } else if (const auto* pictures = std::get_if<PictureRow>(&block)) {
            addAll(pictures->captions);
        } else {
            addAll(std::get<Table>(block).titles);
            for (const auto& row : std::get<Table>(block).rows) {
                addAll(row);
            }
        }
    }
    std::erase(expected, ' ');
    EXPECT_EQ(lettersOf(m_pages), expected);
}

TEST_P(MadePdf, NumbersItsPagesFromOne) {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        const std::vector<PdfWords>& words = m_pages[i].words;
        ASSERT_EQ(std::count_if(words.begin(), words.end(), isNumber), 1);
        const auto number = std::find_if(words.begin(), words.end(), isNumber);
        EXPECT_EQ(number->words, std::to_string(i + 1));
        EXPECT_NEAR(number->rightMm(), 210 - kMarginMm, kHairMm);
    }
}

INSTANTIATE_TEST_SUITE_P(DocumentPdf, MadePdf, testing::Range(1U, 9U));

TEST(DocumentPdf, CarriesEachFontThatItUses) {
    const Bytes bytes = pdf({"Title", {Paragraph{"regular"}, Table{{"bold"}, {{"Größe"}}}}});
    const std::string_view text = textOf(bytes);
    std::size_t fonts = 0;
    for (std::size_t at = 0; (at = text.find("/FontDescriptor\n", at)) != std::string_view::npos; ++at) {
        ++fonts;
        const std::string_view object = text.substr(at, text.find("endobj", at) - at);
        EXPECT_NE(object.find("/FontFile"), std::string_view::npos) << object;
    }
    EXPECT_GE(fonts, 2U);
}

TEST(DocumentPdf, BreaksAWordThatIsWiderThanThePage) {
    std::string path = "/home/somebody";
    for (int i = 0; i < 40; ++i) {
        path += "/folder" + std::to_string(i);
    }
    const std::vector<PdfPage> pages = pagesOf({"T", {Paragraph{"before " + path + " after"}}});
    EXPECT_EQ(lettersOf(pages), "Tbefore" + path + "after");
    ASSERT_EQ(pages.size(), 1U);
    for (const PdfWords& words : pages.front().words) {
        EXPECT_LE(words.rightMm(), 210 - kMarginMm + kHairMm) << words.words;
    }
    EXPECT_GT(pages.front().words.size(), 4U);
}

TEST(DocumentPdf, BreaksAWordBetweenItsLettersOnly) {
    std::string word;
    for (int i = 0; i < 400; ++i) {
        word += "ü"; // two bytes
    }
    const std::vector<PdfPage> pages = pagesOf({"T", {Paragraph{word}}});
    EXPECT_EQ(lettersOf(pages).size(), 401U); // a PDF has one byte for each such letter
}

TEST(DocumentPdf, KeepsAHeadingOnThePageOfTheParagraphBelow) {
    std::set<int> seen;
    for (int before = 15; before < 50; ++before) {
        Document document{"T", {}};
        document.blocks.resize(static_cast<std::size_t>(before), Paragraph{"p"});
        document.blocks.emplace_back(Heading{"Heading"});
        document.blocks.emplace_back(Paragraph{"below"});
        const std::vector<PdfPage> pages = pagesOf(document);
        EXPECT_EQ(pageOf(pages, "Heading"), pageOf(pages, "below")) << before;
        seen.insert(pageOf(pages, "Heading"));
    }
    EXPECT_EQ(seen, (std::set<int>{0, 1})); // the foot of a page was among them
}

TEST(DocumentPdf, KeepsAHeadingOnThePageOfThePicturesBelow) {
    for (int before = 0; before < 30; ++before) {
        Document document{"T", {}};
        document.blocks.resize(static_cast<std::size_t>(before), Paragraph{"p"});
        document.blocks.emplace_back(Heading{"Heading"});
        document.blocks.emplace_back(PictureRow{{RgbImage(40, 30)}, {"caption"}});
        const std::vector<PdfPage> pages = pagesOf(document);
        EXPECT_EQ(pageOf(pages, "Heading"), pageOf(pages, "caption")) << before;
    }
}

TEST(DocumentPdf, SetsColumnsFlushAsTheTableAsks) {
    const Table table{{"name", "left", "right"}, {{"a", "b", "c"}, {"aaaa", "bbbb", "cccc"}}, 2};
    const std::vector<PdfPage> pages = pagesOf({"T", {table}});
    const auto find = [&](const std::string& words) {
        return *std::find_if(pages.front().words.begin(), pages.front().words.end(),
                             [&](const PdfWords& one) { return one.words == words; });
    };
    EXPECT_NEAR(find("b").at.x(), find("bbbb").at.x(), kHairMm);
    EXPECT_NEAR(find("b").at.x(), find("left").at.x(), kHairMm);
    EXPECT_NEAR(find("c").rightMm(), find("cccc").rightMm(), kHairMm);
    EXPECT_NEAR(find("c").rightMm(), find("right").rightMm(), kHairMm);
    EXPECT_NEAR(find("a").at.y(), find("c").at.y(), kHairMm);
}

TEST(DocumentPdf, LetsOnlyWideTablesHaveSmallWords) {
    const auto heightOf = [](std::size_t columns) {
        const Table table{std::vector<std::string>(columns, "a long title"), {}};
        return pagesOf({"T", {table}}).front().words.at(1).heightMm;
    };
    EXPECT_NEAR(heightOf(1), heightOf(6), 0.01);
    EXPECT_LT(heightOf(20), 0.8 * heightOf(6));
}

TEST(DocumentPdf, RefusesWordsThatAreNoText) {
    test::expectError(ErrorKind::Internal, "could not be drawn", [] { pdf({"T", {Paragraph{"\xff\xfe"}}}); });
}

} // namespace spherewalk::report
