// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_smoothing.h"

#include "vector_clones.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr int kRadius = 3;
constexpr float kSameSurface = 0.02F;
constexpr float kFewest = 6;
constexpr float kRidge = 1e-3F; ///< decides where all values lie in one line

/// Planes through the values about each pixel of a row. What is summed is as long as the row.
class RowOfPlanes {
  public:
    explicit RowOfPlanes(int width) {
        for (auto* sum : {&m_count, &m_x, &m_y, &m_xx, &m_xy, &m_yy, &m_rise, &m_riseX, &m_riseY}) {
            sum->resize(static_cast<std::size_t>(width));
        }
        m_wrapped.resize(static_cast<std::size_t>(width + 2 * kRadius));
    }

    void fit(const Plane& inverse, int y) {
        for (auto* sum : {&m_count, &m_x, &m_y, &m_xx, &m_xy, &m_yy, &m_rise, &m_riseX, &m_riseY}) {
            std::fill(sum->begin(), sum->end(), 0.0F);
        }
        for (int j = std::max(-kRadius, -y); j <= std::min(kRadius, inverse.height() - 1 - y); ++j) {
            wrap(inverse.row(y + j));
            for (int i = -kRadius; i <= kRadius; ++i) {
                add(inverse.at(0, y), i, j);
            }
        }
    }

    /// The plane's value at the pixel itself; what there was if too few are of the same surface.
    void store(const float* here, float* out) const {
        for (std::size_t x = 0; x < m_count.size(); ++x) {
            const float xx = m_xx[x] + kRidge;
            const float yy = m_yy[x] + kRidge;
            const float xy = m_xy[x];
            const float first = xx * yy - xy * xy; // cofactors of the normal equations' first row
            const float second = xy * m_y[x] - m_x[x] * yy;
            const float third = m_x[x] * xy - xx * m_y[x];
            const float middle = (first * m_rise[x] + second * m_riseX[x] + third * m_riseY[x]) /
                                 (first * m_count[x] + second * m_x[x] + third * m_y[x]);
            const float value = here[x] + middle;
            out[x] = m_count[x] >= kFewest && value > 0 ? value : here[x];
        }
    }

  private:
    void wrap(std::span<const float> row) {
        std::copy(row.end() - kRadius, row.end(), m_wrapped.begin());
        std::copy(row.begin(), row.end(), m_wrapped.begin() + kRadius);
        std::copy_n(row.begin(), kRadius, m_wrapped.end() - kRadius);
    }

    /// The values that are so far aside from the row's pixels. Differences keep the digits of small numbers.
    SPHEREWALK_VECTOR_CLONES
    void add(const float* here, int right, int down) {
        const float tolerance =
            kSameSurface *
            std::max(1.0F, 0.5F * static_cast<float>(std::max(std::abs(right), std::abs(down))));
        const auto i = static_cast<float>(right);
        const auto j = static_cast<float>(down);
        const float* values = m_wrapped.data() + kRadius + right;
        for (std::size_t x = 0; x < m_count.size(); ++x) {
            const float difference = values[x] - here[x];
            const bool isSame = std::fabs(difference) < tolerance * here[x];
            const float one = isSame ? 1.0F : 0.0F;
            const float rise = isSame ? difference : 0.0F;
            m_count[x] += one;
            m_x[x] += i * one;
            m_y[x] += j * one;
            m_xx[x] += i * i * one;
            m_xy[x] += i * j * one;
            m_yy[x] += j * j * one;
            m_rise[x] += rise;
            m_riseX[x] += i * rise;
            m_riseY[x] += j * rise;
        }
    }

    std::vector<float> m_count, m_x, m_y, m_xx, m_xy, m_yy, m_rise, m_riseX, m_riseY;
    std::vector<float> m_wrapped; ///< a row of values that goes on at both ends
};

} // namespace

Plane smoothedSurfaces(const Plane& inverseM, int threads) {
    Plane result(inverseM.width(), inverseM.height());
    parallelFor(result.height(), 8, threads, [&](int begin, int end) {
        RowOfPlanes planes(result.width());
        for (int y = begin; y < end; ++y) {
            planes.fit(inverseM, y);
            planes.store(inverseM.at(0, y), result.at(0, y));
        }
    });
    return result;
}

} // namespace spherewalk::scene
