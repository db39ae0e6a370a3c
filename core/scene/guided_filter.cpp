// SPDX-License-Identifier: GPL-3.0-or-later
#include "guided_filter.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr int kStrip = 64; ///< columns that are summed down together

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

} // namespace spherewalk::scene
