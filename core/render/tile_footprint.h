// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tile_grid.h"

#include "spherewalk/geometry/camera_model.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace spherewalk::render {

/// The direction in which a photo sees what a view's pixel shows, not normalised; nothing where the lens sees
/// nothing. Called for fractions of pixels too, up to half a pixel outside of the view.
using PhotoDirectionAt = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& viewPixel)>;

/// Which part of a camera's picture has pixels, prepared so that the tiles of a view are found in a fraction
/// of the view's own time. Threads: const, any number.
class ViewFootprint {
  public:
    /// Cost: for a lens that leaves some of the picture black, a ray for each pixel there; once a camera.
    explicit ViewFootprint(const CameraModel& camera);

    /// All tiles that a view may touch, and few others: lens distortion, displacement, seam and poles
    /// included. The projection is sampled every 16 pixels, and closer where it bends; it must be continuous
    /// on the sphere. reachPx: how far beyond its own place a pixel is filtered, in photo pixels.
    TileSet tiles(const TileGrid& grid, const PhotoDirectionAt& photoDirectionAt, double reachPx = 2) const;

  private:
    struct Cell {
        std::size_t column, row;
    };

    std::vector<double> m_x; ///< of the samples: edges and middles of the cells
    std::vector<double> m_y;
    std::vector<Cell> m_cells;              ///< all of whose pixels the lens sees
    std::vector<Eigen::Vector2d> m_singles; ///< seen pixels of the other cells
};

} // namespace spherewalk::render
