// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_folder.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/measure/svg.h"

namespace spherewalk::jobs {

using measure::escaped;

namespace {

constexpr int kJpegQuality = 90;
constexpr std::string_view kStyle = R"(<style>
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

/// A document becoming a page, its pictures files.
class HtmlPage {
  public:
    explicit HtmlPage(const std::filesystem::path& folder) : m_folder(folder) {}

    void write(const sheet::Document& document) {
        m_html =
            text("<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                 "content=\"width=device-width\">\n<title>",
                 escaped(document.title), "</title>\n", kStyle, "<h1>", escaped(document.title), "</h1>\n");
        for (const sheet::Block& block : document.blocks) {
            std::visit([&](const auto& one) { add(one); }, block);
        }
        writeFile(m_folder / "report.html", bytesOf(m_html + "</html>\n"));
    }

  private:
    void add(const sheet::Heading& heading) { m_html += text("<h2>", escaped(heading.words), "</h2>\n"); }

    void add(const sheet::Paragraph& paragraph) { m_html += text("<p>", escaped(paragraph.words), "</p>\n"); }

    void add(const sheet::Drawing& drawing) { m_html += drawing.svg; }

    void add(const sheet::Table& table) {
        m_html += "<table>\n";
        row(table.titles, table, "th");
        for (const std::vector<std::string>& cells : table.rows) {
            row(cells, table, "td");
        }
        m_html += "</table>\n";
    }

    void row(const std::vector<std::string>& cells, const sheet::Table& table, const char* tag) {
        m_html += "<tr>";
        for (std::size_t i = 0; i < table.titles.size(); ++i) {
            m_html += text("<", tag, i < table.leftColumns ? " class=\"left\">" : ">",
                           i < cells.size() ? escaped(cells[i]) : "", "</", tag, ">");
        }
        m_html += "</tr>\n";
    }

    void add(const sheet::PictureRow& pictures) {
        const auto count = static_cast<double>(pictures.pictures.size());
        for (std::size_t i = 0; i < pictures.pictures.size(); ++i) {
            const std::string file = text("report-", ++m_pictures, ".jpg");
            writeFile(m_folder / file, jpeg::encode(pictures.pictures[i], kJpegQuality));
            m_html +=
                text("<figure style=\"width:", fixed(98 / count - 1, 1), "%\"><img src=\"", file,
                     "\" alt=\"\"><figcaption>", escaped(pictures.captions[i]), "</figcaption></figure>\n");
        }
    }

    std::filesystem::path m_folder;
    std::string m_html;
    int m_pictures = 0;
};

} // namespace

void writeReportFolder(const sheet::Document& document, const Json& figures,
                       const std::filesystem::path& folder) {
    ensureFolder(folder);
    HtmlPage(folder).write(document);
    writeFile(folder / "report.pdf", sheet::pdf(document));
    writeFile(folder / "report.json", bytesOf(figures.dump(1) + "\n"));
}

} // namespace spherewalk::jobs
