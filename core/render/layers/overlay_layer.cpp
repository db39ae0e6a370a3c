// SPDX-License-Identifier: Apache-2.0
#include "layers/overlay_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::render {

using Eigen::Vector2d;

namespace {

constexpr float kNoDepth = std::numeric_limits<float>::infinity();
constexpr std::int16_t kNotThere = -1; ///< A pixel without an object: neighbours ignore it.

/// How much the depth of one surface may change from pixel to pixel: 3 % are 87 degrees of inclination where
/// a pixel spans a tenth of a degree.
constexpr float kSurfaceStep = 0.03F;

OverlayMap::Position positionOf(const Vector2d& pixel, const CameraModel& view, const CameraModel& other) {
    const auto ray = view.ray(pixel);
    const auto position = ray ? other.project(*ray) : std::nullopt;
    const bool isInside = position && position->x() >= -0.5 && position->x() <= other.width() - 0.5 &&
                          position->y() >= -0.5 && position->y() <= other.height() - 0.5;
    if (!isInside) {
        return {OverlayMap::kNowhere, 0};
    }
    return {static_cast<std::int32_t>(std::lround(OverlayMap::kOne * position->x())),
            static_cast<std::int32_t>(std::lround(OverlayMap::kOne * position->y()))};
}

} // namespace

OverlayMap::OverlayMap(const CameraModel& view, const CameraModel& other, WorkerPool& pool, int threads)
    : m_positions(view.width(), view.height()) {
    pool.run(view.height(), threads, [&](int y, int) {
        for (int x = 0; x < view.width(); ++x) {
            const Position position = positionOf(Vector2d(x, y), view, other);
            m_positions.at(x, y)[0] = position.u;
            m_positions.at(x, y)[1] = position.v;
        }
    });
}

int DepthTest::shown(float object, float room) const {
    if (!(object > room) || !isDepth(room)) { // in front of the room, or of nothing
        return 255;
    }
    const double tolerance = std::max(m_toleranceM, m_toleranceShare * static_cast<double>(room));
    const double behind = static_cast<double>(object) - static_cast<double>(room);
    if (behind <= tolerance || behind >= 2 * tolerance) {
        return behind <= tolerance ? 255 : 0;
    }
    return static_cast<int>(255 * (2 - behind / tolerance) + 0.5);
}

OverlayLayer::OverlayLayer(const Overlay& overlay, const DepthImage& roomDepth, const ComposeOptions& options,
                           WorkerPool& pool)
    : m_overlay(overlay),
      m_test(options),
      m_edges(options.edges),
      m_spans(static_cast<std::size_t>(overlay.picture.height())) {
    const int height = overlay.picture.height();
    pool.run(height, options.threads, [&](int y, int) { m_spans[static_cast<std::size_t>(y)] = found(y); });
    m_columns = {overlay.picture.width(), 0};
    m_rows = {height, 0};
    for (int y = 0; y < height; ++y) {
        if (span(y).begin < span(y).end) {
            m_columns = {std::min(m_columns.begin, span(y).begin), std::max(m_columns.end, span(y).end)};
            m_rows = {std::min(m_rows.begin, y), y + 1};
        }
    }
    if (roomDepth.empty() || m_rows.begin >= m_rows.end) {
        return;
    }
    const int rows = m_rows.end - m_rows.begin;
    Tested tested(m_columns.end - m_columns.begin, rows);
    std::vector<std::uint8_t> isHidden(static_cast<std::size_t>(rows) + 2); // with a row above and one below
    pool.run(rows, options.threads, [&](int row, int) {
        const bool isInFront = testRow(m_rows.begin + row, roomDepth, tested);
        isHidden[static_cast<std::size_t>(row) + 1] = isInFront ? 0 : 1;
    });
    m_shown = MaskImage(tested.width(), rows);
    pool.run(rows, options.threads, [&](int row, int) {
        const std::uint8_t* above = isHidden.data() + row;
        softenRow(m_rows.begin + row, tested, (above[0] | above[1] | above[2]) != 0);
    });
}

OverlayLayer::Span OverlayLayer::found(int y) const {
    const std::uint8_t* row = m_overlay.picture.at(0, y);
    Span span{0, m_overlay.picture.width()};
    while (span.begin < span.end && row[4 * span.begin + 3] == 0) {
        ++span.begin;
    }
    while (span.begin < span.end && row[4 * span.end - 1] == 0) {
        --span.end;
    }
    return span;
}

float OverlayLayer::depth(int x, int y) const {
    const DepthImage& depth = m_overlay.depth;
    if (isDepth(*depth.at(x, y))) {
        return *depth.at(x, y);
    }
    float nearest = kNoDepth;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, depth.height() - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, depth.width() - 1); ++i) {
            nearest = isDepth(*depth.at(i, j)) ? std::min(nearest, *depth.at(i, j)) : nearest;
        }
    }
    return nearest;
}

bool OverlayLayer::testRow(int y, const DepthImage& roomDepth, Tested& tested) const {
    bool isInFront = true;
    std::int16_t* row = tested.at(0, y - m_rows.begin);
    std::fill_n(row, tested.width(), kNotThere);
    for (int x = span(y).begin; x < span(y).end; ++x) {
        const float object = m_overlay.picture.at(x, y)[3] != 0 ? depth(x, y) : kNoDepth;
        if (isDepth(object)) {
            const int shown = m_test.shown(object, *roomDepth.at(x, y));
            row[x - m_columns.begin] = static_cast<std::int16_t>(shown);
            isInFront = isInFront && shown == 255;
        }
    }
    return isInFront;
}

void OverlayLayer::softenRow(int y, const Tested& tested, bool isHidden) {
    for (int x = span(y).begin; x < span(y).end; ++x) {
        const int own = *tested.at(x - m_columns.begin, y - m_rows.begin);
        if (own != kNotThere && !isHidden) {
            *m_shown.at(x - m_columns.begin, y - m_rows.begin) = 255;
        } else if (own != kNotThere) {
            *m_shown.at(x - m_columns.begin, y - m_rows.begin) =
                static_cast<std::uint8_t>(m_edges == Edges::Soft ? softened(x, y, tested) : own);
        }
    }
}

int OverlayLayer::softened(int x, int y, const Tested& tested) const {
    // Weights 1 6 1 in both directions. Only pixels of the same surface count: where one object ends in front
    // of another, the room's edge is elsewhere.
    const float own = depth(x, y);
    int sum = 0;
    int weights = 0;
    for (int j = std::max(y - 1, m_rows.begin); j <= std::min(y + 1, m_rows.end - 1); ++j) {
        for (int i = std::max(x - 1, m_columns.begin); i <= std::min(x + 1, m_columns.end - 1); ++i) {
            const int value = *tested.at(i - m_columns.begin, j - m_rows.begin);
            if (value != kNotThere && std::abs(depth(i, j) - own) <= kSurfaceStep * own) {
                const int weight = (i == x ? 6 : 1) * (j == y ? 6 : 1);
                sum += weight * value;
                weights += weight;
            }
        }
    }
    return (sum + weights / 2) / weights;
}

void OverlayLayer::add(int x, int y, std::uint64_t weight, float viewDepth, std::uint64_t& heaviest,
                       Shown& sum) const {
    const std::uint8_t* rgba = m_overlay.picture.at(x, y);
    if (rgba[3] == 0 || weight == 0) {
        return;
    }
    const float object = depth(x, y);
    if (!isDepth(object)) {
        return;
    }
    weight *=
        static_cast<std::uint64_t>(m_shown.empty() ? m_test.shown(object, viewDepth)
                                                   : *m_shown.at(x - m_columns.begin, y - m_rows.begin));
    const unsigned factor = m_overlay.alpha == Alpha::Straight ? rgba[3] : 255;
    for (std::size_t c = 0; c < 3; ++c) {
        sum.colour[c] += weight * (factor * rgba[c]);
    }
    sum.coverage += weight * rgba[3];
    if (weight * rgba[3] > heaviest) {
        heaviest = weight * rgba[3];
        sum.depth = object;
    }
}

const std::uint8_t* OverlayLayer::opaque(int x, int y) const {
    const std::uint8_t* rgba = m_overlay.picture.at(x, y);
    const bool isShown = m_shown.empty() || *m_shown.at(x - m_columns.begin, y - m_rows.begin) == 255;
    return rgba[3] == 255 && isShown && isDepth(depth(x, y)) ? rgba : nullptr;
}

Shown OverlayLayer::pixel(int x, int y) const {
    Shown result;
    std::uint64_t heaviest = 0;
    add(x, y, std::uint64_t{OverlayMap::kOne} * OverlayMap::kOne, kNoDepth, heaviest, result);
    return result;
}

Shown OverlayLayer::between(const OverlayMap::Position& position, float viewDepth) const {
    Shown result;
    const int left = position.u >> 8;
    const int top = position.v >> 8;
    const int right = position.u & 0xFF;
    const int below = position.v & 0xFF;
    std::uint64_t heaviest = 0;
    for (const int j : {0, 1}) {
        const int y = std::clamp(top + j, 0, m_overlay.picture.height() - 1); // the rim repeats half a pixel
        if (!span(y).holds(left) && !span(y).holds(left + 1)) {
            continue;
        }
        for (const int i : {0, 1}) {
            const int x = std::clamp(left + i, 0, m_overlay.picture.width() - 1);
            const int weight =
                (i == 1 ? right : OverlayMap::kOne - right) * (j == 1 ? below : OverlayMap::kOne - below);
            add(x, y, static_cast<std::uint64_t>(weight), viewDepth, heaviest, result);
        }
    }
    return result;
}

} // namespace spherewalk::render
