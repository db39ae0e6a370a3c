// SPDX-License-Identifier: Apache-2.0
#include "tile_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace spherewalk::render {

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

void TileSet::insertCap(const Eigen::Vector3d& direction, Radians radius) {
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
    std::vector<int> m_owner; ///< of each tile: the block that it is in
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

} // namespace spherewalk::render
