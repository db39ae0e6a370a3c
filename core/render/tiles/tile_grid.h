// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/region.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace spherewalk::render {

/// How a photo is cut into the tiles that are decoded, kept and dropped. Datasets are exported with a restart
/// interval of 8 MCUs, which are 128 pixels. Chroma upsampling needs the intervals beside a block of tiles;
/// all but one of their MCUs are only entropy-decoded. 64 rows are few enough to follow a view's edge, and
/// enough that the MCU rows above and below cost little.
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

    /// The pixels of the tiles [column, endColumn) x [row, endRow), cut at the photo's edges.
    jpeg::PixelRect pixels(int column, int row, int endColumn, int endRow) const;

    /// The pixels of one tile. Tiles are numbered row after row.
    jpeg::PixelRect pixels(int tile) const;

    bool operator==(const TileGrid&) const = default;

  private:
    EquirectSize m_photo;
    int m_columns = 0;
    int m_rows = 0;
};

/// A set of a photo's tiles.
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

    /// Adds the tiles of all pixels that lie in the box or next to it. Units: photo pixels. A box that goes
    /// beyond the left or right border goes on at the other side. Above and below it is cut off.
    void insertBox(double left, double top, double right, double bottom);

    /// Adds the tiles of all pixels within `radius` of the direction. Near a pole it adds the tiles all round
    /// it.
    void insertCap(const Eigen::Vector3d& direction, Radians radius);

    /// Adds all tiles of the other set. Range: both have the same grid.
    void merge(const TileSet& other);

    /// The set and its neighbours, also across the seam.
    TileSet grown() const;

    /// Calls the function for each tile in order.
    void forEach(const std::function<void(int tile)>& call) const;

    bool operator==(const TileSet&) const = default;

  private:
    TileGrid m_grid;
    std::vector<std::uint8_t> m_tiles;
};

/// A block of tiles that are decoded together.
struct TileBlock {
    int column = 0;
    int row = 0;
    int endColumn = 0;
    int endRow = 0;
};

/// Disjoint blocks that together cover the set. None is higher than maxRows tiles. Each block decodes a
/// margin, so that rows of slightly different extent share a block. A block may hold tiles that are not in
/// the set.
std::vector<TileBlock> blocksOf(const TileSet& tiles, int maxRows);

/// The direction in which a photo sees what a view's pixel shows. It need not be a unit vector. It is nothing
/// where the lens sees nothing. It is called for fractions of pixels, too, up to half a pixel outside of the
/// view.
using PhotoDirectionAt = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& viewPixel)>;

/// The part of a camera's picture that the lens sees. It is prepared so that the tiles of a view are found in
/// a fraction of the view's own time. Threads: const functions may run on any number at a time.
class ViewFootprint {
  public:
    /// Cost: a ray for each pixel of the cells where a lens leaves some pixels black. Make it once for a
    /// camera.
    explicit ViewFootprint(const CameraModel& camera);

    /// All tiles that a view may touch, and few others. Lens distortion, displacement, seam and poles are
    /// included. The projection must be continuous on the sphere. It is sampled every 16 pixels, and closer
    /// where it bends. reachPx: how many photo pixels beyond its own position a pixel's filter reaches.
    TileSet tiles(const TileGrid& grid, const PhotoDirectionAt& photoDirectionAt, double reachPx = 2) const;

  private:
    struct Cell {
        std::size_t column, row;
    };

    std::vector<double> m_x; ///< The positions of samples: edges and middles of the cells.
    std::vector<double> m_y;
    std::vector<Cell> m_cells;              ///< The cells where the lens sees all pixels.
    std::vector<Eigen::Vector2d> m_singles; ///< The seen pixels of the other cells.
};

} // namespace spherewalk::render
