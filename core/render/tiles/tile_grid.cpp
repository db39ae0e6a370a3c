// SPDX-License-Identifier: Apache-2.0
#include "tiles/tile_grid.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

int divideUp(int whole, int part) {
    return (whole + part - 1) / part;
}

int wrapped(int x, int width) {
    const int rest = x % width;
    return rest < 0 ? rest + width : rest;
}

/// Decoding a block costs about this many tile rows more than its tiles: a row of MCUs above and below.
constexpr double kMarginRows = 0.5;

} // namespace

TileGrid::TileGrid(const EquirectSize& photo)
    : m_photo(photo),
      m_columns(divideUp(photo.width, kTileWidth)),
      m_rows(divideUp(photo.height, kTileHeight)) {
}

jpeg::PixelRect TileGrid::pixels(int column, int row, int endColumn, int endRow) const {
    const int x = column * kTileWidth;
    const int y = row * kTileHeight;
    return {x, y, std::min(endColumn * kTileWidth, m_photo.width) - x,
            std::min(endRow * kTileHeight, m_photo.height) - y};
}

jpeg::PixelRect TileGrid::pixels(int tile) const {
    const int column = tile % m_columns;
    const int row = tile / m_columns;
    return pixels(column, row, column + 1, row + 1);
}

TileSet::TileSet(const TileGrid& grid) : m_grid(grid), m_tiles(static_cast<std::size_t>(grid.count())) {
}

TileSet TileSet::all(const TileGrid& grid) {
    TileSet set(grid);
    std::fill(set.m_tiles.begin(), set.m_tiles.end(), std::uint8_t{1});
    return set;
}

int TileSet::count() const {
    return static_cast<int>(std::count(m_tiles.begin(), m_tiles.end(), 1));
}

void TileSet::insertBox(double left, double top, double right, double bottom) {
    const auto [width, height] = m_grid.photo();
    if (!(right >= left) || !(bottom >= -1) || !(top <= height)) {
        return;
    }
    const int firstY = static_cast<int>(std::max(0.0, std::floor(top)));
    const int lastY = static_cast<int>(std::min(height - 1.0, std::ceil(bottom)));
    const bool isAllRound = !(right - left < width - 2);
    const bool isWithin = left >= 0 && left < width;
    const int firstX = isAllRound ? 0
                       : isWithin ? static_cast<int>(left)
                                  : wrapped(static_cast<int>(std::floor(std::fmod(left, width))), width);
    const int lastX = isAllRound ? width - 1 : firstX + static_cast<int>(std::ceil(right - left)) + 1;
    for (int row = firstY / TileGrid::kTileHeight; row <= lastY / TileGrid::kTileHeight; ++row) {
        for (int x = firstX; x <= lastX;) {
            const int inPhoto = wrapped(x, width);
            insert(row * m_grid.columns() + inPhoto / TileGrid::kTileWidth);
            const int tileEnd = (inPhoto / TileGrid::kTileWidth + 1) * TileGrid::kTileWidth;
            x += std::min(tileEnd, width) - inPhoto;
        }
    }
}

void TileSet::insertCap(const Vector3d& direction, Radians radius) {
    constexpr double kPi = std::numbers::pi;
    const auto [width, height] = m_grid.photo();
    const SphericalDirection centre = sphericalDirection(direction);
    const double elevation = centre.elevation.value();
    const double reach = radius.value();
    const auto rowAt = [&, h = height](double angle) { return (kPi / 2 - angle) / kPi * h - 0.5; };
    const double top = rowAt(elevation + reach);
    const double bottom = rowAt(elevation - reach);
    // A pixel of the outermost row is interpolated across the pole.
    const double pole = kPi / 2 - kPi / height;
    if (!(std::abs(elevation) + reach < pole)) {
        insertBox(0, top, width, bottom);
        return;
    }
    // Where the circle about the direction touches a meridian.
    const double halfAzimuth = std::asin(std::min(1.0, std::sin(reach) / std::cos(elevation)));
    const double pixelsPerRadian = width / (2 * kPi);
    const double middle = (kPi - centre.azimuth.value()) * pixelsPerRadian - 0.5;
    insertBox(middle - halfAzimuth * pixelsPerRadian, top, middle + halfAzimuth * pixelsPerRadian, bottom);
}

void TileSet::merge(const TileSet& other) {
    for (std::size_t i = 0; i < m_tiles.size(); ++i) {
        m_tiles[i] |= other.m_tiles[i];
    }
}

TileSet TileSet::grown() const {
    TileSet result = *this;
    forEach([&](int tile) {
        const int column = tile % m_grid.columns();
        const int row = tile / m_grid.columns();
        for (int y = std::max(0, row - 1); y <= std::min(m_grid.rows() - 1, row + 1); ++y) {
            for (int x = column - 1; x <= column + 1; ++x) {
                result.insert(y * m_grid.columns() + wrapped(x, m_grid.columns()));
            }
        }
    });
    return result;
}

void TileSet::forEach(const std::function<void(int)>& call) const {
    for (std::size_t i = 0; i < m_tiles.size(); ++i) {
        if (m_tiles[i] != 0) {
            call(static_cast<int>(i));
        }
    }
}

namespace {

/// Gathers blocks from the top down. No tile is in two of them: blocks are decoded side by side.
class BlockMaker {
  public:
    BlockMaker(const TileSet& tiles, int maxRows)
        : m_columns(tiles.grid().columns()),
          m_maxRows(maxRows),
          m_owner(static_cast<std::size_t>(tiles.grid().count()), -1) {}

    bool isTaken(int column, int row) const { return owner(column, row) >= 0; }

    void add(int first, int end, int row) {
        for (int i = static_cast<int>(m_blocks.size()) - 1; i >= 0; --i) {
            const TileBlock& block = m_blocks[static_cast<std::size_t>(i)];
            const TileBlock grown{std::min(block.column, first), block.row, std::max(block.endColumn, end),
                                  row + 1};
            if (block.endRow == row && isWorthwhile(block, grown, end - first) && isFree(grown, i)) {
                take(grown, i);
                return;
            }
        }
        m_blocks.emplace_back();
        take({first, row, end, row + 1}, static_cast<int>(m_blocks.size()) - 1);
    }

    std::vector<TileBlock> blocks() && { return std::move(m_blocks); }

  private:
    static int area(const TileBlock& block) {
        return (block.endColumn - block.column) * (block.endRow - block.row);
    }

    bool isWorthwhile(const TileBlock& block, const TileBlock& grown, int added) const {
        const int waste = area(grown) - area(block) - added;
        return grown.endRow - grown.row <= m_maxRows && waste <= kMarginRows * added + 1;
    }

    bool isFree(const TileBlock& block, int self) const {
        for (int row = block.row; row < block.endRow; ++row) {
            for (int column = block.column; column < block.endColumn; ++column) {
                if (owner(column, row) >= 0 && owner(column, row) != self) {
                    return false;
                }
            }
        }
        return true;
    }

    void take(const TileBlock& block, int self) {
        m_blocks[static_cast<std::size_t>(self)] = block;
        for (int row = block.row; row < block.endRow; ++row) {
            for (int column = block.column; column < block.endColumn; ++column) {
                m_owner[static_cast<std::size_t>(row * m_columns + column)] = self;
            }
        }
    }

    int owner(int column, int row) const {
        return m_owner[static_cast<std::size_t>(row * m_columns + column)];
    }

    int m_columns;
    int m_maxRows;
    std::vector<int> m_owner; ///< The block of each tile.
    std::vector<TileBlock> m_blocks;
};

} // namespace

std::vector<TileBlock> blocksOf(const TileSet& tiles, int maxRows) {
    const int columns = tiles.grid().columns();
    BlockMaker maker(tiles, maxRows);
    for (int row = 0; row < tiles.grid().rows(); ++row) {
        const auto isOpen = [&](int column) {
            return tiles.contains(row * columns + column) && !maker.isTaken(column, row);
        };
        for (int first = 0; first < columns; ++first) {
            int end = first;
            while (end < columns && isOpen(end)) {
                ++end;
            }
            if (end > first) {
                maker.add(first, end, row);
            }
        }
    }
    return std::move(maker).blocks();
}

namespace {

constexpr double kFootprintCellPx = 32;

/// The edges and middles of cells that together cover the pixels of a side.
std::vector<double> samplePositions(int length) {
    std::vector<double> positions;
    const double end = length - 0.5;
    for (double at = -0.5; at < end; at += kFootprintCellPx) {
        const double next = std::min(at + kFootprintCellPx, end);
        positions.insert(positions.end(), {at, (at + next) / 2});
    }
    positions.push_back(end);
    return positions;
}

/// The corners, the middles of the sides, and the centre, row after row.
std::array<Vector2d, 9> positionsIn(double x, double y, double endX, double endY) {
    std::array<Vector2d, 9> positions;
    for (std::size_t i = 0; i < 9; ++i) {
        positions[i] = {x + static_cast<double>(i % 3) * (endX - x) / 2,
                        y + static_cast<double>(i / 3) * (endY - y) / 2};
    }
    return positions;
}

/// Adds the tiles of cells of a view, dividing those in which the projection bends.
class CellWalk {
  public:
    CellWalk(TileSet& tiles, const PhotoDirectionAt& photoDirectionAt, double reachPx)
        : m_tiles(tiles),
          m_at(photoDirectionAt),
          m_reach(reachPx * std::numbers::pi / tiles.grid().photo().height) {}

    using Seen = std::array<Vector3d, 9>;

    /// The unit direction in the photo that the view shows at this position. It is zero where the lens sees
    /// nothing.
    Vector3d look(const Vector2d& position) const {
        const auto direction = m_at(position);
        return direction ? direction->normalized() : Vector3d::Zero();
    }

    void add(double x, double y, double endX, double endY) {
        Seen seen;
        const auto positions = positionsIn(x, y, endX, endY);
        std::transform(positions.begin(), positions.end(), seen.begin(),
                       [&](const Vector2d& position) { return look(position); });
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

    /// Adds the tiles of a pixel beside which the lens may see nothing.
    void addSingle(const Vector2d& position) {
        const Vector3d centre = look(position);
        if (centre.isZero()) {
            return;
        }
        double radius = 0;
        for (const Vector2d& aside :
             {Vector2d(-0.5, 0), Vector2d(0.5, 0), Vector2d(0, -0.5), Vector2d(0, 0.5)}) {
            const Vector3d there = look(position + aside);
            if (!there.isZero()) {
                radius = std::max(radius, angleBetween(centre, there).value());
            }
        }
        m_tiles.insertCap(centre, Radians(1.5 * radius + m_reach));
    }

  private:
    static constexpr double kMostBend = 0.15;
    static constexpr double kSmallest = 0.5;

    /// The angle between two unit vectors. squaredChord: their squared distance.
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

    /// How far the middles are from their positions in a projection without bend.
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
    : m_x(samplePositions(camera.width())), m_y(samplePositions(camera.height())) {
    const auto isSeen = [&](const Vector2d& position) { return camera.ray(position).has_value(); };
    for (std::size_t row = 0; row + 2 < m_y.size(); row += 2) {
        for (std::size_t column = 0; column + 2 < m_x.size(); column += 2) {
            const auto positions = positionsIn(m_x[column], m_y[row], m_x[column + 2], m_y[row + 2]);
            // What a lens sees is convex but for slivers, which the reach covers: nine positions tell.
            if (std::all_of(positions.begin(), positions.end(), isSeen)) {
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
