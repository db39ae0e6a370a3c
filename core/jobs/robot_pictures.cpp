// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/robot_pictures.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/photo/picture_file.h"

namespace spherewalk::jobs {

std::vector<RobotPicture> readRobotPictures(const std::filesystem::path& csv) {
    std::vector<RobotPicture> pictures;
    for (const PhotoPosition& line : readPositions(csv)) {
        if (!line.roomFromPhoto) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not use the robot's pictures ", csv.string(), ": line ", line.line,
                             " states no rotation; give qw,qx,qy,qz of the optical frame."));
        }
        RobotPicture picture;
        picture.file = csv.parent_path() / line.file;
        picture.depthFile = line.depthFile.empty() ? "" : csv.parent_path() / line.depthFile;
        picture.roomFromCamera = {*line.roomFromPhoto, line.positionM};
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

RgbImage readRobotPicture(const RobotPicture& picture, const CameraModel& camera) {
    RgbImage result = photo::readPicture(picture.file);
    if (result.width() != camera.width() || result.height() != camera.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The picture ", picture.file.string(), " has ", result.width(), " x ",
                         result.height(), " pixels, not the camera's ", camera.width(), " x ",
                         camera.height(), "."));
    }
    return result;
}

} // namespace spherewalk::jobs
