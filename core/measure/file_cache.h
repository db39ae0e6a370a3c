// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace spherewalk::measure {

/// Asks the system to forget what it keeps of the file in memory, and tells whether it did: file systems in
/// memory cannot, and others may refuse. Errors: NotFound, Io.
bool dropFromFileCache(const std::filesystem::path& file);

} // namespace spherewalk::measure
