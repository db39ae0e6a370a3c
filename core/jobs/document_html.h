// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/sheet/document.h"

#include <filesystem>

namespace spherewalk::jobs {

/// Writes the document as <name>.html and its pictures as <name>-1.jpg and so on beside it. Errors: Io, Full.
void writeHtml(const sheet::Document& document, const std::filesystem::path& folder, const std::string& name);

} // namespace spherewalk::jobs
