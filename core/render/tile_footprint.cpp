// SPDX-License-Identifier: Apache-2.0
#include "tile_footprint.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Corners, middles of the sides, and centre, row after row.
std::array<Vector2d, 9> placesIn(double x, double y, double endX, double endY) {
    std::array<Vector2d, 9> places;
    for (std::size_t i = 0; i < 9; ++i) {
        places[i] = {x + static_cast<double>(i % 3) * (endX - x) / 2,
                     y + static_cast<double>(i / 3) * (endY - y) / 2};
    }
    return places;
}

/// Adds the tiles of cells of a view, dividing those in which the projection bends.
class CellWalk {
  public:
    CellWalk(TileSet& tiles, const PhotoPixelAt& photoPixelAt, double reachPx)
        : m_tiles(tiles),
          m_at(photoPixelAt),
          m_reach(reachPx * std::numbers::pi / tiles.grid().photo().height) {}

    void add(double x, double y, double endX, double endY) {
        std::array<Vector3d, 9> seen;
        std::size_t i = 0;
        bool isWhole = true;
        for (const Vector2d& place : placesIn(x, y, endX, endY)) {
            const auto pixel = m_at(place);
            isWhole = isWhole && pixel.has_value();
            seen[i++] = pixel ? direction(m_tiles.grid().photo(), *pixel) : Vector3d::Zero();
        }
        const double bend = isWhole ? bendOf(seen) : 0;
        const double radius = isWhole ? radiusOf(seen) : 0;
        if (isWhole && bend <= kMostBend * radius) {
            m_tiles.insertCap(seen[4], Radians(radius + 2 * bend + m_reach));
        } else if (endX - x > kSmallest || endY - y > kSmallest) {
            const double middleX = (x + endX) / 2;
            const double middleY = (y + endY) / 2;
            add(x, y, middleX, middleY);
            add(middleX, y, endX, middleY);
            add(x, middleY, middleX, endY);
            add(middleX, middleY, endX, endY);
        } else {
            addSeen(seen, isWhole ? radius : 0);
        }
    }

    /// A pixel beside which the lens may see nothing.
    void addSingle(const Vector2d& place) {
        const auto pixel = m_at(place);
        if (!pixel) {
            return;
        }
        const Vector3d centre = direction(m_tiles.grid().photo(), *pixel);
        double radius = 0;
        for (const Vector2d& aside :
             {Vector2d(-0.5, 0), Vector2d(0.5, 0), Vector2d(0, -0.5), Vector2d(0, 0.5)}) {
            if (const auto other = m_at(place + aside)) {
                const Vector3d there = direction(m_tiles.grid().photo(), *other);
                radius = std::max(radius, angleBetween(centre, there).value());
            }
        }
        m_tiles.insertCap(centre, Radians(1.5 * radius + m_reach));
    }

  private:
    static constexpr double kMostBend = 0.15;
    static constexpr double kSmallest = 0.5;

    static double radiusOf(const std::array<Vector3d, 9>& seen) {
        double radius = 0;
        for (const Vector3d& other : seen) {
            radius = std::max(radius, angleBetween(seen[4], other).value());
        }
        return radius;
    }

    /// How far the middles are from where a projection without bend would have them.
    static double bendOf(const std::array<Vector3d, 9>& seen) {
        constexpr std::array<std::array<std::size_t, 3>, 6> kLines{
            {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {0, 3, 6}, {1, 4, 7}, {2, 5, 8}}};
        double bend = 0;
        for (const auto& [from, middle, to] : kLines) {
            const Vector3d straight = seen[from] + seen[to];
            bend = std::max(bend, straight.norm() < 0.1 ? std::numbers::pi
                                                        : angleBetween(seen[middle], straight).value());
        }
        return bend;
    }

    void addSeen(const std::array<Vector3d, 9>& seen, double radius) {
        for (const Vector3d& one : seen) {
            if (!one.isZero()) {
                m_tiles.insertCap(one, Radians(radius + m_reach));
            }
        }
    }

    TileSet& m_tiles;
    const PhotoPixelAt& m_at;
    double m_reach;
};

} // namespace

ViewFootprint::ViewFootprint(const CameraModel& camera) {
    const double right = camera.width() - 0.5;
    const double lower = camera.height() - 0.5;
    for (double y = -0.5; y < lower; y += kCell) {
        for (double x = -0.5; x < right; x += kCell) {
            const Cell cell{x, y, std::min(x + kCell, right), std::min(y + kCell, lower)};
            const auto places = placesIn(cell.x, cell.y, cell.endX, cell.endY);
            const auto isSeen = [&](const Vector2d& place) { return camera.ray(place).has_value(); };
            // What a lens sees is convex but for slivers, which the reach covers: nine places tell.
            if (std::all_of(places.begin(), places.end(), isSeen)) {
                m_cells.push_back(cell);
                continue;
            }
            for (double py = cell.y + 0.5; py < cell.endY; ++py) {
                for (double px = cell.x + 0.5; px < cell.endX; ++px) {
                    if (isSeen({px, py})) {
                        m_singles.emplace_back(px, py);
                    }
                }
            }
        }
    }
}

TileSet ViewFootprint::tiles(const TileGrid& grid, const PhotoPixelAt& photoPixelAt, double reachPx) const {
    TileSet result(grid);
    CellWalk walk(result, photoPixelAt, reachPx);
    for (const Cell& cell : m_cells) {
        walk.add(cell.x, cell.y, cell.endX, cell.endY);
    }
    for (const Vector2d& single : m_singles) {
        walk.addSingle(single);
    }
    return result;
}

} // namespace spherewalk::render
