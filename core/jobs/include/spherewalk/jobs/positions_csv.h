// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk {
class CameraModel;
}

namespace spherewalk::jobs {

/// One line of a positions file: where a photo was taken.
struct PhotoPosition {
    std::string file; ///< Relative to the photos' folder.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::optional<Eigen::Quaterniond> roomFromPhoto; ///< From qw,qx,qy,qz, or from yaw_deg alone.
    std::string depthFile; ///< Relative to the photos' folder; empty if the line names none.
    bool isPlaced = true;  ///< False for a line without a place, where lines may lack it.
    int line = 0;          ///< Line number in the file, counted from 1.
};

/// Reads a CSV file (RFC 4180, with a header line). The columns file, x_m, y_m and z_m are needed. The
/// columns depth, and yaw_deg or qw, qx, qy, qz (roomFromPhoto), may be there too. Columns may stand in any
/// order, and others are ignored. A line may leave its rotation empty.
///
/// Errors: InvalidInput, which names the source and the line or the missing column. Files that are listed
/// twice, and names that lead out of the photos' folder, are refused. mayLackPlaces: the three columns may be
/// missing, and a line may leave them all empty.
std::vector<PhotoPosition> parsePositions(std::string_view csv, const std::string& source,
                                          bool mayLackPlaces = false);

/// Errors: those of parsePositions() and of reading the file.
std::vector<PhotoPosition> readPositions(const std::filesystem::path& file, bool mayLackPlaces = false);

/// A picture of the robot's own camera, which views are compared with.
struct RobotPicture {
    std::filesystem::path file;
    std::filesystem::path depthFile; ///< PNG of 16 bits, millimetres along the axis; empty if not known.
    Rigid3 roomFromCamera;           ///< Pose of the optical frame.
    bool hasPose = true;             ///< False if nobody stated the pose; roomFromCamera means nothing then.
};

/// Reads a positions file in which each line has a rotation. Files are relative to the positions file.
/// mayLackPoses: lines may have neither place nor rotation. Errors: those of readPositions(); InvalidInput
/// for any other line without a rotation.
std::vector<RobotPicture> readRobotPictures(const std::filesystem::path& csv, bool mayLackPoses = false);

/// Errors: those of reading the picture; InvalidInput if its size is not the camera's.
RgbImage readRobotPicture(const RobotPicture& picture, const CameraModel& camera);

} // namespace spherewalk::jobs
