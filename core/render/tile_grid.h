// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/region.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace spherewalk::render {

/// How a photo is cut into the tiles that are decoded, kept and dropped. 128 pixels are the restart interval
/// of 8 MCUs that datasets are exported with: of the intervals beside a block of tiles, which chroma
/// upsampling needs, all but one MCU is only entropy-decoded. 64 rows are few enough to follow a view's edge,
/// and enough that the MCU rows above and below cost little.
class TileGrid {
  public:
    static constexpr int kTileWidth = 128;
    static constexpr int kTileHeight = 64;

    TileGrid() = default;
    explicit TileGrid(const EquirectSize& photo);

    const EquirectSize& photo() const { return m_photo; }

    int columns() const { return m_columns; }

    int rows() const { return m_rows; }

    int count() const { return m_columns * m_rows; }

    /// The pixels of tiles [column, endColumn) x [row, endRow), cut at the photo's edges.
    jpeg::PixelRect pixels(int column, int row, int endColumn, int endRow) const;

    /// Those of one tile, numbered row after row.
    jpeg::PixelRect pixels(int tile) const;

    bool operator==(const TileGrid&) const = default;

  private:
    EquirectSize m_photo;
    int m_columns = 0;
    int m_rows = 0;
};

/// Some of a photo's tiles.
class TileSet {
  public:
    TileSet() = default;
    explicit TileSet(const TileGrid& grid);
    static TileSet all(const TileGrid& grid);

    const TileGrid& grid() const { return m_grid; }

    bool contains(int tile) const { return m_tiles[static_cast<std::size_t>(tile)] != 0; }

    void insert(int tile) { m_tiles[static_cast<std::size_t>(tile)] = 1; }

    void erase(int tile) { m_tiles[static_cast<std::size_t>(tile)] = 0; }

    int count() const;

    bool empty() const { return count() == 0; }

    /// Adds the tiles of all pixels that lie in the box or next to it. Units: photo pixels. left may be
    /// negative and right beyond the photo: it goes on at the other side. What is above or below is cut off.
    void insertBox(double left, double top, double right, double bottom);

    /// Adds the tiles that show anything within `radius` of the direction; near a pole, those all round it.
    void insertCap(const Eigen::Vector3d& direction, Radians radius);

    /// Adds all tiles of the other set. Range: of the same grid.
    void merge(const TileSet& other);

    /// The set and its neighbours, those across the seam too.
    TileSet grown() const;

    /// Calls for each tile in order.
    void forEach(const std::function<void(int tile)>& call) const;

    bool operator==(const TileSet&) const = default;

  private:
    TileGrid m_grid;
    std::vector<std::uint8_t> m_tiles;
};

/// A block of tiles that is decoded in one piece.
struct TileBlock {
    int column = 0;
    int row = 0;
    int endColumn = 0;
    int endRow = 0;
};

/// Disjoint blocks that together cover the set, none higher than maxRows tiles. Rows of slightly different
/// extent share a block, since each block decodes a margin; so it may hold tiles that are not in the set.
std::vector<TileBlock> blocksOf(const TileSet& tiles, int maxRows);

} // namespace spherewalk::render
