// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace spherewalk::survey {

/// How far a person walks between points of the floor, around walls and obstacles. Source: shortest paths in
/// the visibility graph of the corners that point into the floor. Threads: const functions may be called from
/// any.
class WalkingDistance {
  public:
    /// A point with its distances to the corners, so that many pairs are cheap.
    struct Place {
        Eigen::Vector2d point;
        std::vector<double>
            toCorner; ///< Length of the shortest path to each corner, in metres; infinity if there is none.
        std::vector<int> seenCorners; ///< Indices of the corners with a free line of sight.
    };

    /// Range: the room is valid.
    explicit WalkingDistance(const Room& room);
    ~WalkingDistance();
    WalkingDistance(WalkingDistance&&) noexcept;
    WalkingDistance& operator=(WalkingDistance&&) noexcept;

    Place place(const Eigen::Vector2d& point) const;
    /// The distance in metres. If one place lies in an enclosed area, it is the straight distance.
    double between(const Place& from, const Place& to) const;
    double between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  private:
    struct Graph;
    std::unique_ptr<Graph> m_graph;
};

} // namespace spherewalk::survey
