// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/measure_dataset.h"

namespace spherewalk::jobs {

struct ChosenExport {
    MeasureReport measured;
    render::SceneKind scene = render::SceneKind::Sphere; ///< the richest that was exported
    ExportReport exported;
};

/// Exports the scene model that earns its place and no richer one: measures all of them on a dataset in the
/// survey's cache, exports with the cheapest that holds the tolerance (or the best, if none does), and stores
/// the choice in the new dataset. Results are kept in that cache, too: a run that was stopped goes on where
/// it was. Errors: those of exportDataset(), measureDataset() and storeChoice(); Exists before anything is
/// measured.
ChosenExport exportChosen(const store::SurveyStore& store, const std::filesystem::path& folder,
                          const CameraModel& camera, const MeasureOptions& measure,
                          const dataset::WriteOptions& write, ProgressSink& progress,
                          const std::stop_token& stop);

} // namespace spherewalk::jobs
