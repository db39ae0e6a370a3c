// SPDX-License-Identifier: Apache-2.0
#include "dataset/evidence.h"

#include "spherewalk/base/image.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <span>

namespace spherewalk::render {

namespace {

/// 1 / distance in steps of DepthMap::kStepPerM, or 1 for what is sure and 0 for what is not.
using Steps = Image<std::int16_t, 1>;

/// What is known of squares of a depth's pixels. Each member has one value a square.
struct Squares {
    Squares(int width, int height) : least(width, height), greatest(width, height), isSure(width, height) {}

    Steps least;
    Steps greatest;
    Steps isSure; ///< 1 where all pixels are sure.
};

constexpr auto kLeast = [](std::int16_t a, std::int16_t b) { return std::min(a, b); };
constexpr auto kGreatest = [](std::int16_t a, std::int16_t b) { return std::max(a, b); };

/// Picks one of each `side` values side by side.
template <class Pick>
void pickAlongRow(const std::vector<std::int16_t>& values, int side, const Pick& pick,
                  std::span<std::int16_t> picked) {
    const auto stride = static_cast<std::size_t>(side);
    for (std::size_t x = 0; x < picked.size(); ++x) {
        picked[x] = values[x * stride];
    }
    for (std::size_t i = 1; i < stride; ++i) {
        for (std::size_t x = 0; x < picked.size(); ++x) {
            picked[x] = pick(picked[x], values[x * stride + i]);
        }
    }
}

/// Fills one row of squares of side x side pixels.
void fillRow(const DepthSteps& depth, int y, int side, Squares& squares) {
    const auto width = static_cast<std::size_t>(depth.width());
    std::vector<std::int16_t> least(width, std::numeric_limits<std::int16_t>::max());
    std::vector<std::int16_t> greatest(width);
    std::vector<std::int16_t> isSure(width, 1);
    for (int j = 0; j < side; ++j) {
        const std::uint16_t* row = depth.row(y * side + j);
        for (std::size_t x = 0; x < width; ++x) {
            const auto steps = static_cast<std::int16_t>(row[x] >> 1);
            least[x] = std::min(least[x], steps);
            greatest[x] = std::max(greatest[x], steps);
            isSure[x] = static_cast<std::int16_t>(isSure[x] & row[x]);
        }
    }
    pickAlongRow(least, side, kLeast, squares.least.row(y));
    pickAlongRow(greatest, side, kGreatest, squares.greatest.row(y));
    pickAlongRow(isSure, side, kLeast, squares.isSure.row(y));
}

/// Replaces each value of a row by that of all within `reach`. The first one goes on after the last.
template <class Pick>
void spreadAlongRow(std::span<std::int16_t> row, std::size_t reach, const Pick& pick) {
    std::vector<std::int16_t> around(row.end() - static_cast<std::ptrdiff_t>(reach), row.end());
    around.insert(around.end(), row.begin(), row.end());
    around.insert(around.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(reach));
    std::copy_n(around.begin(), row.size(), row.begin());
    for (std::size_t step = 1; step <= 2 * reach; ++step) {
        for (std::size_t x = 0; x < row.size(); ++x) {
            row[x] = pick(row[x], around[x + step]);
        }
    }
}

/// The picks of the rows within `reach` of one.
template <class Pick>
void pickAcrossRows(const Steps& values, int y, int reach, const Pick& pick, std::span<std::int16_t> picked) {
    const auto row = [&](int at) { return values.row(std::clamp(at, 0, values.height() - 1)); };
    std::ranges::copy(row(y - reach), picked.begin());
    for (int other = y - reach + 1; other <= y + reach; ++other) {
        const std::span<const std::int16_t> from = row(other);
        for (std::size_t x = 0; x < picked.size(); ++x) {
            picked[x] = pick(picked[x], from[x]);
        }
    }
}

Squares squaresOf(const DepthSteps& depth, int side) {
    Squares squares(depth.width() / side, depth.height() / side);
    for (int y = 0; y < squares.least.height(); ++y) {
        fillRow(depth, y, side, squares);
        spreadAlongRow(squares.least.row(y), 2, kLeast);
        spreadAlongRow(squares.greatest.row(y), 2, kGreatest);
        spreadAlongRow(squares.isSure.row(y), 1, kLeast);
    }
    return squares;
}

/// The nearest whole number, in [0, most]. It is 0 for what is no number.
int rounded(double coordinate, int most) {
    return static_cast<int>(std::min(static_cast<double>(most), std::max(0.0, coordinate + 0.5)));
}

} // namespace

DepthEvidence::DepthEvidence(const DepthSteps& depth) : m_pixelRad(2 * std::numbers::pi / depth.width()) {
    const int side = std::max(1, depth.width() / kWidth);
    m_size = {depth.width() / side, depth.height() / side};
    const Squares squares = squaresOf(depth, side);
    const auto width = static_cast<std::size_t>(m_size.width);
    m_cells.resize(width * static_cast<std::size_t>(m_size.height));
    std::vector<std::int16_t> least(width);
    std::vector<std::int16_t> greatest(width);
    std::vector<std::int16_t> isSure(width);
    for (int y = 0; y < m_size.height; ++y) {
        pickAcrossRows(squares.least, y, 2, kLeast, least);
        pickAcrossRows(squares.greatest, y, 2, kGreatest, greatest);
        pickAcrossRows(squares.isSure, y, 1, kLeast, isSure);
        const std::uint16_t* middle = depth.row(y * side + side / 2) + side / 2;
        Cell* cells = m_cells.data() + static_cast<std::size_t>(y) * width;
        for (std::size_t x = 0; x < width; ++x) {
            const int spread = greatest[x] - least[x];
            cells[x] = {middle[x * static_cast<std::size_t>(side)],
                        static_cast<std::uint16_t>(2 * spread + isSure[x])};
        }
    }
}

KnownDepth DepthEvidence::at(double u, double v) const {
    const int beyond = rounded(u, m_size.width);
    const int x = beyond == m_size.width ? 0 : beyond;
    const int y = std::min(rounded(v, m_size.height), m_size.height - 1);
    const Cell& cell = m_cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                               static_cast<std::size_t>(x)];
    constexpr double kStep = DepthMap::kStepPerM;
    return {cell.inverse / 2 * kStep, cell.spread / 2 * kStep, cell.inverse % 2 == 1, cell.spread % 2 == 1};
}

} // namespace spherewalk::render
