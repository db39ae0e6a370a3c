// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "overlay_map.h"

#include "spherewalk/render/overlay.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace spherewalk::render {

/// Whether a depth says that something is there.
inline bool isDepth(float depth) {
    return depth > 0 && std::isfinite(depth);
}

/// What an overlay shows in one pixel of the view, in integers, so that nothing is rounded before the end.
struct Shown {
    static constexpr std::uint64_t kWhole = 65536ULL * 255 * 255; ///< coverage of an opaque pixel

    std::array<std::uint64_t, 3> colour{}; ///< premultiplied: kWhole * 255 at most
    std::uint64_t coverage = 0;
    float depth = 0; ///< of what contributes most
};

/// Compares depths; see ComposeOptions for the tolerance.
class DepthTest {
  public:
    explicit DepthTest(const ComposeOptions& options)
        : m_toleranceM(options.toleranceM), m_toleranceShare(options.toleranceShare) {}

    /// How much of an object is shown, in [0, 255]. Range: `object` is a depth.
    int shown(float object, float room) const;

  private:
    double m_toleranceM;
    double m_toleranceShare;
};

/// An overlay, and how much of each of its pixels the room lets through. Owner: refers to the overlay.
/// Threads: const, any number.
class OverlayLayer {
  public:
    /// roomDepth: pixel for pixel with the overlay; empty if only the view's pixels know it.
    OverlayLayer(const Overlay& overlay, const DepthImage& roomDepth, const ComposeOptions& options,
                 WorkerPool& pool);

    /// Pixels or rows that may show something; none if begin >= end.
    struct Span {
        int begin;
        int end;

        bool holds(int value) const { return value >= begin && value < end; }
    };

    Span span(int y) const { return m_spans[static_cast<std::size_t>(y)]; }

    /// One of the overlay's own pixels; of a layer without a roomDepth, in front of everything.
    Shown pixel(int x, int y) const;

    /// False where between() shows nothing for certain.
    bool mayShow(const OverlayMap::Place& place) const {
        const int x = place.u >> 8;
        const int y = place.v >> 8;
        return x + 1 >= m_columns.begin && x < m_columns.end && y + 1 >= m_rows.begin && y < m_rows.end;
    }

    /// Bilinear between pixels. viewDepth: of the room at the view's pixel, for layers without a roomDepth.
    /// Range: not OverlayMap::kNowhere.
    Shown between(const OverlayMap::Place& place, float viewDepth) const;

  private:
    using Tested = Image<std::int16_t, 1>; ///< in [0, 255], or kNotThere; of the box around the objects

    float depth(int x, int y) const;
    Span found(int y) const;
    void testRow(int y, const DepthImage& roomDepth, Tested& tested) const;
    void softenRow(int y, const Tested& tested);
    int softened(int x, int y, const Tested& tested) const;
    void add(int x, int y, std::uint64_t weight, float viewDepth, std::uint64_t& heaviest, Shown& sum) const;

    const Overlay& m_overlay;
    DepthTest m_test;
    Edges m_edges;
    std::vector<Span> m_spans; ///< of each row
    Span m_columns{0, 0};      ///< the box around the objects
    Span m_rows{0, 0};
    MaskImage m_shown; ///< of the box; empty if only the view's pixels know the room's depth
};

} // namespace spherewalk::render
