// SPDX-License-Identifier: GPL-3.0-or-later
#include "floor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherewalk::survey {

using Eigen::Array2d;
using Eigen::Vector2d;

Floor::Floor(const Room& room) {
    const Bounds2 extent = bounds(room.outline);
    m_anchor = extent.least;
    m_size = extent.greatest - extent.least;
    m_polygons.push_back(room.outline);
    m_polygons.insert(m_polygons.end(), room.obstacles.begin(), room.obstacles.end());
    for (Polygon& polygon : m_polygons) {
        for (Vector2d& corner : polygon) {
            corner -= m_anchor;
        }
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector2d& a = polygon[i];
            const Vector2d& b = polygon[(i + 1) % polygon.size()];
            m_edges.push_back({{a, b}, a.array().min(b.array()), a.array().max(b.array())});
        }
    }
}

bool Floor::has(const Vector2d& point) const {
    return contains(m_polygons.front(), point) &&
           std::none_of(m_polygons.begin() + 1, m_polygons.end(),
                        [&](const Polygon& obstacle) { return contains(obstacle, point); });
}

bool Floor::keepsClear(const Vector2d& begin, const Vector2d& end, double clearanceM) const {
    const double least = clearanceM - kEqualM;
    const Array2d from = begin.array().min(end.array()) - clearanceM;
    const Array2d to = begin.array().max(end.array()) + clearanceM;
    return std::none_of(m_edges.begin(), m_edges.end(), [&](const Edge& edge) {
        return (edge.least <= to).all() && (edge.greatest >= from).all() &&
               distanceToEdge(edge.ends, begin, end) < least;
    });
}

bool Floor::sees(const Vector2d& begin, const Vector2d& end) const {
    const Array2d from = begin.array().min(end.array());
    const Array2d to = begin.array().max(end.array());
    return std::none_of(m_edges.begin(), m_edges.end(), [&](const Edge& edge) {
        return (edge.least <= to).all() && (edge.greatest >= from).all() &&
               distanceToEdge(edge.ends, begin, end) == 0;
    });
}

FloorRaster::FloorRaster(const Floor& floor, double stepM) {
    const Vector2d& size = floor.size();
    // Leaves room for rounding the counts up on both axes, however thin the room.
    const double finest =
        std::max(std::sqrt(size.prod() / (kMostCells / 2)), size.maxCoeff() / (kMostCells / 4));
    const double cell = std::max(stepM / 10, finest);
    m_columns = std::max(1, static_cast<int>(std::ceil(size.x() / cell)));
    m_rows = std::max(1, static_cast<int>(std::ceil(size.y() / cell)));
    m_cellSize = {size.x() / m_columns, size.y() / m_rows};
    m_isFloor.assign(static_cast<std::size_t>(cells()), 0);
    fill(floor.polygons().front(), 1);
    for (std::size_t i = 1; i < floor.polygons().size(); ++i) {
        fill(floor.polygons()[i], 0);
    }
}

Vector2d FloorRaster::centre(int cell) const {
    const int row = cell / m_columns;
    const int column = cell % m_columns;
    return {(column + 0.5) * m_cellSize.x(), (row + 0.5) * m_cellSize.y()};
}

int FloorRaster::cellAt(const Vector2d& point) const {
    const int column = std::clamp(static_cast<int>(point.x() / m_cellSize.x()), 0, m_columns - 1);
    const int row = std::clamp(static_cast<int>(point.y() / m_cellSize.y()), 0, m_rows - 1);
    return row * m_columns + column;
}

double FloorRaster::floorArea() const {
    return cellArea() * static_cast<double>(std::count(m_isFloor.begin(), m_isFloor.end(), 1));
}

void FloorRaster::fill(const Polygon& polygon, std::uint8_t value) {
    std::vector<double> crossings;
    for (int row = 0; row < m_rows; ++row) {
        const double y = (row + 0.5) * m_cellSize.y();
        crossings.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector2d& a = polygon[i];
            const Vector2d& b = polygon[(i + 1) % polygon.size()];
            if ((a.y() > y) != (b.y() > y)) {
                crossings.push_back(a.x() + (b.x() - a.x()) * ((y - a.y()) / (b.y() - a.y())));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const auto column = [&](double x) {
                return static_cast<int>(
                    std::clamp(std::ceil(x / m_cellSize.x() - 0.5), 0.0, double(m_columns)));
            };
            std::fill(m_isFloor.begin() + row * m_columns + column(crossings[i]),
                      m_isFloor.begin() + row * m_columns + column(crossings[i + 1]), value);
        }
    }
}

CellGroups connectedCells(const FloorRaster& raster, const std::vector<int>& keys) {
    CellGroups groups{std::vector<int>(keys.size(), -1), {}};
    std::vector<int> pending;
    const auto visit = [&](int cell, int key) {
        const auto at = static_cast<std::size_t>(cell);
        if (keys[at] == key && groups.groupOf[at] < 0) {
            groups.groupOf[at] = static_cast<int>(groups.sizes.size()) - 1;
            ++groups.sizes.back();
            pending.push_back(cell);
        }
    };
    for (int first = 0; first < raster.cells(); ++first) {
        const int key = keys[static_cast<std::size_t>(first)];
        if (key < 0 || groups.groupOf[static_cast<std::size_t>(first)] >= 0) {
            continue;
        }
        groups.sizes.push_back(0);
        visit(first, key);
        while (!pending.empty()) {
            const int cell = pending.back();
            pending.pop_back();
            const int column = cell % raster.columns();
            const int row = cell / raster.columns();
            for (int r = std::max(0, row - 1); r <= std::min(raster.rows() - 1, row + 1); ++r) {
                for (int c = std::max(0, column - 1); c <= std::min(raster.columns() - 1, column + 1); ++c) {
                    visit(r * raster.columns() + c, key);
                }
            }
        }
    }
    return groups;
}

std::vector<bool> enclosedCells(const Floor& floor, const FloorRaster& raster, double stepM) {
    // Without obstacles the floor is one piece; on a coarse raster a narrow passage would look closed.
    if (!floor.hasObstacles() || raster.cellSize().maxCoeff() > stepM / 2) {
        return {};
    }
    std::vector<int> keys(static_cast<std::size_t>(raster.cells()));
    for (int cell = 0; cell < raster.cells(); ++cell) {
        keys[static_cast<std::size_t>(cell)] = raster.isFloor(cell) ? 0 : -1;
    }
    const CellGroups parts = connectedCells(raster, keys);
    if (parts.sizes.size() < 2) {
        return {};
    }
    const auto largest =
        static_cast<int>(std::max_element(parts.sizes.begin(), parts.sizes.end()) - parts.sizes.begin());
    std::vector<bool> enclosed(keys.size());
    for (std::size_t cell = 0; cell < keys.size(); ++cell) {
        enclosed[cell] = parts.groupOf[cell] >= 0 && parts.groupOf[cell] != largest;
    }
    return enclosed;
}

} // namespace spherewalk::survey
