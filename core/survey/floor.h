// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace spherewalk::survey {

/// Distances that differ by less are equal: decisions must not hang on the last bits of a coordinate at 10^6
/// m.
inline constexpr double kEqualM = 1e-7;

/// The room's floor in coordinates from its own lower left corner, so that a room at 10^6 m keeps its digits.
class Floor {
  public:
    /// Range: the room is valid.
    explicit Floor(const Room& room);

    /// The origin of the local frame, in the room frame.
    const Eigen::Vector2d& anchor() const { return m_anchor; }

    /// Width and depth of the outline's bounds, which begin at (0, 0).
    const Eigen::Vector2d& size() const { return m_size; }

    bool hasObstacles() const { return m_polygons.size() > 1; }

    /// The outline first, then the obstacles.
    const std::vector<Polygon>& polygons() const { return m_polygons; }

    /// True inside the outline and outside all obstacles.
    bool has(const Eigen::Vector2d& point) const;
    /// True if no wall and no edge of an obstacle is closer to the segment than the clearance.
    bool keepsClear(const Eigen::Vector2d& begin, const Eigen::Vector2d& end, double clearanceM) const;
    /// True if no wall and no edge of an obstacle meets the segment.
    bool sees(const Eigen::Vector2d& begin, const Eigen::Vector2d& end) const;

  private:
    struct Edge {
        Polygon ends; ///< The edge as a polygon of its two corners.
        Eigen::Array2d least;
        Eigen::Array2d greatest;
    };

    Eigen::Vector2d m_anchor;
    Eigen::Vector2d m_size;
    std::vector<Polygon> m_polygons;
    std::vector<Edge> m_edges;
};

/// The floor as cells of equal size, row by row from the lower left.
class FloorRaster {
  public:
    static constexpr double kMostCells = 2e6;

    /// Cells are a tenth of the step wide, or as small as kMostCells allows.
    FloorRaster(const Floor& floor, double stepM);

    int columns() const { return m_columns; }

    int rows() const { return m_rows; }

    int cells() const { return m_columns * m_rows; }

    const Eigen::Vector2d& cellSize() const { return m_cellSize; }

    double cellArea() const { return m_cellSize.prod(); }

    Eigen::Vector2d centre(int cell) const;
    /// Range: the point is within the floor's bounds.
    int cellAt(const Eigen::Vector2d& point) const;

    bool isFloor(int cell) const { return m_isFloor[static_cast<std::size_t>(cell)] != 0; }

    double floorArea() const;

  private:
    void fill(const Polygon& polygon, std::uint8_t value);

    int m_columns = 0;
    int m_rows = 0;
    Eigen::Vector2d m_cellSize;
    std::vector<std::uint8_t> m_isFloor;
};

/// Connected groups of cells that have the same key: per cell the number of its group, from 0, in the order
/// of their first cells; -1 where the key is negative. Cells that touch at a corner are connected.
struct CellGroups {
    std::vector<int> groupOf;
    std::vector<int> sizes; ///< Number of cells in each group.
};

CellGroups connectedCells(const FloorRaster& raster, const std::vector<int>& keys);

/// True per cell that obstacles cut off from the largest connected part of the floor; empty if none is.
std::vector<bool> enclosedCells(const Floor& floor, const FloorRaster& raster, double stepM);

} // namespace spherewalk::survey
