// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/folder.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/jobs/export_dataset.h"

#include <filesystem>
#include <optional>
#include <stop_token>

namespace spherewalk::store {
class SurveyStore;
}

namespace spherewalk::jobs {

/// A dataset to export something else from: a folder that is one, or one that is made of a survey and lives
/// as long as the object.
class SourceDataset {
  public:
    explicit SourceDataset(std::filesystem::path dataset) : m_path(std::move(dataset)) {}

    /// Errors: those of exportDataset(). Stop: Stopped.
    SourceDataset(const store::SurveyStore& survey, const ExportOptions& options, ProgressSink& progress,
                  const std::stop_token& stop);

    const std::filesystem::path& path() const { return m_path; }

    /// How long the depths took that were not known yet.
    double depthSeconds() const { return m_depthSeconds; }

  private:
    std::optional<TemporaryFolder> m_temporary;
    std::filesystem::path m_path;
    double m_depthSeconds = 0;
};

/// Warns of lengths that are hardly known. sigma: as DatasetInfo::scaleSigma.
void tellScale(double sigma, ProgressSink& progress);

} // namespace spherewalk::jobs
