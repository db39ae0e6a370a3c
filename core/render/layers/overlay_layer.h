// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace spherewalk::render {

/// Whether the depth says that an object is there.
inline bool isDepth(float depth) {
    return depth > 0 && std::isfinite(depth);
}

/// Where a view's pixels fall in a picture that another camera took from the same pose. Threads: const
/// functions may run on any number at a time.
class OverlayMap {
  public:
    static constexpr int kOne = 256; ///< Units of fixed point in a pixel.
    static constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::min();

    /// A position in the other picture, in fixed point. u is kNowhere where the picture does not show the
    /// view's pixel.
    struct Position {
        std::int32_t u;
        std::int32_t v;
    };

    /// Cost: about a microsecond a pixel of the view.
    OverlayMap(const CameraModel& view, const CameraModel& other, WorkerPool& pool, int threads);

    const Position& at(int x, int y) const { return row(y)[static_cast<std::size_t>(x)]; }

    std::span<const Position> row(int y) const {
        const auto width = static_cast<std::size_t>(m_width);
        return std::span(m_positions).subspan(static_cast<std::size_t>(y) * width, width);
    }

  private:
    int m_width;
    std::vector<Position> m_positions;
};

/// What an overlay shows in one pixel of the view, in integers, so that nothing is rounded before the end.
struct Shown {
    static constexpr std::uint64_t kWhole = 65536ULL * 255 * 255; ///< The coverage of an opaque pixel.

    std::array<std::uint64_t, 3> colour{}; ///< Premultiplied colours, at most kWhole * 255.
    std::uint64_t coverage = 0;
    float depth = 0;         ///< The depth of the pixel that contributes most.
    std::uint16_t label = 0; ///< The number of the object in that pixel.
};

/// Compares depths with the tolerance of ComposeOptions.
class DepthTest {
  public:
    explicit DepthTest(const ComposeOptions& options)
        : m_toleranceM(options.toleranceM), m_toleranceShare(options.toleranceShare) {}

    /// How much of an object is shown, in [0, 255]. object: a valid depth. room: any value.
    int shown(float object, float room) const;

  private:
    double m_toleranceM;
    double m_toleranceShare;
};

/// An overlay, and how much of each of its pixels the room lets through. Owner: the overlay must outlive
/// it. Threads: const functions may run on any number at a time.
class OverlayLayer {
  public:
    /// How a view's pixels find what an overlay shows.
    enum class Lookup {
        OneForOne, ///< The overlay's pixels are those of the view.
        Between,   ///< Another camera took the overlay.
    };

    /// roomDepth: the room's depth for each pixel of the overlay; empty if only the view's pixels have it.
    /// number: of the object, where the overlay has no labels.
    OverlayLayer(const Overlay& overlay, const DepthImage& roomDepth, Lookup lookup, std::uint16_t number,
                 const ComposeOptions& options, WorkerPool& pool);

    /// Pixels or rows that may show an object. There are none if begin >= end.
    struct Span {
        int begin;
        int end;

        bool holds(int value) const { return value >= begin && value < end; }
    };

    Span span(int y) const { return m_spans[static_cast<std::size_t>(y)]; }

    /// What one of the overlay's own pixels shows. Without a roomDepth it is in front of everything.
    Shown pixel(int x, int y) const;

    /// The first of a row's pixels from x on that may not hide all that is behind it; at most `end`.
    int opaqueEnd(int x, int end, int y) const;

    /// The first of a row's positions from x on about which not all four pixels surely hide what is behind
    /// them; at most `end`. viewDepth: as in between(), for the row; null if it is not known.
    int opaqueEnd(std::span<const OverlayMap::Position> row, int x, int end, const float* viewDepth) const;

    const RgbaImage& picture() const { return m_overlay.picture; }

    /// The number of the object in one of the overlay's own pixels.
    std::uint16_t label(int x, int y) const {
        return m_overlay.labels.empty() ? m_number : *m_overlay.labels.at(x, y);
    }

    /// False only where between() surely shows nothing.
    bool mayShow(const OverlayMap::Position& position) const {
        const int x = position.u >> 8;
        const int y = position.v >> 8;
        if (x + 1 < m_columns.begin || x >= m_columns.end || y + 1 < m_rows.begin || y >= m_rows.end) {
            return false;
        }
        const Span& upper = m_spans[static_cast<std::size_t>(std::max(y, 0))];
        const Span& lower =
            m_spans[static_cast<std::size_t>(std::min(y + 1, static_cast<int>(m_spans.size()) - 1))];
        return x + 1 >= std::min(upper.begin, lower.begin) && x < std::max(upper.end, lower.end);
    }

    /// What the overlay shows between its pixels, bilinearly. viewDepth: the room's depth at the view's
    /// pixel, for a layer without a roomDepth. Range: not OverlayMap::kNowhere.
    Shown between(const OverlayMap::Position& position, float viewDepth) const;

  private:
    using Tested =
        Image<std::int16_t, 1>; ///< Values in [0, 255], or kNotThere, in the box around the objects.

    float depth(int x, int y) const;
    Span found(int y) const;
    /// Whether the room hides no part of the row's objects.
    bool testRow(int y, const DepthImage& roomDepth, Tested& tested) const;
    /// isHidden: whether the room hides some of this row or of those beside it.
    void softenRow(int y, const Tested& tested, bool isHidden);
    bool isPlainlyInFront(int x, int y, const DepthImage& roomDepth) const;
    void test(const DepthImage& roomDepth, const ComposeOptions& options, WorkerPool& pool);
    bool isOpaque(int x, int y) const;
    void solidRow(int y, float* depths) const;
    void findSolids(const ComposeOptions& options, WorkerPool& pool);
    int softened(int x, int y, const Tested& tested) const;
    void add(int x, int y, std::uint64_t weight, float viewDepth, std::uint64_t& heaviest, Shown& sum) const;

    const Overlay& m_overlay;
    std::uint16_t m_number;
    DepthTest m_test;
    Edges m_edges;
    std::vector<Span> m_spans; ///< One a row.
    Span m_columns{0, 0};      ///< The box around the objects.
    Span m_rows{0, 0};
    MaskImage m_shown; ///< The size is that of the box. It is empty if only the view's pixels have the room's
                       ///< depth.
    /// The greatest depth of the four pixels from each one to the right and down, if all hide what is behind
    /// them; else +infinity. The size is that of the box; it is empty without Lookup::Between.
    Image<float, 1> m_solid;
};

} // namespace spherewalk::render
