// SPDX-License-Identifier: GPL-3.0-or-later
#include "dataset_options.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/camera_info.h"

namespace spherewalk::cli {

void DatasetOptions::declare(CLI::App& command) {
    command.add_option("dataset", m_dataset, "Folder of the dataset")->required();
    command.add_option("--camera", m_camera, "Camera: a ROS camera-info YAML")->required();
    command
        .add_option("--frame", m_frame,
                    "Frame that the poses are of: optical (z forward) or body (x forward)")
        ->check(CLI::IsMember({"optical", "body"}))
        ->capture_default_str();
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

render::Renderer DatasetOptions::renderer(Context& context, const std::filesystem::path& dataset) const {
    const render::Verify verify = m_noVerify ? render::Verify::Sizes : render::Verify::Hashes;
    render::RendererOptions options;
    options.verify = m_noVerify ? render::VerifyPhotos::BeforeUse : render::VerifyPhotos::AtOpen;
    return render::Renderer(std::make_shared<const render::Dataset>(
                                render::Dataset::open(dataset, verify, context.progress, context.stop)),
                            options);
}

CameraModel DatasetOptions::cameraModel() const {
    return CameraModel(render::readCameraInfo(m_camera));
}

render::ViewOptions DatasetOptions::viewOptions() const {
    render::ViewOptions options;
    if (m_scene != "auto") {
        options.scene = render::sceneKind(m_scene);
    }
    options.sampling = render::sampling(m_sampling);
    options.threads = m_threads;
    return options;
}

std::vector<jobs::RobotPicture> DatasetOptions::robotPictures(const std::filesystem::path& csv) const {
    std::vector<jobs::RobotPicture> pictures = jobs::readRobotPictures(csv);
    for (jobs::RobotPicture& picture : pictures) {
        picture.roomFromCamera = opticalPose(picture.roomFromCamera);
    }
    return pictures;
}

Rigid3 DatasetOptions::opticalPose(const Rigid3& roomFromGiven) const {
    return m_frame == "body" ? roomFromGiven * Rigid3{bodyFromOptical(), Eigen::Vector3d::Zero()}
                             : roomFromGiven;
}

} // namespace spherewalk::cli
