// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "markup.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/report/document.h"

#include <algorithm>
#include <set>

namespace spherewalk::report {

using test::expectError;
using testing::HasSubstr;
using testing::Not;

namespace {

RgbImage evenPicture(int width, int height, std::uint8_t level) {
    RgbImage picture(width, height);
    std::fill(picture.values().begin(), picture.values().end(), level);
    return picture;
}

Document shortDocument() {
    Document document{"Views & <errors>", {}};
    document.blocks.emplace_back(Heading{"How right they are"});
    document.blocks.emplace_back(Paragraph{"Fewer than 5 & more than 3."});
    return document;
}

/// The names of all files in a folder.
std::set<std::string> fileNames(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.insert(entry.path().filename());
    }
    return names;
}

class ReportFiles : public testing::Test {
  protected:
    std::string page() const { return readTextFile(m_out / "report.html"); }

    test::TemporaryFolder m_folder;
    std::filesystem::path m_out = m_folder / "a/b/report";
};

} // namespace

TEST_F(ReportFiles, KeepsTheOrderOfItsBlocks) {
    Document document{"t", {}};
    for (const char* words : {"first", "second", "third"}) {
        document.blocks.emplace_back(Heading{words});
        document.blocks.emplace_back(Paragraph{std::string("about the ") + words});
    }
    writeReportFolder(document, {}, m_out);
    std::size_t last = 0;
    for (const char* words :
         {"<h2>first", "about the first", "<h2>second", "about the second", "<h2>third"}) {
        const std::size_t at = page().find(words);
        ASSERT_NE(at, std::string::npos) << words;
        EXPECT_GT(at, last) << words;
        last = at;
    }
}

TEST_F(ReportFiles, NeedsNoNetwork) {
    Document document = shortDocument();
    document.blocks.emplace_back(PictureRow{{evenPicture(8, 8, 100)}, {"grey"}});
    writeReportFolder(document, {}, m_out);
    EXPECT_THAT(page(), Not(HasSubstr("http")));
    EXPECT_THAT(page(), Not(HasSubstr("<script")));
}

TEST_F(ReportFiles, PutsPicturesBesideThePageInTheirOrder) {
    Document document{"t", {}};
    document.blocks.emplace_back(
        PictureRow{{evenPicture(16, 8, 40), evenPicture(8, 8, 200)}, {"dark", "a < b"}});
    document.blocks.emplace_back(PictureRow{{evenPicture(8, 16, 120)}, {"middle"}});
    writeReportFolder(document, {}, m_out);
    const std::vector<int> levels{40, 200, 120};
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::string name = "report-" + std::to_string(i + 1) + ".jpg";
        EXPECT_NEAR(jpeg::decode(readFile(m_out / name), name).at(3, 3)[1], levels[i], 3) << name;
        EXPECT_THAT(page(), HasSubstr("src=\"" + name + "\""));
    }
    EXPECT_FALSE(std::filesystem::exists(m_out / "report-4.jpg"));
    EXPECT_THAT(page(), HasSubstr("<figcaption>a &lt; b</figcaption>"));
}

TEST_F(ReportFiles, PutsDrawingsIntoThePageAsTheyAre) {
    const std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10\" height=\"10\"></svg>";
    Document document{"t", {}};
    document.blocks.emplace_back(Drawing{svg});
    writeReportFolder(document, {}, m_out);
    EXPECT_THAT(page(), HasSubstr(svg));
}

TEST_F(ReportFiles, GivesTheSameBytesForTheSameDocument) {
    Document document = shortDocument();
    document.blocks.emplace_back(PictureRow{{evenPicture(8, 8, 77)}, {"c"}});
    writeReportFolder(document, {{"a", 1}}, m_out);
    writeReportFolder(document, {{"a", 1}}, m_folder / "again");
    for (const std::string& name : fileNames(m_out)) {
        EXPECT_EQ(readTextFile(m_out / name), readTextFile(m_folder / "again" / name)) << name;
    }
}

TEST_F(ReportFiles, HoldsAPageThatIsWellFormedWhateverItSays) {
    const std::string hostile = "</p><script>\"&amp;' <b";
    Document document{hostile, {Heading{hostile}, Paragraph{hostile}}};
    document.blocks.emplace_back(
        Table{{hostile, "n"}, {{hostile}, {}, {"a", hostile, "more than the titles"}}});
    document.blocks.emplace_back(PictureRow{{evenPicture(8, 8, 77)}, {hostile}});
    writeReportFolder(document, {{hostile, hostile}}, m_out);
    EXPECT_EQ(test::markupDefect(page()), "");
    EXPECT_EQ(Json::parse(readTextFile(m_out / "report.json"))[hostile], hostile);
}

TEST_F(ReportFiles, SaysWhichFolderItCannotMake) {
    writeFile(m_folder / "a", bytesOf("a file"));
    expectError(ErrorKind::Io, "a/b/report", [&] { writeReportFolder(shortDocument(), {}, m_out); });
}

} // namespace spherewalk::report
