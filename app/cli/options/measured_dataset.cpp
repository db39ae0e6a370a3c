// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/measured_dataset.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/store/survey_store.h"

namespace spherewalk::cli {

namespace fs = std::filesystem;

std::vector<jobs::RobotPicture> robotPictures(const program::RenderOptions& options, const fs::path& csv,
                                              bool mayLackPoses) {
    std::vector<jobs::RobotPicture> pictures = jobs::readRobotPictures(csv, mayLackPoses);
    for (jobs::RobotPicture& picture : pictures) {
        picture.roomFromCamera = options.opticalPose(picture.roomFromCamera);
    }
    return pictures;
}

void MeasuredDataset::declare(const program::Command& command) {
    m_options.declare(command, "Folder of the dataset, or of a survey, which is exported first");
    m_options.declareFrame(command);
    command.option("--cache", m_cache,
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
        return m_options.renderer(context.progress, context.stop);
    }
    const auto store = store::SurveyStore::open(m_options.folder(), store::Access::Read);
    return m_options.renderer(
        jobs::surveyDataset(store, richest, cacheFolder(), context.progress, context.stop), context.progress,
        context.stop);
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
        return {store.knownRoom(), store.planOptions()};
    }
    return {{info.outline, info.obstacles, info.ceilingM}, {}};
}

} // namespace spherewalk::cli
