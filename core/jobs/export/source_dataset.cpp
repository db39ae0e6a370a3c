// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/source_dataset.h"

namespace spherewalk::jobs {

SourceDataset::SourceDataset(const store::SurveyStore& survey, const ExportOptions& options,
                             ProgressSink& progress, const std::stop_token& stop)
    : m_temporary(std::in_place, "spherewalk-export"), m_path(m_temporary->path() / "dataset") {
    m_depthSeconds = exportDataset(survey, m_path, options, progress, stop).depth.seconds;
}

} // namespace spherewalk::jobs
