// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/export_chosen.h"

#include "spherewalk/base/new_folder.h"
#include "spherewalk/jobs/measure_survey.h"

#include <algorithm>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

/// Of the time, most is for depths.
constexpr double kExported = 0.6;
constexpr double kMeasured = 0.9;

} // namespace

ChosenExport exportChosen(const store::SurveyStore& store, const fs::path& folder, const CameraModel& camera,
                          const MeasureOptions& measure, const dataset::WriteOptions& write,
                          ProgressSink& progress, const std::stop_token& stop) {
    measure.validate();
    requireAbsent(folder, "the dataset");
    const fs::path cache = measureCacheFolder(store.folder());
    ProgressStep exporting(progress, 0, kExported);
    const fs::path all = surveyDataset(store, render::SceneKind::Depth, cache, exporting, stop);
    const render::Renderer renderer(std::make_shared<const render::Dataset>(
        render::Dataset::open(all, render::Verify::Sizes, noProgress(), stop)));
    ProgressStep measuring(progress, kExported, kMeasured);
    ChosenExport result;
    MeasureOptions kept = measure;
    kept.cacheFolder = cache / "results";
    result.measured = measureDataset(renderer, camera, kept, measuring, stop);
    if (result.measured.choice.rung) {
        result.scene = std::max(result.scene, result.measured.rungs[*result.measured.choice.rung].scene);
    }
    ProgressStep writing(progress, kMeasured, 1);
    result.exported = exportDataset(store, folder, {write, result.scene, {}}, writing, stop);
    if (result.measured.choice.rung) {
        storeChoice(folder, result.measured);
    }
    return result;
}

} // namespace spherewalk::jobs
