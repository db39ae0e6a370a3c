// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/report/document.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/report/svg.h"

#include <algorithm>

namespace spherewalk::report {

namespace {

constexpr int kFigureQuality = 90;
constexpr std::string_view kPageStyle = R"(<style>
:root { color-scheme: light dark }
body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; max-width: 56em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 1em 0; font-size: 14px }
td, th { padding: .15em .9em; text-align: right; border-bottom: 1px solid #8884 }
.left { text-align: left }
figure { display: inline-block; margin: 0 1% 1em 0; vertical-align: top }
img { width: 100% }
figcaption { font-size: 13px }
svg { max-width: 100%; height: auto; display: block; margin: 1em 0 }
</style>
)";

/// Writes a document as a page, with its pictures as files beside it.
class HtmlPage {
  public:
    explicit HtmlPage(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    void write(const Document& document) {
        m_html = text(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
            "content=\"width=device-width\">\n<title>",
            escaped(document.title), "</title>\n", kPageStyle, "<h1>", escaped(document.title), "</h1>\n");
        for (const Block& block : document.blocks) {
            std::visit([&](const auto& one) { add(one); }, block);
        }
        writeFile(m_folder / "report.html", bytesOf(m_html + "</html>\n"));
    }

  private:
    void add(const Heading& heading) { m_html += text("<h2>", escaped(heading.words), "</h2>\n"); }

    void add(const Paragraph& paragraph) { m_html += text("<p>", escaped(paragraph.words), "</p>\n"); }

    void add(const Drawing& drawing) { m_html += drawing.svg; }

    void add(const Table& table) {
        m_html += "<table>\n";
        row(table.titles, table, "th");
        for (const std::vector<std::string>& cells : table.rows) {
            row(cells, table, "td");
        }
        m_html += "</table>\n";
    }

    void row(const std::vector<std::string>& cells, const Table& table, const char* tag) {
        m_html += "<tr>";
        for (std::size_t i = 0; i < table.titles.size(); ++i) {
            m_html += text("<", tag, i < table.leftColumns ? " class=\"left\">" : ">",
                           i < cells.size() ? escaped(cells[i]) : "", "</", tag, ">");
        }
        m_html += "</tr>\n";
    }

    void add(const PictureRow& pictures) {
        const auto count = static_cast<double>(pictures.pictures.size());
        for (std::size_t i = 0; i < pictures.pictures.size(); ++i) {
            const std::string file = text("report-", ++m_pictures, ".jpg");
            writeFile(m_folder / file, jpeg::encode(pictures.pictures[i], kFigureQuality));
            m_html +=
                text("<figure style=\"width:", fixed(98 / count - 1, 1), "%\"><img src=\"", file,
                     "\" alt=\"\"><figcaption>", escaped(pictures.captions[i]), "</figcaption></figure>\n");
        }
    }

    std::filesystem::path m_folder;
    std::string m_html;
    int m_pictures = 0;
};

constexpr std::size_t kColumnGap = 3;

std::vector<std::size_t> columnWidths(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    return widths;
}

} // namespace

std::string Table::text() const {
    std::vector<std::vector<std::string>> all = rows;
    if (!titles.empty()) {
        all.insert(all.begin(), titles);
    }
    const std::vector<std::size_t> widths = columnWidths(all);
    std::string result;
    for (const std::vector<std::string>& row : all) {
        std::string line = "  ";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blank(widths[i] - row[i].size(), ' ');
            line += std::string(i == 0 ? 0 : kColumnGap, ' ');
            line += i < leftColumns ? row[i] + blank : blank + row[i];
        }
        result += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return result;
}

void writeReportFolder(const Document& document, const Json& figures, const std::filesystem::path& folder) {
    ensureFolder(folder);
    HtmlPage(folder).write(document);
    writeFile(folder / "report.pdf", pdf(document));
    writeFile(folder / "report.json", bytesOf(figures.dump(1) + "\n"));
}

} // namespace spherewalk::report
