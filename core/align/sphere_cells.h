// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace spherewalk::align {

/// The sphere of directions, cut into rows of cells of about equal size.
class SphereCells {
  public:
    explicit SphereCells(double cellRad);

    int size() const { return static_cast<int>(m_centres.size()); }

    /// The cell that holds the direction. Range: unit, finite.
    int cell(const Eigen::Vector3d& direction) const;

    const Eigen::Vector3d& centre(int cell) const { return m_centres[static_cast<std::size_t>(cell)]; }

    /// For each cell the cells whose centres lie within the angle of its own.
    std::vector<std::vector<int>> discs(double radiusRad) const;

  private:
    std::vector<int> m_firstOfRow; ///< and the number of cells at the end
    std::vector<Eigen::Vector3d> m_centres;
};

} // namespace spherewalk::align
