// SPDX-License-Identifier: Apache-2.0
#include "inverse_buffer.h"

#include "depth_cells.h"
#include "depth_pieces.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace spherewalk::render {

namespace {

int padded(int pixels) {
    return (pixels + simd::kColumns - 1) / simd::kColumns * simd::kColumns;
}

} // namespace

void fit(InverseBuffer& buffer, int width, int height) {
    if (buffer.width() != padded(width) || buffer.height() != padded(height)) {
        buffer = InverseBuffer(padded(width), padded(height));
    }
}

OpenCells::OpenCells(int width, int height)
    : m_width((width + kCell - 1) / kCell * kParts),
      m_height((height + kCell - 1) / kCell * kParts),
      m_sums(static_cast<std::size_t>((m_width + 1) * (m_height + 1))),
      m_cells(static_cast<std::size_t>(m_width * m_height / (kParts * kParts)), kCell * kCell) {
    for (int y = 0; y <= m_height; ++y) {
        for (int x = 0; x <= m_width; ++x) {
            m_sums[static_cast<std::size_t>(y * (m_width + 1) + x)] = x * y * kPart * kPart;
        }
    }
}

int OpenCells::update(const InverseBuffer& covered, WorkerPool& pool, int threads) {
    const int columns = m_width / kParts;
    std::vector<int> parts(static_cast<std::size_t>(m_width * m_height));
    pool.run(m_height / kParts, threads, [&](int row, int) {
        std::array<std::int32_t, kParts * kParts> ofParts;
        for (int column = 0; column < columns; ++column) {
            if (!isOpen(column, row)) {
                continue;
            }
            m_cells[static_cast<std::size_t>(row * columns + column)] =
                simd::zeros(covered.at(column * kCell, row * kCell), covered.width(), ofParts);
            for (int i = 0; i < kParts; ++i) {
                std::copy_n(ofParts.begin() + i * kParts, kParts,
                            parts.begin() + (row * kParts + i) * m_width + column * kParts);
            }
        }
    });
    const std::size_t pitch = static_cast<std::size_t>(m_width) + 1;
    for (std::size_t y = 1; y <= static_cast<std::size_t>(m_height); ++y) {
        int inRow = 0;
        for (std::size_t x = 1; x < pitch; ++x) {
            inRow += parts[(y - 1) * (pitch - 1) + x - 1];
            m_sums[y * pitch + x] = inRow + m_sums[(y - 1) * pitch + x];
        }
    }
    return std::accumulate(m_cells.begin(), m_cells.end(), 0);
}

bool OpenCells::anyIn(float left, float top, float right, float bottom) const {
    const auto part = [](float pixel, int count, int more) {
        const float inView = std::min(std::max(pixel * (1.0F / kPart), -1.0F), static_cast<float>(count));
        return std::min(std::max(static_cast<int>(inView + 1) - 1 + more, 0), count);
    };
    const int column = part(left, m_width, 0);
    const int endColumn = part(right, m_width, 1);
    const int row = part(top, m_height, 0);
    const int endRow = part(bottom, m_height, 1);
    return endColumn > column && endRow > row && sum(column, row, endColumn, endRow) > 0;
}

} // namespace spherewalk::render
