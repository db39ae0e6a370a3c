// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/export_dataset.h"

#include <filesystem>
#include <stop_token>

namespace spherewalk::jobs {

/// A dataset of one photo, as exportDataset() makes it. Errors: as exportDataset().
dataset::WriteReport exportOne(const store::SurveyStore& store, const store::PhotoRecord& photo,
                               const std::filesystem::path& folder, const dataset::WriteOptions& options,
                               const std::stop_token& stop);

/// What the depths of an export would take. Errors: those of depthForecast().
DepthForecast exportForecast(const store::SurveyStore& store, const ExportOptions& options, bool withTrial,
                             const std::stop_token& stop);

} // namespace spherewalk::jobs
