// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace spherewalk::cli {

/// To be called before minutes are spent on what is to be drawn. Errors: InvalidInput for a name that does
/// not end in .svg; NotFound for a folder that is not there.
void checkPlot(const std::filesystem::path& plot);

} // namespace spherewalk::cli
