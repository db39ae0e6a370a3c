// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/text.h"

#include <Eigen/Geometry>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::test {

// What stands where on the pages of a PDF that cairo wrote. Units: millimetres from the upper left corner of
// the page, y down.

/// Words that were drawn in one go.
struct PdfWords {
    std::string words;
    Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< Where the base line begins.
    double widthMm = 0;
    double heightMm = 0; ///< The size of the font.

    double rightMm() const { return at.x() + widthMm; }
};

struct PdfSegment {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
};

/// A ring or a disc.
struct PdfRound {
    Eigen::Vector2d centre;
    double radiusMm = 0;
    bool isFilled = false;
};

struct PdfPage {
    double widthMm = 0;
    double heightMm = 0;
    std::vector<PdfWords> words;
    std::vector<PdfSegment> segments; ///< Of lines and outlines that were stroked.
    std::vector<PdfRound> rounds;
    std::vector<std::vector<PdfSegment>> areas; ///< The edges of what was filled in one go.
};

/// The widths of a font's letters, in sizes of the font.
struct PdfFont {
    std::size_t first = 0;
    std::vector<double> widths;

    double widthOf(const std::string& words) const {
        double sum = 0;
        for (const char letter : words) {
            const std::size_t index = static_cast<unsigned char>(letter) - first;
            sum += index < widths.size() ? widths[index] / 1000 : 0;
        }
        return sum;
    }
};

/// Runs the operators of one page.
class PdfContents {
  public:
    PdfContents(PdfPage& page, std::map<std::string, PdfFont> fonts)
        : m_page(page), m_fonts(std::move(fonts)) {}

    void run(std::string_view contents) {
        constexpr std::string_view kBlank = " \n\r\t";
        for (std::size_t at = 0; (at = contents.find_first_not_of(kBlank, at)) != std::string_view::npos;) {
            if (contents[at] == '(') {
                at = readString(contents, at + 1);
            } else if (contents[at] == '[' || contents[at] == ']') {
                m_isInArray = contents[at++] == '[';
            } else {
                const std::size_t end =
                    std::min(contents.find_first_of(" \n\r\t()[]/", at + 1), contents.size());
                take(std::string(contents.substr(at, end - at)));
                at = end;
            }
        }
    }

  private:
    std::size_t readString(std::string_view contents, std::size_t at) {
        std::string words;
        for (; contents[at] != ')'; ++at) {
            if (contents[at] != '\\') {
                words += contents[at];
            } else if (const int octal = digitsAt(contents, at + 1, 3); octal >= 0) {
                words += static_cast<char>(octal / 100 * 64 + octal / 10 % 10 * 8 + octal % 10);
                at += 3;
            } else if (contents[++at] != '\n') { // a backslash at the end of a line only breaks the line
                words += contents[at];
            }
        }
        m_words += words;
        m_advance += m_fonts[m_font].widthOf(words);
        return at + 1;
    }

    void take(const std::string& token) {
        if (const auto number = parseNumber(token)) {
            if (m_isInArray) {
                advance(-*number / 1000);
            } else {
                m_numbers.push_back(*number);
            }
        } else if (token.starts_with('/')) {
            m_name = token;
        } else {
            operate(token);
            m_numbers.clear();
        }
    }

    void operate(const std::string& op) {
        if (op == "q") {
            m_frames.push_back(m_frames.back());
        } else if (op == "Q") {
            m_frames.pop_back();
        } else if (op == "cm") {
            m_frames.back() = m_frames.back() * frame();
        } else if (op == "Tm") {
            beginLine(frame());
        } else if (op == "Td") {
            beginLine(m_line * Eigen::Translation2d(m_numbers.at(0), m_numbers.at(1)));
        } else if (op == "Tf") {
            m_font = m_name;
        } else if (op == "Tj" || op == "TJ") {
            endWords();
        } else if (op == "S" || op == "f" || op == "f*" || op == "n") {
            endPath(op);
        } else {
            extendPath(op);
        }
    }

    Eigen::Affine2d frame() const {
        Eigen::Affine2d result = Eigen::Affine2d::Identity();
        result.linear() << m_numbers.at(0), m_numbers.at(2), m_numbers.at(1), m_numbers.at(3);
        result.translation() << m_numbers.at(4), m_numbers.at(5);
        return result;
    }

    Eigen::Vector2d onPage(const Eigen::Vector2d& point) const {
        const Eigen::Vector2d fromBelow = m_frames.back() * point * (25.4 / 72);
        return {fromBelow.x(), m_page.heightMm - fromBelow.y()};
    }

    void beginLine(const Eigen::Affine2d& line) {
        m_line = line;
        m_begun = m_advance = 0;
    }

    /// Goes on by this many sizes of the font. What is farther away than a blank are other words.
    void advance(double sizes) {
        constexpr double kBlank = 0.4;
        if (std::abs(sizes) > kBlank) {
            endWords();
        }
        m_advance += sizes;
        m_begun = m_words.empty() ? m_advance : m_begun;
    }

    void endWords() {
        const auto at = [&](double along) { return onPage(m_line * Eigen::Vector2d(along, 0)); };
        if (!m_words.empty()) {
            const double widthMm = (at(m_advance) - at(m_begun)).norm();
            m_page.words.push_back({m_words, at(m_begun), widthMm, (at(1) - at(0)).norm()});
        }
        m_words.clear();
        m_begun = m_advance;
    }

    void extendPath(const std::string& op) {
        const auto last = [&](std::size_t back) {
            return Eigen::Vector2d(m_numbers.at(m_numbers.size() - back),
                                   m_numbers.at(m_numbers.size() - back + 1));
        };
        if (op == "m") {
            m_start = m_here = onPage(last(2));
        } else if (op == "l") {
            lineTo(onPage(last(2)));
        } else if (op == "h") {
            lineTo(m_start);
        } else if (op == "c") {
            m_curve.push_back(m_here);
            m_here = onPage(last(2));
        } else if (op == "re") {
            const Eigen::Vector2d corner = last(4);
            const Eigen::Vector2d size = last(2);
            m_here = onPage(corner);
            lineTo(onPage({corner.x() + size.x(), corner.y()}));
            lineTo(onPage(corner + size));
            lineTo(onPage({corner.x(), corner.y() + size.y()}));
            lineTo(onPage(corner));
        }
    }

    void lineTo(const Eigen::Vector2d& point) {
        m_segments.push_back({m_here, point});
        m_here = point;
    }

    void endPath(const std::string& op) {
        if (op == "S") {
            m_page.segments.insert(m_page.segments.end(), m_segments.begin(), m_segments.end());
        }
        if (op.front() == 'f') {
            m_page.areas.push_back(m_segments);
        }
        if (op != "n" && !m_curve.empty()) {
            Eigen::Vector2d across = Eigen::Vector2d::Zero();
            for (const Eigen::Vector2d& point : m_curve) {
                const Eigen::Vector2d apart = point - m_curve.front();
                across = apart.norm() > across.norm() ? apart : across;
            }
            m_page.rounds.push_back({m_curve.front() + across / 2, across.norm() / 2, op != "S"});
        }
        m_segments.clear();
        m_curve.clear();
    }

    PdfPage& m_page;
    std::map<std::string, PdfFont> m_fonts;
    std::vector<Eigen::Affine2d> m_frames{Eigen::Affine2d::Identity()};
    Eigen::Affine2d m_line = Eigen::Affine2d::Identity();
    std::vector<double> m_numbers;
    std::string m_name;
    std::string m_font;
    std::string m_words;
    double m_begun = 0;   ///< Where the words begin on their line, in sizes of the font.
    double m_advance = 0; ///< Where they end.
    bool m_isInArray = false;
    Eigen::Vector2d m_start = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_here = Eigen::Vector2d::Zero();
    std::vector<PdfSegment> m_segments;
    std::vector<Eigen::Vector2d> m_curve;
};

/// Reads the pages of a PDF.
class PdfReading {
  public:
    explicit PdfReading(const Bytes& pdf) {
        m_pdf.processMemoryFile("the PDF", reinterpret_cast<const char*>(pdf.data()), pdf.size());
    }

    std::vector<PdfPage> pages() {
        std::vector<PdfPage> result;
        for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(m_pdf).getAllPages()) {
            QPDFObjectHandle box = page.getAttribute("/MediaBox", false);
            result.push_back({box.getArrayItem(2).getNumericValue() * 25.4 / 72,
                              box.getArrayItem(3).getNumericValue() * 25.4 / 72,
                              {},
                              {},
                              {},
                              {}});
            std::string contents;
            for (QPDFObjectHandle& part : page.getPageContents()) {
                const auto data = part.getStreamData();
                contents.append(reinterpret_cast<const char*>(data->getBuffer()), data->getSize());
            }
            PdfContents(result.back(), fontsOf(page)).run(contents);
        }
        return result;
    }

  private:
    static std::map<std::string, PdfFont> fontsOf(QPDFPageObjectHelper& page) {
        std::map<std::string, PdfFont> fonts;
        for (auto& [name, font] : page.getAttribute("/Resources", false).getKey("/Font").getDictAsMap()) {
            QPDFObjectHandle of = font;
            fonts[name].first = static_cast<std::size_t>(of.getKey("/FirstChar").getIntValue());
            for (QPDFObjectHandle& width : of.getKey("/Widths").getArrayAsVector()) {
                fonts[name].widths.push_back(width.getNumericValue());
            }
        }
        return fonts;
    }

    QPDF m_pdf;
};

inline std::size_t pageCount(const Bytes& pdf) {
    QPDF document;
    document.processMemoryFile("the PDF", reinterpret_cast<const char*>(pdf.data()), pdf.size());
    return QPDFPageDocumentHelper(document).getAllPages().size();
}

} // namespace spherewalk::test
