// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "options/command.h"
#include "program/render_options.h"

#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/survey/plan.h"

#include <filesystem>
#include <utility>
#include <vector>

namespace spherewalk::cli {

/// The pictures of a robot's camera that the file names, with the poses of its optical frame. options: tell
/// the frame of the file's poses. Errors: those of jobs::readRobotPictures().
std::vector<jobs::RobotPicture> robotPictures(const program::RenderOptions& options,
                                              const std::filesystem::path& csv, bool mayLackPoses = false);

/// The options of commands that measure: a dataset, or a survey that is exported first, and a folder for
/// results.
class MeasuredDataset {
  public:
    void declare(const program::Command& command);

    const program::RenderOptions& options() const { return m_options; }

    bool isSurvey() const;

    /// Opens the dataset. A survey is exported first, with this scene model and the cheaper ones. Errors,
    /// Stop: those of RenderOptions::renderer() and jobs::surveyDataset().
    render::Renderer renderer(render::SceneKind richest, Context& context) const;

    /// The folder that keeps results. Empty, with a warning, where the usual folder cannot be written.
    std::filesystem::path resultFolder(Context& context) const;

    /// The room and the plan of the survey, or the room that the dataset describes.
    std::pair<survey::Room, survey::PlanOptions> plan(const render::DatasetInfo& info) const;

  private:
    std::filesystem::path cacheFolder() const;

    program::RenderOptions m_options;
    std::string m_cache;
};

} // namespace spherewalk::cli
