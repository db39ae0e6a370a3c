// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/command_line.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/view_stream.h"

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::program {

/// Declares --frame, for commands that take poses from the user.
void declareFrame(const Command& command, std::string& frame);

/// Declares --camera and --rig, of which one is wanted.
void declareCameras(const Command& command, std::string& camera, std::string& rig);

/// The pose of the optical frame (z forward). roomFromGiven: the pose of the frame that --frame names.
Rigid3 opticalPose(const Rigid3& roomFromGiven, std::string_view frame);

/// The options of every command that renders: a dataset, a camera, the frame of given poses, and how views
/// are made.
class RenderOptions {
  public:
    /// Declares the dataset, --camera, or with `withRig` --camera and --rig, --scene, --sampling, --threads
    /// and --no-verify.
    void declare(const Command& command, const std::string& datasetHelp = "Folder of the dataset",
                 bool withRig = false);

    /// Declares the same without --camera and --sampling, for what is not seen by a camera.
    void declareWithoutCamera(const Command& command,
                              const std::string& datasetHelp = "Folder of the dataset");

    /// Declares --frame, for commands that take poses from the user.
    void declareFrame(const Command& command) { program::declareFrame(command, m_frame); }

    /// The dataset's folder, as the user gave it.
    const std::string& folder() const { return m_dataset; }

    /// Of a rig, the first camera. Errors: those of render::readCameraInfo() and render::readRig().
    CameraModel cameraModel() const;

    /// The cameras of --rig; none with --camera. Errors: those of render::readRig(); InvalidInput for --frame
    /// with a rig, whose file says it.
    std::vector<render::RigCamera> rig() const;

    /// The rig's file, for sentences.
    const std::string& rigFile() const { return m_rig; }

    render::ViewOptions viewOptions() const;

    /// The same for pictures that are kept. Where no choice was measured for the camera, "auto" is the most
    /// exact scene model that the dataset has, however long it takes.
    render::ViewOptions pictureOptions(const render::DatasetInfo& dataset) const;

    /// Opens the dataset and makes its renderer. The hashes of all photos are compared now, or with
    /// --no-verify those of each photo before its first use. Errors: those of render::Dataset::open(). Stop:
    /// throws Error{Stopped}.
    render::Renderer renderer(ProgressSink& progress, const std::stop_token& stop) const {
        return renderer(folder(), progress, stop);
    }

    /// The same for another dataset than the given one.
    render::Renderer renderer(const std::filesystem::path& dataset, ProgressSink& progress,
                              const std::stop_token& stop) const;

    /// The pose of the optical frame (z forward). roomFromGiven: the pose of the frame that --frame names.
    Rigid3 opticalPose(const Rigid3& roomFromGiven) const {
        return program::opticalPose(roomFromGiven, m_frame);
    }

  private:
    std::string m_dataset;
    std::string m_camera;
    std::string m_rig;
    std::string m_frame = "optical";
    std::string m_scene = "auto";
    std::string m_sampling = "best";
    int m_threads = 0;
    bool m_noVerify = false;
};

/// The options of commands whose camera moves.
class StreamOptions {
  public:
    /// Declares --late, --prefetch and --passage.
    void declare(const Command& command);

    render::StreamOptions options() const;

  private:
    std::string m_late = "wait";
    double m_prefetchS = render::StreamOptions().prefetchSeconds;
    double m_passageM = render::StreamOptions().passageM;
};

} // namespace spherewalk::program
