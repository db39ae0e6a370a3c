// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/render_options.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/rotation.h"

#include <memory>

namespace spherewalk::program {

namespace {
constexpr const char* kCameraHelp = "Camera: a ROS camera-info YAML";
}

void declareCameras(const Command& command, std::string& camera, std::string& rig) {
    const Command cameras = command.oneOf("Camera", "One camera, or several that a robot carries");
    cameras.option("--camera", camera, kCameraHelp);
    cameras.option("--rig", rig,
                   "Rig: a YAML that names cameras, their camera-info files, and where they sit");
}

void RenderOptions::declare(const Command& command, const std::string& datasetHelp, bool withRig) {
    declareWithoutCamera(command, datasetHelp);
    if (withRig) {
        declareCameras(command, m_camera, m_rig);
    } else {
        command.option("--camera", m_camera, kCameraHelp).required();
    }
    command
        .option("--sampling", m_sampling,
                "How pixels are made, cheap to exact: nearest, bilinear, reduced, footprint, bicubic; best "
                "(bicubic where the photo is magnified, else footprint); or auto")
        .among({"nearest", "bilinear", "reduced", "footprint", "bicubic", "best", "auto"})
        .showDefault();
}

void RenderOptions::declareWithoutCamera(const Command& command, const std::string& datasetHelp) {
    command.option("dataset", m_dataset, datasetHelp).required();
    command
        .option("--scene", m_scene,
                "Scene model for places between photos: none, sphere, room, depth, blend, or auto")
        .among({"none", "sphere", "room", "depth", "blend", "auto"})
        .showDefault();
    command.option("--threads", m_threads, "Threads to render with; 0: all").range(0, 1024).showDefault();
    command.flag("--no-verify", m_noVerify, "Check the hashes only of the photos that are read");
}

void declareFrame(const Command& command, std::string& frame) {
    command.option("--frame", frame, "Frame that the poses are of: optical (z forward) or body (x forward)")
        .among({"optical", "body"})
        .showDefault();
}

Rigid3 opticalPose(const Rigid3& roomFromGiven, std::string_view frame) {
    return frame == "body" ? roomFromGiven * Rigid3{bodyFromOptical(), Eigen::Vector3d::Zero()}
                           : roomFromGiven;
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
    return CameraModel(m_rig.empty() ? render::readCameraInfo(m_camera)
                                     : render::readRig(m_rig).front().camera);
}

std::vector<render::RigCamera> RenderOptions::rig() const {
    if (m_rig.empty()) {
        return {};
    }
    if (m_frame != "optical") {
        throw Error(ErrorKind::InvalidInput, "The rig's file says which axes its cameras have: leave --frame "
                                             "out, and write \"axes: body\" there.");
    }
    return render::readRig(m_rig);
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

render::ViewOptions RenderOptions::pictureOptions(const render::DatasetInfo& dataset) const {
    render::ViewOptions options = viewOptions();
    if (!options.scene && !(dataset.choice && dataset.choice->isFor(cameraModel().intrinsics()))) {
        options.scene = render::scenesOf(dataset).back();
    }
    return options;
}

void StreamOptions::declare(const Command& command) {
    command
        .option("--late", m_late,
                "What a view is made from when its photo is not decoded yet: wait for it, coarse (the "
                "thumbnail), or previous (the photo before)")
        .among({"wait", "coarse", "previous"})
        .showDefault();
    command.option("--prefetch", m_prefetchS, "Seconds of the path's motion to decode ahead; 0: none")
        .range(0.0, 10.0)
        .showDefault();
    command
        .option(
            "--passage", m_passageM,
            "Metres of the way along which a view with depth passes from one photo to the next; 0: it jumps")
        .range(0.0, 1.0)
        .showDefault();
}

render::StreamOptions StreamOptions::options() const {
    return {render::latePolicy(m_late), m_prefetchS, m_passageM};
}

} // namespace spherewalk::program
