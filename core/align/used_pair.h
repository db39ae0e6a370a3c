// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <vector>

namespace spherewalk::align {

/// Where a photo is taken to be. Frames: the room's axes, the origin near the photos, so that doubles keep
/// their digits.
struct PhotoState {
    Eigen::Quaterniond roomFromPhoto = Eigen::Quaterniond::Identity();
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
};

/// A match that the solution is made with.
struct UsedMatch {
    Eigen::Vector3d inA;
    Eigen::Vector3d inB;
    double sigmaRad = 0;
    int match = 0; ///< index among the pair's
    int track = 0; ///< of the features that are one thing, over all photos
};

/// A pair with the matches that it is solved with.
struct UsedPair {
    int pair = 0; ///< index among the given ones
    int a = 0;
    int b = 0;
    bool isTurn = false;     ///< too near to each other for a direction: the turn alone is asked
    double toleranceRad = 0; ///< of a turn, for the parallax that it does not know
    std::vector<UsedMatch> matches;
};

} // namespace spherewalk::align
