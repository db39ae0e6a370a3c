// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_filters.h"

#include "vector_math.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
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

namespace {

/// The median of nine values at each place. rows: three rows that begin one value before the first place.
SPHEREWALK_VECTOR_CLONES
void medianRow(const float* above, const float* here, const float* below, int width, float* __restrict out) {
    for (int x = 0; x < width; ++x) {
        float v[9] = {above[x],    above[x + 1], above[x + 2], here[x],     here[x + 1],
                      here[x + 2], below[x],     below[x + 1], below[x + 2]};
        const auto order = [&v](int a, int b) {
            const float low = v[a] < v[b] ? v[a] : v[b];
            v[b] = v[a] < v[b] ? v[b] : v[a];
            v[a] = low;
        };
        // The exchanges of Smith 1996 that leave the median in the middle.
        order(1, 2), order(4, 5), order(7, 8), order(0, 1), order(3, 4), order(6, 7), order(1, 2);
        order(4, 5), order(7, 8), order(0, 3), order(5, 8), order(4, 7), order(3, 6), order(1, 4);
        order(2, 5), order(4, 7), order(4, 2), order(6, 4), order(4, 2);
        out[x] = v[4];
    }
}

} // namespace

Plane median3x3(const Plane& plane, int threads) {
    Plane result(plane.width(), plane.height());
    parallelFor(plane.height(), 16, threads, [&](int begin, int end) {
        std::array<std::vector<float>, 3> rows;
        const auto load = [&](int y) {
            std::vector<float>& row = rows[static_cast<std::size_t>((y + 3) % 3)];
            const auto values = plane.row(std::clamp(y, 0, plane.height() - 1));
            row.assign(1, values.back());
            row.insert(row.end(), values.begin(), values.end());
            row.push_back(values.front());
        };
        load(begin - 1);
        load(begin);
        for (int y = begin; y < end; ++y) {
            load(y + 1);
            const auto row = [&](int at) { return rows[static_cast<std::size_t>((at + 3) % 3)].data(); };
            medianRow(row(y - 1), row(y), row(y + 1), plane.width(), result.at(0, y));
        }
    });
    return result;
}

namespace {

template <class Choose>
Plane chosenOfCross(const Plane& plane, int reach, int threads, const Choose& choose) {
    Plane result(plane.width(), plane.height());
    const int width = plane.width();
    parallelFor(plane.height(), 16, threads, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const float* here = plane.at(0, y);
            const float* above = plane.at(0, std::max(0, y - reach));
            const float* below = plane.at(0, std::min(y + reach, plane.height() - 1));
            float* __restrict out = result.at(0, y);
            const auto choosePart = [&](int from, int to, int left, int right) {
                for (int x = from; x < to; ++x) {
                    out[x] = choose(choose(here[x], choose(here[x + left], here[x + right])),
                                    choose(above[x], below[x]));
                }
            };
            choosePart(0, std::min(reach, width - reach), width - reach, reach);
            choosePart(reach, width - reach, -reach, reach);
            choosePart(std::max(reach, width - reach), width, -reach, reach - width);
        }
    });
    return result;
}

} // namespace

Plane leastOfCross(const Plane& plane, int reach, int threads) {
    return chosenOfCross(plane, reach, threads, [](float a, float b) { return a < b ? a : b; });
}

Plane mostOfCross(const Plane& plane, int reach, int threads) {
    return chosenOfCross(plane, reach, threads, [](float a, float b) { return a < b ? b : a; });
}

namespace {

constexpr int kRadius = 3;
constexpr float kSameSurface = 0.02F;
constexpr float kFewestInPlane = 6;
constexpr float kRidge = 1e-3F; ///< Decides where all values lie in one line.

constexpr int kAround = 2 * kRadius + 1;
constexpr int kAtATime = 8;

using Eight = float __attribute__((vector_size(32)));

/// Vectors go by reference: how they go by value depends on the processor.
inline void load(const float* values, Eight& eight) {
    std::memcpy(&eight, values, sizeof eight);
}

/// The sums over values that belong to the same surface, of eight pixels. Differences from the pixel's own
/// value keep the digits of small numbers.
struct PlaneSums {
    Eight count{}, x{}, y{}, xx{}, xy{}, yy{}, rise{}, riseX{}, riseY{};

    /// Stores the plane's value at each pixel, or the old value if too few belong to the same surface.
    void store(const Eight& here, float* out) const {
        const Eight a = xx + kRidge;
        const Eight d = yy + kRidge;
        const Eight first = a * d - xy * xy; // Cofactors of the normal equations' first row.
        const Eight second = xy * y - x * d;
        const Eight third = x * xy - a * y;
        const Eight middle =
            (first * rise + second * riseX + third * riseY) / (first * count + second * x + third * y);
        const Eight fitted = here + middle;
        const auto isFitted = (count >= kFewestInPlane) & (fitted > 0.0F);
        const Eight values = isFitted ? fitted : here;
        std::memcpy(out, &values, sizeof values);
    }
};

/// Fits a plane to the values around each pixel of a row.
class RowOfPlanes {
  public:
    explicit RowOfPlanes(int width)
        : m_width(width),
          m_pitch(static_cast<std::size_t>(width + 2 * kRadius + kAtATime)),
          m_wrapped(kAround * m_pitch),
          m_fitted(m_pitch) {}

    void fit(const Plane& inverse, int y, float* out) {
        const int first = std::max(-kRadius, -y);
        const int last = std::min(kRadius, inverse.height() - 1 - y);
        for (int j = first; j <= last; ++j) {
            wrap(inverse.row(y + j), row(j));
        }
        fitEights(first, last);
        std::copy_n(m_fitted.begin(), m_width, out);
    }

  private:
    /// A row that goes on at both ends, by its offset from the middle one.
    float* row(int down) { return m_wrapped.data() + static_cast<std::size_t>(down + kRadius) * m_pitch; }

    static void wrap(std::span<const float> from, float* to) {
        std::copy(from.end() - kRadius, from.end(), to);
        std::copy(from.begin(), from.end(), to + kRadius);
        std::copy_n(from.begin(), kRadius, to + kRadius + from.size());
    }

    SPHEREWALK_VECTOR_CLONES
    void fitEights(int first, int last) {
        for (int x = 0; x < m_width; x += kAtATime) {
            Eight here;
            load(row(0) + kRadius + x, here);
            PlaneSums sums;
            for (int right = -kRadius; right <= kRadius; ++right) {
                Eight count{}, down{}, downDown{}, rise{}, riseDown{};
                for (int j = first; j <= last; ++j) {
                    const int reach = std::max(std::abs(right), std::abs(j));
                    const float tolerance = kSameSurface * std::max(1.0F, 0.5F * static_cast<float>(reach));
                    const auto fromMiddle = static_cast<float>(j);
                    Eight difference;
                    load(row(j) + kRadius + x + right, difference);
                    difference -= here;
                    const Eight size = difference < 0.0F ? -difference : difference;
                    const auto isSame = size < tolerance * here;
                    const Eight one = isSame ? Eight{} + 1.0F : Eight{};
                    const Eight step = isSame ? difference : Eight{};
                    count += one;
                    down += fromMiddle * one;
                    downDown += fromMiddle * fromMiddle * one;
                    rise += step;
                    riseDown += fromMiddle * step;
                }
                const auto i = static_cast<float>(right);
                sums.count += count;
                sums.x += i * count;
                sums.y += down;
                sums.xx += i * i * count;
                sums.xy += i * down;
                sums.yy += downDown;
                sums.rise += rise;
                sums.riseX += i * rise;
                sums.riseY += riseDown;
            }
            sums.store(here, m_fitted.data() + x);
        }
    }

    int m_width;
    std::size_t m_pitch;
    std::vector<float> m_wrapped; ///< The rows about the middle one.
    std::vector<float> m_fitted;
};

} // namespace

Plane leastKnownAbout(const Plane& known, const Plane& weight, int threads) {
    constexpr int kReaches = 32; // in a row
    Plane plane(known.width(), known.height());
    for (std::size_t i = 0; i < plane.values().size(); ++i) {
        plane.values()[i] = weight.values()[i] > 0 ? known.values()[i] : HUGE_VALF;
    }
    for (int reach = 1; 2 * reach <= known.width() / kReaches; reach *= 2) {
        plane = leastOfCross(plane, reach, threads);
    }
    return plane;
}

Plane smoothedSurfaces(const Plane& inverseM, int threads) {
    Plane result(inverseM.width(), inverseM.height());
    parallelFor(result.height(), 8, threads, [&](int begin, int end) {
        RowOfPlanes planes(result.width());
        for (int y = begin; y < end; ++y) {
            planes.fit(inverseM, y, result.at(0, y));
        }
    });
    return result;
}

namespace {

constexpr int kMedianReach = 2;

/// The median of the square of kMedianReach pixels to each side. Range: the square lies within the rows.
float medianAbout(const Plane& plane, int x, int y) {
    std::array<float, (2 * kMedianReach + 1) * (2 * kMedianReach + 1)> values;
    std::size_t count = 0;
    for (int j = -kMedianReach; j <= kMedianReach; ++j) {
        for (int i = -kMedianReach; i <= kMedianReach; ++i) {
            values[count++] = *plane.at((x + i + plane.width()) % plane.width(), y + j);
        }
    }
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

Plane evenedBorders(Plane inverseM, const MaskImage& sure, int threads) {
    constexpr int kTurns = 2;
    for (int turn = 0; turn < kTurns; ++turn) {
        const Plane before = inverseM;
        const Plane least = leastOfCross(leastOfCross(before, 1, threads), 1, threads);
        const Plane most = mostOfCross(mostOfCross(before, 1, threads), 1, threads);
        parallelFor(before.height(), 8, threads, [&](int begin, int end) {
            for (int y = std::max(kMedianReach, begin); y < std::min(end, before.height() - kMedianReach);
                 ++y) {
                for (int x = 0; x < before.width(); ++x) {
                    if (*sure.at(x, y) == 0 && *most.at(x, y) - *least.at(x, y) > kTorn * *most.at(x, y)) {
                        *inverseM.at(x, y) = medianAbout(before, x, y);
                    }
                }
            }
        });
    }
    return inverseM;
}

} // namespace spherewalk::scene
