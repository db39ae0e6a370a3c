// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/progress.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::scene {

namespace {

constexpr std::int16_t kNever = 16000; ///< Cost beside the first and the last distance.
constexpr int kChunk = 32;             ///< Number of pixels of a row that one thread does at a time.

/// The costs of a path's last pixel, with one more before and after.
struct PathEnd {
    std::int16_t* costs; ///< Of the distances -1 to count.
    std::int16_t* least;
};

/// Extends a path by one pixel.
void extend(const std::uint8_t* costs, int count, const PathEnd& from, std::int16_t step, std::int16_t jump,
            const PathEnd& to, std::int16_t* __restrict sums) {
    const std::int16_t* __restrict before = from.costs;
    std::int16_t* __restrict after = to.costs;
    const std::int16_t base = *from.least;
    const auto ceiling = static_cast<std::int16_t>(base + jump);
    std::int16_t least = kNever;
    for (int d = 0; d < count; ++d) {
        const auto beside = static_cast<std::int16_t>(std::min(before[d], before[d + 2]) + step);
        const std::int16_t best = std::min(std::min(before[d + 1], beside), ceiling);
        const auto here = static_cast<std::int16_t>(best - base + costs[d]);
        after[d + 1] = here;
        sums[d] = static_cast<std::int16_t>(sums[d] + here);
        least = std::min(least, here);
    }
    after[0] = kNever;
    after[count + 1] = kNever;
    *to.least = least;
}

class Paths {
  public:
    Paths(const CostVolume<std::uint8_t>& costs, const SweepPicture& guide, const PathPenalties& penalties,
          CostVolume<std::int16_t>& sums)
        : m_costs(costs), m_guide(guide), m_penalties(penalties), m_sums(sums) {}

    /// Adds both paths along a row. A path begins a part of a turn ahead, so that the seam is no beginning.
    void alongRow(int y) {
        const int width = m_costs.width;
        const auto room = static_cast<std::size_t>(m_costs.distances) + 2;
        std::vector<std::int16_t> unused(static_cast<std::size_t>(m_costs.distances));
        for (const int step : {1, -1}) {
            std::vector<std::int16_t> a(room, 0);
            std::vector<std::int16_t> b(room, 0);
            a.front() = a.back() = kNever;
            std::int16_t leastA = 0;
            std::int16_t leastB = 0;
            PathEnd from{a.data(), &leastA};
            PathEnd to{b.data(), &leastB};
            for (int i = -width / 8; i < width; ++i) {
                const int x = ((step > 0 ? i : width - 1 - i) + width) % width;
                const int last = (x - step + width) % width;
                extend(m_costs.at(x, y), m_costs.distances, from, stepCost(), jumpCost(x, y, last, y), to,
                       i < 0 ? unused.data() : m_sums.at(x, y));
                std::swap(from, to);
            }
        }
    }

    /// Adds the three paths that come from the row before, downwards (step 1) or upwards (-1).
    void acrossRows(int step, int threads, const std::stop_token& stop) {
        const int width = m_costs.width;
        const std::size_t ends = 3 * static_cast<std::size_t>(width);
        const auto room = static_cast<std::size_t>(m_costs.distances) + 2;
        std::vector<std::int16_t> costs[2];
        std::vector<std::int16_t> least[2];
        for (int i = 0; i < 2; ++i) {
            costs[i].assign(ends * room, 0);
            least[i].assign(ends, 0);
        }
        for (std::size_t i = 0; i < ends; ++i) {
            costs[0][i * room] = costs[0][i * room + room - 1] = kNever;
        }
        WorkerPool pool(threads);
        for (int row = 0; row < m_costs.height; ++row) {
            throwIfStopped(stop);
            const int y = step > 0 ? row : m_costs.height - 1 - row;
            const int lastY = std::clamp(y - step, 0, m_costs.height - 1);
            const auto end = [&](int which, int x, int path) {
                const std::size_t i = 3 * static_cast<std::size_t>(x) + static_cast<std::size_t>(path);
                return PathEnd{&costs[which][i * room], &least[which][i]};
            };
            pool.run((width + kChunk - 1) / kChunk, 0, [&](int chunk, int) {
                for (int x = kChunk * chunk; x < std::min(width, kChunk * (chunk + 1)); ++x) {
                    for (int path = 0; path < 3; ++path) {
                        const int lastX = (x + path - 1 + width) % width;
                        extend(m_costs.at(x, y), m_costs.distances, end(row % 2, lastX, path), stepCost(),
                               jumpCost(x, y, lastX, lastY), end(1 - row % 2, x, path), m_sums.at(x, y));
                    }
                }
            });
        }
    }

  private:
    std::int16_t stepCost() const { return static_cast<std::int16_t>(m_penalties.step); }

    std::int16_t jumpCost(int x, int y, int lastX, int lastY) const {
        const float edge = std::fabs(m_guide.brightness(x, y) - m_guide.brightness(lastX, lastY));
        constexpr float kEdge = 8; ///< Grey levels at which a jump costs half.
        return static_cast<std::int16_t>(
            std::max(1.5F * m_penalties.step, m_penalties.jump / (1 + edge / kEdge)));
    }

    const CostVolume<std::uint8_t>& m_costs;
    const SweepPicture& m_guide;
    PathPenalties m_penalties;
    CostVolume<std::int16_t>& m_sums;
};

} // namespace

CostVolume<std::int16_t> aggregatedOverPaths(const CostVolume<std::uint8_t>& costs, const SweepPicture& guide,
                                             const PathPenalties& penalties, int threads,
                                             const std::stop_token& stop) {
    CostVolume<std::int16_t> sums(costs.width, costs.height, costs.distances);
    Paths paths(costs, guide, penalties, sums);
    parallelFor(costs.height, 4, threads, [&](int begin, int end) {
        throwIfStopped(stop);
        for (int y = begin; y < end; ++y) {
            paths.alongRow(y);
        }
    });
    for (const int step : {1, -1}) {
        paths.acrossRows(step, threads, stop);
    }
    return sums;
}

} // namespace spherewalk::scene
