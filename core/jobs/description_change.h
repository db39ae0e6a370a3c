// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"

#include <filesystem>
#include <functional>

namespace spherewalk::jobs {

/// Changes a dataset's description, dataset.json. What is not understood in it is kept. Errors: those of
/// reading the description, before and after the change, and of writing it.
void changeDescription(const std::filesystem::path& dataset, const std::function<void(Json&)>& change);

} // namespace spherewalk::jobs
