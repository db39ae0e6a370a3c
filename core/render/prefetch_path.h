// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tile_grid.h"
#include "tile_store.h"

#include "spherewalk/geometry/rigid3.h"

#include <functional>
#include <stop_token>
#include <vector>

namespace spherewalk::render {

/// How a camera moves. Frames: room. Units: m/s; rad/s about the vector's direction.
struct CameraMotion {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d turnRate = Eigen::Vector3d::Zero();
};

/// The motion that takes one pose to the other in this time. Range: seconds > 0; nothing is assumed to move
/// for other times, or for a jump too fast for a robot (1000 m/s), which is a new start.
CameraMotion motionBetween(const Rigid3& from, const Rigid3& to, double seconds);

/// Where the camera is after this time, velocity and turn rate staying as they are.
Rigid3 predicted(const Rigid3& roomFromCamera, const CameraMotion& motion, double seconds);

/// Tiles of a photo that some view needs.
struct TileNeed {
    PhotoLevel level;
    TileSet tiles;
};

struct PrefetchOptions {
    double horizonSeconds = 0.5;
    double stepSeconds = 1.0 / 30; ///< time between views
    int mostTiles = 4000;          ///< the plan ends before it has more
};

/// The photo and the tiles of it that a view from this pose needs, and some pixels beyond: paths bend, and a
/// view whose edge has just entered a tile that was not foreseen is late. (In the bench's walk, whose turn
/// rate changes by 0.25 rad/s^2, no reach made one view in ninety late, and 24 pixels none.)
using NeedOfView = std::function<TileNeed(const Rigid3& roomFromCamera)>;

/// What the views on the predicted path will need, soonest first; each photo stands once, where it is first
/// needed, with all of its tiles. The same input gives the same plan. Stop: ends it early.
std::vector<TileNeed> prefetchPlan(const Rigid3& roomFromCamera, const CameraMotion& motion,
                                   const PrefetchOptions& options, const std::stop_token& stop,
                                   const NeedOfView& needOfView);

} // namespace spherewalk::render
