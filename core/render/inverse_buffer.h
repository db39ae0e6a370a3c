// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"

#include <vector>

namespace spherewalk::render {

/// What a camera sees of a surface, 1 / s a pixel: the point is s times the pixel's ray, which is (x, y, 1)
/// without distortion, so that s is the depth along the axis, and a unit vector through a lens. 0 where it
/// sees none. Made of whole cells of 16 x 16 pixels; what lies beyond the view is 1 once something was drawn.
using InverseBuffer = Image<float, 1>;

/// Fits it to a view. It is not cleared.
void fit(InverseBuffer& buffer, int width, int height);

/// Which parts of a view have pixels that nothing covers yet. Threads: const, any number.
class OpenCells {
  public:
    static constexpr int kCell = 16;
    static constexpr int kPart = 4; ///< of a cell: holes are thin

    /// All are open.
    OpenCells(int width, int height);

    /// Those are open that have a 0. Returns how many pixels are.
    int update(const InverseBuffer& covered, WorkerPool& pool, int threads);

    bool any() const { return m_sums.back() > 0; }

    bool isAllOpen() const { return m_sums.back() == m_width * m_height * kPart * kPart; }

    bool isOpen(int column, int row) const {
        return m_cells[static_cast<std::size_t>(row * (m_width / kParts) + column)] > 0;
    }

    /// Whether a part is open that meets this piece of the view. Units: pixels; any.
    bool anyIn(float left, float top, float right, float bottom) const;

    /// The same of whole pixels of the view, the last ones included.
    bool anyIn(int left, int top, int right, int bottom) const {
        return sum(left / kPart, top / kPart, right / kPart + 1, bottom / kPart + 1) > 0;
    }

  private:
    static constexpr int kParts = kCell / kPart;

    int sum(int column, int row, int endColumn, int endRow) const {
        const auto at = [&](int x, int y) { return m_sums[static_cast<std::size_t>(y * (m_width + 1) + x)]; };
        return at(endColumn, endRow) - at(endColumn, row) - at(column, endRow) + at(column, row);
    }

    int m_width; ///< parts
    int m_height;
    std::vector<int> m_sums;  ///< of the pixels above and to the left, with a row and a column of zeros
    std::vector<int> m_cells; ///< open pixels of each cell
};

} // namespace spherewalk::render
