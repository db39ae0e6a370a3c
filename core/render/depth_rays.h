// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_fit.h"
#include "inverse_buffer.h"

#include "spherewalk/render/pixel_rays.h"

#include <array>
#include <cstddef>
#include <vector>

namespace spherewalk::render {

/// Rays of a row of cells, in single precision.
class RowRays {
  public:
    static constexpr int kCell = OpenCells::kCell;

    /// width: pixels, of whole cells.
    RowRays(const PixelRays& rays, int width);

    /// Goes to a row of cells.
    void cast(int row);

    /// Range: x a multiple of kCell.
    std::array<simd::CellRays, 3> cell(int x) const;

    bool isPinhole() const { return m_isPinhole; }

    /// Range: of a pinhole.
    simd::NodeRays nodes() const;

    /// Whether the lens sees nothing there. Range: not of a pinhole; y in the row of cells.
    bool isBlind(int x, int y) const {
        const auto i = static_cast<std::size_t>(y * m_width + x);
        return m_x[i] == 0 && m_y[i] == 0 && m_z[i] == 0;
    }

  private:
    const PixelRays& m_rays;
    int m_width;
    bool m_isPinhole;
    std::vector<float> m_x;
    std::vector<float> m_y;
    std::vector<float> m_z;
    std::array<std::vector<float>, 3> m_nodes; ///< x of the cells' nodes
};

} // namespace spherewalk::render
