// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <string>
#include <variant>
#include <vector>

namespace spherewalk::sheet {

struct Heading {
    std::string words;
};

struct Paragraph {
    std::string words;
};

/// Rows may be shorter than the titles.
struct Table {
    std::vector<std::string> titles;
    std::vector<std::vector<std::string>> rows;
    std::size_t leftColumns = 1; ///< flush left; the others flush right
};

struct Drawing {
    std::string svg; ///< a whole SVG document with its width and height in pixels
};

/// Pictures side by side, as wide as they fit together, each with a few words below.
struct PictureRow {
    std::vector<RgbImage> pictures;
    std::vector<std::string> captions; ///< as many
};

using Block = std::variant<Heading, Paragraph, Table, Drawing, PictureRow>;

/// What stands on paper and on a page of the web alike.
struct Document {
    std::string title;
    std::vector<Block> blocks;
};

/// The document on pages of A4. The same document gives the same bytes. Errors: Internal if it cannot be
/// made, a drawing that is no SVG among them.
Bytes pdf(const Document& document);

} // namespace spherewalk::sheet
