// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/source_dataset.h"

#include "spherewalk/jobs/export_dataset.h"

namespace spherewalk::jobs {

SourceDataset::SourceDataset(const store::SurveyStore& survey, render::SceneKind scene,
                             ProgressSink& progress, const std::stop_token& stop)
    : m_temporary(std::in_place, "spherewalk-export"), m_path(m_temporary->path() / "dataset") {
    ExportOptions options;
    options.scene = scene;
    m_depthSeconds = exportDataset(survey, m_path, options, progress, stop).depth.seconds;
}

} // namespace spherewalk::jobs
