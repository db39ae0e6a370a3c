// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/render_options.h"

#include "spherewalk/render/camera_info.h"

#include <memory>

namespace spherewalk::program {

void RenderOptions::declare(CLI::App& command) {
    command.add_option("dataset", m_dataset, "Folder of the dataset")->required();
    command.add_option("--camera", m_camera, "Camera: a ROS camera-info YAML")->required();
    command
        .add_option("--scene", m_scene,
                    "Scene model for places between photos: none, sphere, room, depth, or auto")
        ->check(CLI::IsMember({"none", "sphere", "room", "depth", "auto"}))
        ->capture_default_str();
    command
        .add_option(
            "--sampling", m_sampling,
            "How pixels are made, cheap to exact: nearest, bilinear, reduced, footprint, bicubic, or auto")
        ->check(CLI::IsMember({"nearest", "bilinear", "reduced", "footprint", "bicubic", "auto"}))
        ->capture_default_str();
    command.add_option("--threads", m_threads, "Threads to render with; 0: all")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command.add_flag("--no-verify", m_noVerify, "Check the hashes only of the photos that are read");
}

render::Renderer RenderOptions::renderer(const std::filesystem::path& dataset, ProgressSink& progress,
                                         const std::stop_token& stop) const {
    const render::Verify verify = m_noVerify ? render::Verify::Sizes : render::Verify::Hashes;
    render::RendererOptions options;
    options.verify = m_noVerify ? render::VerifyPhotos::BeforeUse : render::VerifyPhotos::AtOpen;
    return render::Renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(dataset, verify, progress, stop)),
        options);
}

CameraModel RenderOptions::cameraModel() const {
    return CameraModel(render::readCameraInfo(m_camera));
}

render::ViewOptions RenderOptions::viewOptions() const {
    render::ViewOptions options;
    if (m_scene != "auto") {
        options.scene = render::sceneKind(m_scene);
    }
    options.sampling = render::sampling(m_sampling);
    options.threads = m_threads;
    return options;
}

void StreamOptions::declare(CLI::App& command) {
    command
        .add_option("--late", m_late,
                    "What a view is made from when its photo is not decoded yet: wait for it, coarse (the "
                    "thumbnail), or previous (the photo before)")
        ->check(CLI::IsMember({"wait", "coarse", "previous"}))
        ->capture_default_str();
    command.add_option("--prefetch", m_prefetchS, "Seconds of the path's motion to decode ahead; 0: none")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
}

render::StreamOptions StreamOptions::options() const {
    return {render::latePolicy(m_late), m_prefetchS};
}

} // namespace spherewalk::program
