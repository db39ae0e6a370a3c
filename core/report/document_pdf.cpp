// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf_page.h"

#include "spherewalk/base/text.h"
#include "spherewalk/report/document.h"

#include <algorithm>
#include <numeric>

namespace spherewalk::report {

using Eigen::Vector2d;

namespace {

constexpr Paper kUpright{210, 297};
constexpr double kWidthMm = 210 - 2 * kMarginMm;
constexpr double kBottomMm = 297 - kMarginMm - 6; ///< The page's number stands below.
constexpr double kTitleTextMm = 6;
constexpr double kHeadingTextMm = 4.6;
constexpr double kTextMm = 3.4;
constexpr double kTableTextMm = 2.9;
constexpr double kLine = 1.45;       ///< The distance of lines, in heights of the text.
constexpr double kMmAPixel = 0.2646; ///< 96 pixels an inch, as on screens
constexpr double kGapMm = 3;

/// Lays a document out from top to bottom.
class DocumentPages {
  public:
    DocumentPages() : m_pages(kUpright) {}

    Bytes draw(const Document& document) {
        m_pages.setGrey(0);
        lines(document.title, kTitleTextMm, true);
        m_y += kGapMm;
        for (std::size_t i = 0; i < document.blocks.size(); ++i) {
            const bool isLast = i + 1 == document.blocks.size();
            m_nextMm = isLast ? 0 : beginMm(document.blocks[i + 1]);
            std::visit([&](const auto& one) { add(one); }, document.blocks[i]);
        }
        number();
        return m_pages.finish();
    }

  private:
    /// The height of a block that must fit on the page of its heading.
    double beginMm(const Block& block) const {
        constexpr double kOfTextMm = 40;
        if (const auto* drawing = std::get_if<Drawing>(&block)) {
            return sizeMm(*drawing).y();
        }
        const auto* pictures = std::get_if<PictureRow>(&block);
        return pictures == nullptr ? kOfTextMm : heightMm(*pictures) + kLine * kTableTextMm;
    }

    static double widthMm(const PictureRow& row) {
        const auto count = static_cast<double>(row.pictures.size());
        return (kWidthMm - (count - 1) * kGapMm) / count;
    }

    /// The height of the tallest picture.
    static double heightMm(const PictureRow& row) {
        double result = 0;
        for (const RgbImage& picture : row.pictures) {
            result = std::max(result, widthMm(row) * picture.height() / picture.width());
        }
        return result;
    }

    Vector2d sizeMm(const Drawing& drawing) const {
        const Vector2d pixels = m_pages.sizeOf(drawing.svg);
        const double widthMm = std::min(kWidthMm, pixels.x() * kMmAPixel);
        return {widthMm, widthMm * pixels.y() / pixels.x()};
    }

    void add(const Heading& heading) {
        m_y += 2 * kGapMm;
        need(2 * kLine * kHeadingTextMm + m_nextMm);
        lines(heading.words, kHeadingTextMm, true);
        m_y += 0.5 * kGapMm;
    }

    void add(const Paragraph& paragraph) {
        lines(paragraph.words, kTextMm, false);
        m_y += kGapMm;
    }

    void add(const Table& table) {
        const Columns columns = columnsOf(table);
        row(table.titles, table, columns, true);
        for (const std::vector<std::string>& cells : table.rows) {
            row(cells, table, columns, false);
        }
        m_y += kGapMm;
    }

    void add(const Drawing& drawing) {
        const Vector2d size = sizeMm(drawing);
        need(size.y());
        m_pages.drawing({kMarginMm, m_y}, size.x(), drawing.svg);
        m_y += size.y() + kGapMm;
    }

    void add(const PictureRow& row) {
        const double width = widthMm(row);
        const double height = heightMm(row);
        need(height + kLine * kTableTextMm);
        for (std::size_t i = 0; i < row.pictures.size(); ++i) {
            const double x = kMarginMm + static_cast<double>(i) * (width + kGapMm);
            m_pages.picture({x, m_y}, width, row.pictures[i]);
            m_pages.words({x, m_y + height + kLine * kTableTextMm}, row.captions[i], kTableTextMm);
        }
        m_y += height + kLine * kTableTextMm + kGapMm;
    }

    /// Measures of a table on paper.
    struct Columns {
        std::vector<double> widthsMm;
        double apartMm = 5;
        double textMm = kTableTextMm;
    };

    /// Columns are as wide as their words. Where a table is wider than the page, its columns move closer
    /// together, and then its text gets smaller.
    Columns columnsOf(const Table& table) const {
        Columns columns;
        for (const std::string& title : table.titles) {
            columns.widthsMm.push_back(m_pages.widthOf(title, kTableTextMm, true));
        }
        for (const std::vector<std::string>& cells : table.rows) {
            for (std::size_t i = 0; i < cells.size() && i < columns.widthsMm.size(); ++i) {
                columns.widthsMm[i] =
                    std::max(columns.widthsMm[i], m_pages.widthOf(cells[i], kTableTextMm, false));
            }
        }
        constexpr double kLeastApartMm = 2;
        const double wordsMm = std::accumulate(columns.widthsMm.begin(), columns.widthsMm.end(), 0.0);
        const double gaps = std::max(1.0, static_cast<double>(columns.widthsMm.size()) - 1);
        columns.apartMm = std::clamp((kWidthMm - wordsMm) / gaps, kLeastApartMm, columns.apartMm);
        const double scale = std::min(1.0, (kWidthMm - gaps * columns.apartMm) / std::max(1.0, wordsMm));
        columns.textMm *= scale;
        for (double& width : columns.widthsMm) {
            width *= scale;
        }
        return columns;
    }

    void row(const std::vector<std::string>& cells, const Table& table, const Columns& columns, bool isBold) {
        need(kLine * columns.textMm);
        m_y += kLine * columns.textMm;
        double x = kMarginMm;
        for (std::size_t i = 0; i < cells.size() && i < columns.widthsMm.size(); ++i) {
            const bool isLeft = i < table.leftColumns;
            m_pages.words({isLeft ? x : x + columns.widthsMm[i], m_y}, cells[i], columns.textMm,
                          isLeft ? Align::Left : Align::Right, isBold);
            x += columns.widthsMm[i] + columns.apartMm;
        }
    }

    /// How many bytes of the word fit on a line, at least one letter. Letters of UTF-8 stay whole.
    std::size_t fitting(const std::string& word, double heightMm, bool isBold) const {
        std::size_t fits = word.size();
        while (fits > 1 && m_pages.widthOf(word.substr(0, fits), heightMm, isBold) > kWidthMm) {
            do {
                --fits;
            } while (fits > 1 && (static_cast<unsigned char>(word[fits]) & 0xC0) == 0x80);
        }
        return fits;
    }

    /// Writes the words in as many lines as they need. A word that is wider than the page is broken.
    void lines(const std::string& words, double heightMm, bool isBold) {
        std::string line;
        const auto end = [&] {
            need(kLine * heightMm);
            m_y += kLine * heightMm;
            m_pages.words({kMarginMm, m_y}, line, heightMm, Align::Left, isBold);
            line.clear();
        };
        for (std::size_t begin = 0; begin < words.size();) {
            const std::size_t space = std::min(words.find(' ', begin), words.size());
            const std::string word = words.substr(begin, space - begin);
            const std::string longer = text(line, line.empty() ? "" : " ", word);
            if (m_pages.widthOf(longer, heightMm, isBold) <= kWidthMm) {
                line = longer;
                begin = space + 1;
                continue;
            }
            if (line.empty()) {
                const std::size_t fits = fitting(word, heightMm, isBold);
                line = word.substr(0, fits);
                begin += fits;
            }
            end();
        }
        end();
    }

    /// Begins a new page if the present one has no room for this height.
    void need(double heightMm) {
        if (m_y + heightMm > kBottomMm && m_y > kMarginMm) {
            number();
            m_pages.nextPage(kUpright);
            m_y = kMarginMm;
            ++m_page;
        }
    }

    void number() {
        m_pages.words({210 - kMarginMm, 297 - kMarginMm}, std::to_string(m_page), kTableTextMm, Align::Right);
    }

    PdfPages m_pages;
    double m_y = kMarginMm;
    double m_nextMm = 0; ///< The height that the next block needs beside its heading.
    int m_page = 1;
};

} // namespace

Bytes pdf(const Document& document) {
    return DocumentPages().draw(document);
}

} // namespace spherewalk::report
