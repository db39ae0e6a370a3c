// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::practice {

/// What really happened at one exposure of the practice camera; tests compare results with it.
struct Truth {
    std::string file;    ///< Name on the camera, R0010001.JPG.
    std::string urlPath; ///< Path of the file's URL, /files/.../R0010001.JPG.
    int shot = 0;        ///< Number of the shot, counted from 1 over the life of the storage.
    Eigen::Vector3d nominalPositionM = Eigen::Vector3d::Zero(); ///< Place of the cart, room frame.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();        ///< True place of the lens, room frame.
    std::optional<Eigen::Quaterniond>
        roomFromPhoto; ///< Nothing for given photos whose rotation is not known.
    std::string time;  ///< Time of the trigger, ISO 8601, UTC.
    std::string sha256;
    Json options =
        Json::object();    ///< Options of the exposure in the camera's spelling: exposureProgram, iso, ...
    bool byButton = false; ///< Somebody pressed the button; no request asked for the picture.
};

/// A JSON lines file with one object an exposure.
class TruthFile {
  public:
    explicit TruthFile(std::filesystem::path file);

    /// Appends a line, and returns when it is on the disk. Errors: Io, Full.
    void append(const Truth& truth) const;

  private:
    std::filesystem::path m_file;
};

/// All exposures of a truth file. A last line that a crash cut short is dropped. Errors: NotFound,
/// Io, Corrupt.
std::vector<Truth> readTruth(const std::filesystem::path& file);

} // namespace spherewalk::practice
