// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"

#include "vector_math.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr int kStrip = 64; ///< Number of columns that are summed down together.

void blurRow(const float* in, int width, int radius, float* out) {
    const float share = 1 / static_cast<float>(2 * radius + 1);
    float sum = 0;
    for (int i = -radius; i <= radius; ++i) {
        sum += in[(i + width) % width];
    }
    for (int x = 0; x < width; ++x) {
        out[x] = sum * share;
        const int next = x + radius + 1;
        const int last = x - radius;
        sum += in[next < width ? next : next - width] - in[last < 0 ? last + width : last];
    }
}

void blurColumns(const Plane& in, int begin, int end, int radius, Plane& out) {
    const float share = 1 / static_cast<float>(2 * radius + 1);
    const int height = in.height();
    std::vector<float> sum(static_cast<std::size_t>(end - begin));
    const auto add = [&](int y, float sign) {
        const float* row = in.at(begin, std::clamp(y, 0, height - 1));
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += sign * row[i];
        }
    };
    for (int y = -radius; y <= radius; ++y) {
        add(y, 1);
    }
    for (int y = 0; y < height; ++y) {
        float* row = out.at(begin, y);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            row[i] = sum[i] * share;
        }
        add(y + radius + 1, 1);
        add(y - radius, -1);
    }
}

template <class Value>
void forEach(Plane& plane, int threads, const Value& value) {
    const auto count = static_cast<int>(plane.values().size());
    float* out = plane.values().data();
    parallelFor(count, 1 << 16, threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            out[i] = value(static_cast<std::size_t>(i));
        }
    });
}

} // namespace

void blur(Plane& plane, int radius, int threads) {
    Plane across(plane.width(), plane.height());
    parallelFor(plane.height(), 32, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            blurRow(plane.at(0, y), plane.width(), radius, across.at(0, y));
        }
    });
    parallelFor(plane.width(), kStrip, threads,
                [&](int begin, int end) { blurColumns(across, begin, end, radius, plane); });
}

GuidedFilter::GuidedFilter(Plane guide, int radius, float smoothness, int threads)
    : m_guide(std::move(guide)),
      m_mean(m_guide),
      m_inverseVariance(m_guide),
      m_radius(radius),
      m_threads(threads) {
    blur(m_mean, radius, threads);
    const auto g = m_guide.values();
    const auto mean = m_mean.values();
    forEach(m_inverseVariance, threads, [&](std::size_t i) { return g[i] * g[i]; });
    blur(m_inverseVariance, radius, threads);
    const auto squares = m_inverseVariance.values();
    forEach(m_inverseVariance, threads,
            [&](std::size_t i) { return 1 / (std::max(0.0F, squares[i] - mean[i] * mean[i]) + smoothness); });
}

void GuidedFilter::apply(Plane& plane) const {
    const auto guide = m_guide.values();
    const auto guideMean = m_mean.values();
    const auto inverse = m_inverseVariance.values();
    const auto values = plane.values();
    Plane slope(plane.width(), plane.height());
    const auto slopes = slope.values();
    forEach(slope, m_threads, [&](std::size_t i) { return values[i] * guide[i]; });
    blur(slope, m_radius, m_threads);
    blur(plane, m_radius, m_threads);
    forEach(slope, m_threads,
            [&](std::size_t i) { return (slopes[i] - guideMean[i] * values[i]) * inverse[i]; });
    forEach(plane, m_threads, [&](std::size_t i) { return values[i] - slopes[i] * guideMean[i]; });
    blur(slope, m_radius, m_threads);
    blur(plane, m_radius, m_threads);
    forEach(plane, m_threads, [&](std::size_t i) { return slopes[i] * guide[i] + values[i]; });
}

Plane median3x3(const Plane& plane, int threads) {
    Plane result(plane.width(), plane.height());
    parallelFor(plane.height(), 16, threads, [&](int begin, int end) {
        std::array<float, 9> around{};
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < plane.width(); ++x) {
                for (int i = 0; i < 9; ++i) {
                    const int column = (x + i % 3 - 1 + plane.width()) % plane.width();
                    const int row = std::clamp(y + i / 3 - 1, 0, plane.height() - 1);
                    around[static_cast<std::size_t>(i)] = *plane.at(column, row);
                }
                std::nth_element(around.begin(), around.begin() + 4, around.end());
                *result.at(x, y) = around[4];
            }
        }
    });
    return result;
}

namespace {

constexpr int kRadius = 3;
constexpr float kSameSurface = 0.02F;
constexpr float kFewestInPlane = 6;
constexpr float kRidge = 1e-3F; ///< Decides where all values lie in one line.

/// Fits a plane to the values around each pixel of a row. All sums are as long as the row.
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

    /// Stores the plane's value at each pixel, or the old value if too few belong to the same surface.
    void store(const float* here, float* out) const {
        for (std::size_t x = 0; x < m_count.size(); ++x) {
            const float xx = m_xx[x] + kRidge;
            const float yy = m_yy[x] + kRidge;
            const float xy = m_xy[x];
            const float first = xx * yy - xy * xy; // Cofactors of the normal equations' first row.
            const float second = xy * m_y[x] - m_x[x] * yy;
            const float third = m_x[x] * xy - xx * m_y[x];
            const float middle = (first * m_rise[x] + second * m_riseX[x] + third * m_riseY[x]) /
                                 (first * m_count[x] + second * m_x[x] + third * m_y[x]);
            const float value = here[x] + middle;
            out[x] = m_count[x] >= kFewestInPlane && value > 0 ? value : here[x];
        }
    }

  private:
    void wrap(std::span<const float> row) {
        std::copy(row.end() - kRadius, row.end(), m_wrapped.begin());
        std::copy(row.begin(), row.end(), m_wrapped.begin() + kRadius);
        std::copy_n(row.begin(), kRadius, m_wrapped.end() - kRadius);
    }

    /// Adds the values at this offset from the row's pixels. Differences keep the digits of small numbers.
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
    std::vector<float> m_wrapped; ///< A row of values that goes on at both ends.
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
