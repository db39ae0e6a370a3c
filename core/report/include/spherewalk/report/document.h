// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/base/json_fwd.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace spherewalk::report {

struct Heading {
    std::string words;
};

struct Paragraph {
    std::string words;
};

/// Cells in rows below titles, for a screen, a page and a PDF. Rows may be shorter than the titles; a table
/// for a screen may have longer rows or no titles.
struct Table {
    std::vector<std::string> titles;
    std::vector<std::vector<std::string>> rows;
    std::size_t leftColumns = 1; ///< The first leftColumns columns are flush left, the others flush right.

    /// The table for a screen: one line for the titles, if there are any, and one for each row. Each line is
    /// indented by two blanks. Cells count bytes, so that only ASCII lines up.
    std::string text() const;
};

struct Drawing {
    std::string svg; ///< A whole SVG document with its width and height in pixels.
};

/// Pictures side by side, as wide as they fit together, with a few words below each. Range: at least one.
struct PictureRow {
    std::vector<RgbImage> pictures;
    std::vector<std::string> captions; ///< One for each picture.
};

using Block = std::variant<Heading, Paragraph, Table, Drawing, PictureRow>;

/// The contents of a report, for paper and for a web page alike.
struct Document {
    std::string title;
    std::vector<Block> blocks;
};

/// The document on pages of A4. The same document gives the same bytes. Errors: Internal, such as for a
/// drawing that is not SVG.
Bytes pdf(const Document& document);

/// Writes the document as report.pdf and as report.html with its pictures beside it, and the figures as
/// report.json. The folder is made if it does not exist. Errors: Io, Full; those of pdf().
void writeReportFolder(const Document& document, const Json& figures, const std::filesystem::path& folder);

} // namespace spherewalk::report
