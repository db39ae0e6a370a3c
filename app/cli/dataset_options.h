// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command.h"

#include "spherewalk/jobs/robot_pictures.h"
#include "spherewalk/render/renderer.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace spherewalk::cli {

/// What view and walk have in common: the dataset, the camera, and how to render.
class DatasetOptions {
  public:
    void declare(CLI::App& command);

    /// As it was given: for a command that takes a survey too.
    const std::string& folder() const { return m_dataset; }

    CameraModel cameraModel() const;
    render::ViewOptions viewOptions() const;

    /// With hashes compared when the dataset is opened, or photo by photo.
    render::Renderer renderer(Context& context) const { return renderer(context, m_dataset); }

    /// Of another dataset, in place of the one that was given.
    render::Renderer renderer(Context& context, const std::filesystem::path& dataset) const;

    /// A robot's pictures, whose poses are of the frame that the user named.
    std::vector<jobs::RobotPicture> robotPictures(const std::filesystem::path& csv) const;

    /// The pose of the optical frame that a given pose, of the frame that the user named, stands for.
    Rigid3 opticalPose(const Rigid3& roomFromGiven) const;

  private:
    std::string m_dataset;
    std::string m_camera;
    std::string m_frame = "optical";
    std::string m_scene = "auto";
    std::string m_sampling = "footprint";
    int m_threads = 0;
    bool m_noVerify = false;
};

} // namespace spherewalk::cli
