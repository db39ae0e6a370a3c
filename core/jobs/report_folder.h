// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/sheet/document.h"

#include <filesystem>

namespace spherewalk::jobs {

/// Writes the document as report.html with its pictures beside it and as report.pdf, and the figures as
/// report.json. The folder is made if need be. Errors: Io, Full.
void writeReportFolder(const sheet::Document& document, const Json& figures,
                       const std::filesystem::path& folder);

} // namespace spherewalk::jobs
