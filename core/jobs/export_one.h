// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/dataset/writer.h"
#include "spherewalk/store/survey_store.h"

#include <filesystem>
#include <stop_token>

namespace spherewalk::jobs {

/// A dataset of one photo, as exportDataset() makes it. Errors: as exportDataset().
dataset::WriteReport exportOne(const store::SurveyStore& store, const store::PhotoRecord& photo,
                               const std::filesystem::path& folder, const dataset::WriteOptions& options,
                               const std::stop_token& stop);

} // namespace spherewalk::jobs
