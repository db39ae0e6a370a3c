// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::practice {

/// What really happened at one exposure of the practice camera, for tests to compare with.
struct Truth {
    std::string file;    ///< name on the camera, R0010001.JPG
    std::string urlPath; ///< of its URL, /files/.../R0010001.JPG
    int shot = 0;        ///< counted from 1 over the life of the storage
    Eigen::Vector3d nominalPositionM = Eigen::Vector3d::Zero(); ///< where the operator put the cart
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();        ///< where the lens really was
    std::optional<Eigen::Quaterniond> roomFromPhoto; ///< nothing for photos served from a folder without it
    std::string time;                                ///< of the trigger, ISO 8601, UTC
    std::string sha256;
    Json options = Json::object(); ///< of the exposure, as the camera spells them: exposureProgram, iso, ...
    bool byButton = false;         ///< nobody asked for it over the network
};

/// A JSON lines file to which exposures are added durably, one object each.
class TruthFile {
  public:
    explicit TruthFile(std::filesystem::path file);

    /// Returns when the line is on the disk. Errors: Io, Full.
    void append(const Truth& truth) const;

  private:
    std::filesystem::path m_file;
};

/// All exposures of a truth file; a last line that was cut short by a crash is left out. Errors: NotFound,
/// Io, Corrupt.
std::vector<Truth> readTruth(const std::filesystem::path& file);

} // namespace spherewalk::practice
