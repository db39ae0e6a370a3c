// SPDX-License-Identifier: Apache-2.0
#include "dataset/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spherewalk::render {

namespace {

/// What is known of a square of a depth's pixels.
struct Square {
    float least = std::numeric_limits<float>::infinity();
    float greatest = 0;
    bool isSure = true;

    void add(const Square& other) {
        least = std::min(least, other.least);
        greatest = std::max(greatest, other.greatest);
        isSure = isSure && other.isSure;
    }
};

Square squareAt(const DepthMap& map, int left, int top, int side) {
    Square square;
    for (int y = top; y < top + side; ++y) {
        for (int x = left; x < left + side; ++x) {
            const float value = *map.inverseM().at(x, y);
            square.add({value, value, *map.sure().at(x, y) != 0});
        }
    }
    return square;
}

std::uint16_t packed(float inverseM, bool flag) {
    const auto steps = static_cast<int>(std::lround(inverseM / DepthMap::kStepPerM));
    return static_cast<std::uint16_t>(2 * std::clamp(steps, 0, DepthMap::kSteps) + (flag ? 1 : 0));
}

} // namespace

DepthEvidence::DepthEvidence(const DepthMap& map) : m_pixelRad(2 * std::numbers::pi / map.width()) {
    const int side = std::max(1, map.width() / kWidth);
    m_size = {map.width() / side, map.height() / side};
    const auto width = static_cast<std::size_t>(m_size.width);
    const auto rowOf = [&](int y) {
        return static_cast<std::size_t>(std::clamp(y, 0, m_size.height - 1)) * width;
    };
    std::vector<Square> squares(width * static_cast<std::size_t>(m_size.height));
    for (int y = 0; y < m_size.height; ++y) {
        for (int x = 0; x < m_size.width; ++x) {
            squares[rowOf(y) + static_cast<std::size_t>(x)] = squareAt(map, x * side, y * side, side);
        }
    }
    // Squares about each one: first along rows, then along columns.
    std::vector<Square> alongRows(squares.size());
    m_cells.resize(squares.size());
    for (int y = 0; y < m_size.height; ++y) {
        for (int x = 0; x < m_size.width; ++x) {
            Square& sum = alongRows[rowOf(y) + static_cast<std::size_t>(x)];
            for (int step = -2; step <= 2; ++step) {
                const int column = (x + step + m_size.width) % m_size.width;
                Square other = squares[rowOf(y) + static_cast<std::size_t>(column)];
                other.isSure = other.isSure || std::abs(step) > 1;
                sum.add(other);
            }
        }
    }
    for (int y = 0; y < m_size.height; ++y) {
        for (int x = 0; x < m_size.width; ++x) {
            Square sum;
            for (int step = -2; step <= 2; ++step) {
                Square other = alongRows[rowOf(y + step) + static_cast<std::size_t>(x)];
                other.isSure = other.isSure || std::abs(step) > 1;
                sum.add(other);
            }
            const int middle = side / 2;
            m_cells[rowOf(y) + static_cast<std::size_t>(x)] = {
                packed(*map.inverseM().at(x * side + middle, y * side + middle),
                       *map.sure().at(x * side + middle, y * side + middle) != 0),
                packed(sum.greatest - sum.least, sum.isSure)};
        }
    }
}

KnownDepth DepthEvidence::at(const Eigen::Vector3d& direction) const {
    const Eigen::Vector2d at = pixel(m_size, direction);
    const int x = (static_cast<int>(std::lround(at.x())) + m_size.width) % m_size.width;
    const int y = std::clamp(static_cast<int>(std::lround(at.y())), 0, m_size.height - 1);
    const Cell& cell = m_cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                               static_cast<std::size_t>(x)];
    constexpr double kStep = DepthMap::kStepPerM;
    return {cell.inverse / 2 * kStep, cell.spread / 2 * kStep, cell.inverse % 2 == 1, cell.spread % 2 == 1};
}

} // namespace spherewalk::render
