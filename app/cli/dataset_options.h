// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command.h"
#include "program/render_options.h"

#include "spherewalk/jobs/robot_pictures.h"

#include <filesystem>
#include <string>
#include <vector>

namespace spherewalk::cli {

/// What view and walk have in common: the dataset, the camera, and how to render.
class DatasetOptions {
  public:
    void declare(CLI::App& command);

    /// As it was given: for a command that takes a survey too.
    const std::string& folder() const { return m_render.folder(); }

    CameraModel cameraModel() const { return m_render.cameraModel(); }

    render::ViewOptions viewOptions() const { return m_render.viewOptions(); }

    /// With hashes compared when the dataset is opened, or photo by photo.
    render::Renderer renderer(Context& context) const { return renderer(context, folder()); }

    /// Of another dataset, in place of the one that was given.
    render::Renderer renderer(Context& context, const std::filesystem::path& dataset) const {
        return m_render.renderer(dataset, context.progress, context.stop);
    }

    /// A robot's pictures, whose poses are of the frame that the user named.
    std::vector<jobs::RobotPicture> robotPictures(const std::filesystem::path& csv) const;

    /// The pose of the optical frame that a given pose, of the frame that the user named, stands for.
    Rigid3 opticalPose(const Rigid3& roomFromGiven) const;

  private:
    program::RenderOptions m_render;
    std::string m_frame = "optical";
};

} // namespace spherewalk::cli
