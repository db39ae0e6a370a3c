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
        std::vector<double> toCorner; ///< on the shortest path; infinity if there is none
        std::vector<int> seenCorners;
    };

    /// Range: the room is valid.
    explicit WalkingDistance(const Room& room);
    ~WalkingDistance();
    WalkingDistance(WalkingDistance&&) noexcept;
    WalkingDistance& operator=(WalkingDistance&&) noexcept;

    Place place(const Eigen::Vector2d& point) const;
    /// Metres; the straight distance where no way is found (one lies in an enclosed area).
    double between(const Place& from, const Place& to) const;
    double between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  private:
    struct Graph;
    std::unique_ptr<Graph> m_graph;
};

} // namespace spherewalk::survey
