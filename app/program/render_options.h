// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/render/view_stream.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <stop_token>
#include <string>

namespace spherewalk::program {

/// What all programs that render have in common: the dataset, the camera, and how to render.
class RenderOptions {
  public:
    /// The dataset, --camera, --scene, --sampling, --threads, --no-verify.
    void declare(CLI::App& command);

    /// As it was given.
    const std::string& folder() const { return m_dataset; }

    CameraModel cameraModel() const;
    render::ViewOptions viewOptions() const;

    /// With hashes compared when the dataset is opened, or photo by photo.
    render::Renderer renderer(const std::filesystem::path& dataset, ProgressSink& progress,
                              const std::stop_token& stop) const;

  private:
    std::string m_dataset;
    std::string m_camera;
    std::string m_scene = "auto";
    std::string m_sampling = "footprint";
    int m_threads = 0;
    bool m_noVerify = false;
};

/// For cameras that move.
class StreamOptions {
  public:
    /// --late, --prefetch.
    void declare(CLI::App& command);

    render::StreamOptions options() const;

  private:
    std::string m_late = "wait";
    double m_prefetchS = render::StreamOptions().prefetchSeconds;
};

} // namespace spherewalk::program
