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

constexpr double kCell = 32;

/// Edges and middles of cells that together cover the pixels of a side.
std::vector<double> samplePlaces(int length) {
    std::vector<double> places;
    const double end = length - 0.5;
    for (double at = -0.5; at < end; at += kCell) {
        const double next = std::min(at + kCell, end);
        places.insert(places.end(), {at, (at + next) / 2});
    }
    places.push_back(end);
    return places;
}

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
    CellWalk(TileSet& tiles, const PhotoDirectionAt& photoDirectionAt, double reachPx)
        : m_tiles(tiles),
          m_at(photoDirectionAt),
          m_reach(reachPx * std::numbers::pi / tiles.grid().photo().height) {}

    using Seen = std::array<Vector3d, 9>;

    /// The unit direction in the photo that the view shows at this place, zero for none.
    Vector3d look(const Vector2d& place) const {
        const auto direction = m_at(place);
        return direction ? direction->normalized() : Vector3d::Zero();
    }

    void add(double x, double y, double endX, double endY) {
        Seen seen;
        const auto places = placesIn(x, y, endX, endY);
        std::transform(places.begin(), places.end(), seen.begin(),
                       [&](const Vector2d& place) { return look(place); });
        add(x, y, endX, endY, seen);
    }

    void add(double x, double y, double endX, double endY, const Seen& seen) {
        const bool isWhole =
            std::none_of(seen.begin(), seen.end(), [](const Vector3d& one) { return one.isZero(); });
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
        const Vector3d centre = look(place);
        if (centre.isZero()) {
            return;
        }
        double radius = 0;
        for (const Vector2d& aside :
             {Vector2d(-0.5, 0), Vector2d(0.5, 0), Vector2d(0, -0.5), Vector2d(0, 0.5)}) {
            const Vector3d there = look(place + aside);
            if (!there.isZero()) {
                radius = std::max(radius, angleBetween(centre, there).value());
            }
        }
        m_tiles.insertCap(centre, Radians(1.5 * radius + m_reach));
    }

  private:
    static constexpr double kMostBend = 0.15;
    static constexpr double kSmallest = 0.5;

    /// The angle between unit vectors that are so far apart.
    static double angleOf(double squaredChord) {
        return 2 * std::asin(std::min(1.0, std::sqrt(squaredChord) / 2));
    }

    static double radiusOf(const Seen& seen) {
        double chord = 0;
        for (const Vector3d& other : seen) {
            chord = std::max(chord, (seen[4] - other).squaredNorm());
        }
        return angleOf(chord);
    }

    /// How far the middles are from where a projection without bend would have them.
    static double bendOf(const Seen& seen) {
        constexpr std::array<std::array<std::size_t, 3>, 6> kLines{
            {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {0, 3, 6}, {1, 4, 7}, {2, 5, 8}}};
        double chord = 0;
        for (const auto& [from, middle, to] : kLines) {
            const Vector3d straight = seen[from] + seen[to];
            const double length = straight.norm();
            chord = std::max(chord, length < 0.1 ? 4 : (seen[middle] - straight / length).squaredNorm());
        }
        return angleOf(chord);
    }

    void addSeen(const Seen& seen, double radius) {
        for (const Vector3d& one : seen) {
            if (!one.isZero()) {
                m_tiles.insertCap(one, Radians(radius + m_reach));
            }
        }
    }

    TileSet& m_tiles;
    const PhotoDirectionAt& m_at;
    double m_reach;
};

} // namespace

ViewFootprint::ViewFootprint(const CameraModel& camera)
    : m_x(samplePlaces(camera.width())), m_y(samplePlaces(camera.height())) {
    const auto isSeen = [&](const Vector2d& place) { return camera.ray(place).has_value(); };
    for (std::size_t row = 0; row + 2 < m_y.size(); row += 2) {
        for (std::size_t column = 0; column + 2 < m_x.size(); column += 2) {
            const auto places = placesIn(m_x[column], m_y[row], m_x[column + 2], m_y[row + 2]);
            // What a lens sees is convex but for slivers, which the reach covers: nine places tell.
            if (std::all_of(places.begin(), places.end(), isSeen)) {
                m_cells.push_back({column, row});
                continue;
            }
            for (double y = m_y[row] + 0.5; y < m_y[row + 2]; ++y) {
                for (double x = m_x[column] + 0.5; x < m_x[column + 2]; ++x) {
                    if (isSeen({x, y})) {
                        m_singles.emplace_back(x, y);
                    }
                }
            }
        }
    }
}

TileSet ViewFootprint::tiles(const TileGrid& grid, const PhotoDirectionAt& photoDirectionAt,
                             double reachPx) const {
    TileSet result(grid);
    CellWalk walk(result, photoDirectionAt, reachPx);
    // Neighbouring cells share samples; each is taken once, when the first cell needs it.
    std::vector<std::optional<Vector3d>> samples(m_x.size() * m_y.size());
    for (const Cell& cell : m_cells) {
        CellWalk::Seen seen;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const std::size_t column = cell.column + i % 3;
            const std::size_t row = cell.row + i / 3;
            std::optional<Vector3d>& sample = samples[row * m_x.size() + column];
            if (!sample) {
                sample = walk.look({m_x[column], m_y[row]});
            }
            seen[i] = *sample;
        }
        walk.add(m_x[cell.column], m_y[cell.row], m_x[cell.column + 2], m_y[cell.row + 2], seen);
    }
    for (const Vector2d& single : m_singles) {
        walk.addSingle(single);
    }
    return result;
}

} // namespace spherewalk::render
