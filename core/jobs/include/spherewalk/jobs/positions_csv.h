// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// One line of a positions file: where a photo was taken.
struct PhotoPosition {
    std::string file; ///< relative to the photos' folder
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::optional<Eigen::Quaterniond> roomFromPhoto; ///< from qw,qx,qy,qz, or from yaw_deg alone
    std::string depthFile; ///< of the distances that it shows, likewise; "" if there is none
    int line = 0;          ///< in the file, from 1
};

/// Reads a CSV (RFC 4180, with a header line) with the columns file, x_m, y_m, z_m and optionally depth, and
/// yaw_deg or qw, qx, qy, qz (roomFromPhoto). The columns may stand in any order; others are ignored. A
/// rotation may be left empty in some lines. Errors: InvalidInput, naming the file and the line or the
/// missing column; a file that is listed twice; a name that leads out of the photos' folder.
std::vector<PhotoPosition> parsePositions(std::string_view csv, const std::string& source);

std::vector<PhotoPosition> readPositions(const std::filesystem::path& file);

} // namespace spherewalk::jobs
