// SPDX-License-Identifier: GPL-3.0-or-later
#include "dataset_options.h"

#include "spherewalk/geometry/rotation.h"

namespace spherewalk::cli {

void DatasetOptions::declare(CLI::App& command) {
    m_render.declare(command);
    command
        .add_option("--frame", m_frame,
                    "Frame that the poses are of: optical (z forward) or body (x forward)")
        ->check(CLI::IsMember({"optical", "body"}))
        ->capture_default_str();
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
