// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/render/scene_model.h"
#include "spherewalk/store/survey_store.h"

#include <filesystem>
#include <stop_token>

namespace spherewalk::jobs {

/// Whether there is a survey in this folder, rather than a dataset.
bool isSurvey(const std::filesystem::path& folder);

/// Where datasets and results are kept that measuring makes, and that can be made again: in a survey, beside
/// a dataset.
std::filesystem::path measureCacheFolder(const std::filesystem::path& surveyOrDataset);

/// A dataset of the survey as it is now, with this scene model and the cheaper ones, in the cache folder:
/// the one that is there if nothing has changed since, else a new one in its place. A run that was stopped
/// goes on where it was. Errors: those of exportDataset().
std::filesystem::path surveyDataset(const store::SurveyStore& store, render::SceneKind richest,
                                    const std::filesystem::path& cacheFolder, ProgressSink& progress,
                                    const std::stop_token& stop);

} // namespace spherewalk::jobs
