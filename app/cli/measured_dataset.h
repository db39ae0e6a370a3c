// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dataset_options.h"

#include "spherewalk/survey/plan.h"

#include <filesystem>
#include <optional>

namespace spherewalk::cli {

/// The option --tolerance.
void declareTolerance(CLI::App& command, double& tolerancePx);

/// What measuring commands have in common: a dataset, or a survey that is exported first; and a folder for
/// results.
class MeasuredDataset {
  public:
    void declare(CLI::App& command);

    const DatasetOptions& options() const { return m_options; }

    bool isSurvey() const;

    /// With this scene model and the cheaper ones, if it is a survey's.
    render::Renderer renderer(render::SceneKind richest, Context& context) const;

    /// Where results are kept; empty, with a warning, if the usual place cannot be written.
    std::filesystem::path resultFolder(Context& context) const;

    /// What is to be scanned, as the survey plans it or as the dataset says.
    std::pair<survey::Room, survey::PlanOptions> plan(const render::DatasetInfo& info) const;

  private:
    std::filesystem::path cacheFolder() const;

    DatasetOptions m_options;
    std::string m_cache;
};

} // namespace spherewalk::cli
