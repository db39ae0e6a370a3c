// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/align/position_check.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace spherewalk::align {

/// The planned positions in the order in which a cart reaches them: one line a rail and height.
class PlannedLines {
  public:
    explicit PlannedLines(std::span<const PlannedPosition> planned);

    /// Indices among the planned positions, one list a line, by stop.
    const std::vector<std::vector<int>>& lines() const { return m_lines; }

    struct Place {
        int line = -1; ///< -1: on none
        int index = 0; ///< along it
    };

    Place place(int planned) const;

    /// The planned position that a photo is tagged with, by its position; of several there the one with its
    /// rail and stop. -1: none lies within 2 cm.
    int tag(const PhotoPrior& photo) const;

    const PlannedPosition& operator[](int planned) const {
        return m_planned[static_cast<std::size_t>(planned)];
    }

    int size() const { return static_cast<int>(m_planned.size()); }

    /// Where the line's index-th position is, or, one beyond either end, would be. Range of index:
    /// [-1, size of the line]; beyond an end the line has at least two positions.
    Eigen::Vector3d positionM(int line, int index) const;

  private:
    std::vector<PlannedPosition> m_planned;
    std::vector<std::vector<int>> m_lines;
    std::vector<Place> m_places;
};

} // namespace spherewalk::align
