// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured_dataset.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jobs/measure_survey.h"

namespace spherewalk::cli {

namespace fs = std::filesystem;

void declareTolerance(CLI::App& command, double& tolerancePx) {
    command
        .add_option("--tolerance", tolerancePx,
                    "Pixels of the robot's camera that 95 of 100 places may be displaced by")
        ->check(CLI::Range(0.01, 1000.0))
        ->capture_default_str();
}

void MeasuredDataset::declare(CLI::App& command) {
    m_options.declare(command);
    command.get_option("dataset")->description(
        "Folder of the dataset, or of a survey, which is exported first");
    command.add_option("--cache", m_cache,
                       "Folder to keep results in, so that a run that was stopped goes on where it was; by "
                       "default beside the dataset, or in the survey");
}

bool MeasuredDataset::isSurvey() const {
    return jobs::isSurvey(m_options.folder());
}

fs::path MeasuredDataset::cacheFolder() const {
    return m_cache.empty() ? jobs::measureCacheFolder(m_options.folder()) : fs::path(m_cache);
}

render::Renderer MeasuredDataset::renderer(render::SceneKind richest, Context& context) const {
    if (!isSurvey()) {
        return m_options.renderer(context);
    }
    const auto store = store::SurveyStore::open(m_options.folder(), store::Access::Read);
    return m_options.renderer(
        context, jobs::surveyDataset(store, richest, cacheFolder(), context.progress, context.stop));
}

fs::path MeasuredDataset::resultFolder(Context& context) const {
    const fs::path folder = cacheFolder() / "results";
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure && m_cache.empty()) {
        context.progress.warning(text("Results are not kept, since ", folder.string(), " cannot be made (",
                                      failure.message(), "); name another folder with --cache."));
        return {};
    }
    return folder;
}

std::pair<survey::Room, survey::PlanOptions> MeasuredDataset::plan(const render::DatasetInfo& info) const {
    if (isSurvey()) {
        const auto store = store::SurveyStore::open(m_options.folder(), store::Access::Read);
        return {store.room(), store.planOptions()};
    }
    return {{info.outline, info.obstacles, info.ceilingM}, {}};
}

} // namespace spherewalk::cli
