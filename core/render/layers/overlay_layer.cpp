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
/// Pixels side by side that are looked at together first, since most of them are alike.
constexpr int kTogether = 16;

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
    : m_width(view.width()),
      m_positions(static_cast<std::size_t>(view.width()) * static_cast<std::size_t>(view.height())) {
    pool.run(view.height(), threads, [&](int y, int) {
        for (int x = 0; x < view.width(); ++x) {
            m_positions[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                        static_cast<std::size_t>(x)] = positionOf(Vector2d(x, y), view, other);
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

OverlayLayer::OverlayLayer(const Overlay& overlay, const DepthImage& roomDepth, Lookup lookup,
                           std::uint16_t number, const ComposeOptions& options, WorkerPool& pool)
    : m_overlay(overlay),
      m_number(number),
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
    if (m_rows.begin >= m_rows.end) {
        return;
    }
    if (!roomDepth.empty()) {
        test(roomDepth, options, pool);
    }
    if (lookup == Lookup::Between) {
        findSolids(options, pool);
    }
}

void OverlayLayer::test(const DepthImage& roomDepth, const ComposeOptions& options, WorkerPool& pool) {
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

/// The depths of a row of the box where pixels hide all that is behind them; else +infinity.
void OverlayLayer::solidRow(int y, float* depths) const {
    const int width = m_columns.end - m_columns.begin;
    const std::uint8_t* rgba = m_overlay.picture.at(m_columns.begin, y);
    const float* own = m_overlay.depth.at(m_columns.begin, y);
    for (int x = 0; x < width; ++x) {
        depths[x] = rgba[4 * x + 3] == 255 && own[x] > 0 ? own[x] : kNoDepth;
    }
    const std::uint8_t* shown = m_shown.empty() ? nullptr : m_shown.at(0, y - m_rows.begin);
    for (int x = 0; x < width && shown != nullptr; ++x) {
        depths[x] = shown[x] == 255 ? depths[x] : kNoDepth;
    }
}

void OverlayLayer::findSolids(const ComposeOptions& options, WorkerPool& pool) {
    const int width = m_columns.end - m_columns.begin;
    m_solid = Image<float, 1>(width, m_rows.end - m_rows.begin);
    pool.run(m_solid.height(), options.threads, [&](int row, int) {
        std::vector<float> upper(static_cast<std::size_t>(width) + 1, kNoDepth);
        std::vector<float> lower(upper);
        solidRow(m_rows.begin + row, upper.data());
        if (row + 1 < m_solid.height()) {
            solidRow(m_rows.begin + row + 1, lower.data());
        }
        float* solid = m_solid.at(0, row);
        for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
            solid[x] = std::max(std::max(upper[x], upper[x + 1]), std::max(lower[x], lower[x + 1]));
        }
    });
}

OverlayLayer::Span OverlayLayer::found(int y) const {
    const std::uint8_t* row = m_overlay.picture.at(0, y);
    const auto isClear = [&](int begin) {
        unsigned any = 0;
        for (int i = 0; i < kTogether; ++i) {
            any |= row[4 * (begin + i) + 3];
        }
        return any == 0;
    };
    Span span{0, m_overlay.picture.width()};
    while (span.begin + kTogether <= span.end && isClear(span.begin)) {
        span.begin += kTogether;
    }
    while (span.begin < span.end && row[4 * span.begin + 3] == 0) {
        ++span.begin;
    }
    while (span.begin + kTogether <= span.end && isClear(span.end - kTogether)) {
        span.end -= kTogether;
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

/// Whether kTogether pixels have objects with depths, and the room has none that is nearer. If this is
/// false, each pixel must be tested by itself.
bool OverlayLayer::isPlainlyInFront(int x, int y, const DepthImage& roomDepth) const {
    const std::uint8_t* rgba = m_overlay.picture.at(x, y);
    const float* objects = m_overlay.depth.at(x, y);
    const float* rooms = roomDepth.at(x, y);
    int plain = 0;
    for (int i = 0; i < kTogether; ++i) {
        const bool isThere = rgba[4 * i + 3] != 0 && objects[i] > 0 && objects[i] < kNoDepth;
        plain += isThere && objects[i] <= rooms[i] ? 1 : 0;
    }
    return plain == kTogether;
}

bool OverlayLayer::testRow(int y, const DepthImage& roomDepth, Tested& tested) const {
    bool isInFront = true;
    std::int16_t* row = tested.at(0, y - m_rows.begin);
    std::fill_n(row, tested.width(), kNotThere);
    for (int x = span(y).begin; x < span(y).end; ++x) {
        if (x + kTogether <= span(y).end && isPlainlyInFront(x, y, roomDepth)) {
            std::fill_n(row + (x - m_columns.begin), kTogether, std::int16_t{255});
            x += kTogether - 1;
            continue;
        }
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
    const std::int16_t* own = tested.at(0, y - m_rows.begin);
    std::uint8_t* shown = m_shown.at(0, y - m_rows.begin);
    if (!isHidden) {
        for (int x = 0; x < tested.width(); ++x) {
            shown[x] = own[x] == kNotThere ? std::uint8_t{0} : std::uint8_t{255};
        }
        return;
    }
    for (int x = span(y).begin; x < span(y).end; ++x) {
        const int value = own[x - m_columns.begin];
        if (value != kNotThere) {
            shown[x - m_columns.begin] =
                static_cast<std::uint8_t>(m_edges == Edges::Soft ? softened(x, y, tested) : value);
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
        sum.label = label(x, y);
    }
}

bool OverlayLayer::isOpaque(int x, int y) const {
    const bool isShown = m_shown.empty() || *m_shown.at(x - m_columns.begin, y - m_rows.begin) == 255;
    return m_overlay.picture.at(x, y)[3] == 255 && isShown && isDepth(depth(x, y));
}

int OverlayLayer::opaqueEnd(int x, int end, int y) const {
    const auto areOpaque = [&](int begin) {
        const std::uint8_t* rgba = m_overlay.picture.at(begin, y);
        const std::uint8_t* shown = m_shown.at(begin - m_columns.begin, y - m_rows.begin);
        unsigned all = 255;
        for (int i = 0; i < kTogether; ++i) {
            all &= rgba[4 * i + 3] & shown[i];
        }
        return all == 255;
    };
    while (!m_shown.empty() && x + kTogether <= end && areOpaque(x)) {
        x += kTogether;
    }
    while (x < end && isOpaque(x, y)) {
        ++x;
    }
    return x;
}

int OverlayLayer::opaqueEnd(std::span<const OverlayMap::Position> row, int x, int end,
                            const float* viewDepth) const {
    const auto width = static_cast<unsigned>(m_solid.width());
    const auto height = static_cast<unsigned>(m_solid.height());
    const float* solids = m_solid.values().data();
    for (; x < end; ++x) {
        const OverlayMap::Position& at = row[static_cast<std::size_t>(x)];
        const auto column = static_cast<unsigned>((at.u >> 8) - m_columns.begin);
        const auto line = static_cast<unsigned>((at.v >> 8) - m_rows.begin);
        if (column >= width || line >= height) {
            break;
        }
        const float solid = solids[std::size_t{line} * width + column];
        const float room = viewDepth != nullptr && m_shown.empty() ? viewDepth[x] : 0;
        if (!(solid < kNoDepth) || (solid > room && isDepth(room))) {
            break;
        }
    }
    return x;
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
