// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace spherewalk::align {

/// What is known of a photo before its pictures are looked at.
/// Frames: positions in the room frame; a photo's own frame is its panorama frame (x forward, y left, z up).
struct PhotoPrior {
    std::string name; ///< as people call it, for sentences
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    double positionSigmaM = 0.005; ///< along x and y
    /// Of its height against the other photos': a cart keeps it far better than its place on the floor, and
    /// what is level shows by it.
    double heightSigmaM = 0.001;
    int placement = -1; ///< of the rail; -1: stands on none
    int stop = 0;       ///< along the rail
    /// Turns the photo upright, as the photo itself says; nothing if it does not say.
    std::optional<Eigen::Quaterniond> levelFromPhoto;
    Radians tiltSigma = Degrees(0.5); ///< of pitch and of roll after levelFromPhoto
};

/// One thing seen by two photos: unit vectors in each photo's frame.
struct Correspondence {
    Eigen::Vector3d inA = Eigen::Vector3d::UnitX();
    Eigen::Vector3d inB = Eigen::Vector3d::UnitX();
    double sigmaRad = 0; ///< of the angle between a bearing and what it points at, either photo
    int featureA = -1;   ///< index among a's features: the same in all of a's pairs
    int featureB = -1;
};

/// All that two photos were found to have in common; much of it may be wrong.
struct PhotoPair {
    int a = 0; ///< index among the photos, less than b
    int b = 0;
    std::vector<Correspondence> matches;
};

} // namespace spherewalk::align
