// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/measure_dataset.h"

#include <filesystem>
#include <stop_token>

namespace spherewalk::jobs {

/// Whether this folder holds a survey, rather than a dataset.
bool isSurvey(const std::filesystem::path& folder);

/// The folder for what measuring makes and can make again: in a survey, or beside a dataset.
std::filesystem::path measureCacheFolder(const std::filesystem::path& surveyOrDataset);

/// The dataset of the survey as it is now, with this scene model and the cheaper ones, in the cache folder.
/// If the survey has not changed, that is the dataset of an earlier call; else a new one takes its place.
///
/// Errors: those of exportDataset().
/// Stop: Stopped; the next call goes on with the depths that are known.
std::filesystem::path surveyDataset(const store::SurveyStore& store, render::SceneKind richest,
                                    const std::filesystem::path& cacheFolder, ProgressSink& progress,
                                    const std::stop_token& stop);

/// Number of photos from which on exports propose to measure: without one of two, the other has no depth.
constexpr int kEnoughToMeasure = 3;

struct ChosenExport {
    MeasureReport measured;
    render::SceneKind scene = render::SceneKind::Sphere; ///< The richest one that was exported.
    ExportReport exported;
};

/// Exports no richer scene model than the tolerance needs. Measures all of them on a dataset in the survey's
/// cache, exports with the cheapest that holds the tolerance (or the best, if none does), and stores the
/// choice in the new dataset. The cache keeps the results: a run after a stop goes on where it was. options:
/// those of the export; its scene model is the one that was found.
///
/// Errors: Exists, before anything is measured; those of exportDataset(), measureDataset(), storeChoice().
ChosenExport exportChosen(const store::SurveyStore& store, const std::filesystem::path& folder,
                          const CameraModel& camera, const MeasureOptions& measure, ExportOptions options,
                          ProgressSink& progress, const std::stop_token& stop);

/// Writes the choice into the dataset's description, for views that are made with "auto". All else in the
/// description stays, also what this version does not understand.
/// Errors: InvalidInput if the report has no choice; NotFound, Io, Full, Corrupt for the description.
void storeChoice(const std::filesystem::path& dataset, const MeasureReport& report);

/// Writes a colour correction into the dataset's description, in place of an earlier one. All else in the
/// description stays. Datasets that are open keep what they have read.
/// Errors: those of ColourCorrection::validate(); NotFound, Io, Full, Corrupt for the description.
void storeColour(const std::filesystem::path& dataset, const render::ColourCorrection& correction);

} // namespace spherewalk::jobs
