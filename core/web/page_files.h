// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace spherewalk::web {

/// A file of resources/web or of a library, as it was when the program was built.
struct EmbeddedFile {
    std::string_view name;
    std::string_view content;
};

/// All files that a page is made of.
std::span<const EmbeddedFile> pageFiles();

/// The content of the file of this name. Errors: Internal if there is none.
std::string_view pageFile(std::string_view name);

} // namespace spherewalk::web
