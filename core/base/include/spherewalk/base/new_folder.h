// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace spherewalk {

/// what: as the sentence names it, "the dataset". Errors: Exists if there is something by this name.
void requireAbsent(const std::filesystem::path& folder, std::string_view what);

/// Has a folder filled beside its final place, and renames it into it when all that is in it is on the disk:
/// it is whole or not there. fill gets the path to write to. Errors: Exists; Full and Io, also for filesystem
/// errors of fill; other errors of fill. After an error nothing is left; a program that was killed leaves a
/// folder that ends in ".part".
void makeFolder(const std::filesystem::path& folder, std::string_view what,
                const std::function<void(const std::filesystem::path&)>& fill);

} // namespace spherewalk
