// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere_cells.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

SphereCells::SphereCells(double cellRad) {
    const int rows = std::max(1, static_cast<int>(std::lround(EIGEN_PI / cellRad)));
    for (int row = 0; row < rows; ++row) {
        const double elevation = EIGEN_PI * ((row + 0.5) / rows - 0.5);
        const int columns =
            std::max(1, static_cast<int>(std::lround(2 * EIGEN_PI * std::cos(elevation) / cellRad)));
        m_firstOfRow.push_back(size());
        for (int column = 0; column < columns; ++column) {
            const double azimuth = 2 * EIGEN_PI * (column + 0.5) / columns - EIGEN_PI;
            m_centres.emplace_back(std::cos(elevation) * std::cos(azimuth),
                                   std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        }
    }
    m_firstOfRow.push_back(size());
}

int SphereCells::cell(const Eigen::Vector3d& direction) const {
    const int rows = static_cast<int>(m_firstOfRow.size()) - 1;
    const double elevation = std::asin(std::clamp(direction.z(), -1., 1.));
    const double azimuth = std::atan2(direction.y(), direction.x());
    const auto row = static_cast<std::size_t>(
        std::clamp(static_cast<int>((elevation / EIGEN_PI + 0.5) * rows), 0, rows - 1));
    const int columns = m_firstOfRow[row + 1] - m_firstOfRow[row];
    const int column = static_cast<int>((azimuth / (2 * EIGEN_PI) + 0.5) * columns);
    return m_firstOfRow[row] + std::clamp(column, 0, columns - 1);
}

std::vector<std::vector<int>> SphereCells::discs(double radiusRad) const {
    const double least = std::cos(radiusRad);
    std::vector<std::vector<int>> discs(m_centres.size());
    for (int i = 0; i < size(); ++i) {
        for (int j = 0; j < size(); ++j) {
            if (centre(i).dot(centre(j)) >= least) {
                discs[static_cast<std::size_t>(i)].push_back(j);
            }
        }
    }
    return discs;
}

} // namespace spherewalk::align
