// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plane_filters.h"
#include "vector_math.h"

#include "spherewalk/base/image.h"
#include "spherewalk/scene/depth_sweep.h"
#include "spherewalk/scene/exposure.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::scene {

/// The colour at a place, interpolated bilinearly. Range: as fastPixel() returns. rgb: three values.
void sampleColour(const RgbImage& photo, float u, float v, float* rgb);

/// The values that are compared between photos: brightness, its two slopes, and red minus blue. Units: grey
/// levels. Shape: four values a pixel; one column and one row more than the picture repeat its first column
/// and its last row, so that four neighbours can be read at any place.
class SweepPicture {
  public:
    /// The photo as seen in another frame, at this width. The rotation takes the frame to the photo's frame.
    /// Pixels are means over the area that they cover, times the gains, but never brighter than white.
    SweepPicture(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width, int threads,
                 const Gains& gains = {1, 1, 1});

    int width() const { return m_width; }

    int height() const { return m_width / 2; }

    const float* at(int x, int y) const {
        return m_values.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width + 1) +
                                      static_cast<std::size_t>(x));
    }

    float brightness(int x, int y) const { return at(x, y)[0]; }

    /// Number of values from one row to the next.
    int stride() const { return 4 * (m_width + 1); }

  private:
    void differentiate(const Image<float, 3>& turned, int y);
    void repeatEdges();

    float* at(int x, int y) { return const_cast<float*>(static_cast<const SweepPicture*>(this)->at(x, y)); }

    int m_width;
    std::vector<float> m_values;
};

/// The values of a plane in another frame, each the nearest one. Shape: as that of a SweepPicture, one column
/// and one row more.
std::vector<float> turnedValues(const Image<float, 1>& plane, const Eigen::Matrix3d& planeFromFrame,
                                int threads);

/// How well neighbours confirm distances of a photo's pixels, at one size. Low costs are good. If the
/// neighbours' own depths are known, a neighbour has no say in a place that something nearer hides from it. A
/// place through which a neighbour sees costs more, and so does one that is hidden from some. Threads: const,
/// any number.
class SweepCost {
  public:
    /// Upper bound of a cost without depths.
    static constexpr float kMost = 68.8F;

    /// gains: one of each neighbour; none if no photo is brighter than the others. depths: 1 / distance of
    /// each neighbour's pixels, in the neighbour's own frame and of this width; none if they are not known.
    SweepCost(const PosedPicture& photo, std::span<const PosedPicture> neighbours, double keptShare,
              int width, int threads, std::span<const Gains> gains = {},
              std::span<const Image<float, 1>* const> depths = {});

    int width() const { return m_photo.width(); }

    int height() const { return m_photo.height(); }

    const SweepPicture& photo() const { return m_photo; }

    /// Some of a row's pixels. Range: their number is a multiple of 8.
    struct RowPart {
        int y;
        int begin;
        int end;

        int count() const { return end - begin; }
    };

    /// Working memory of one thread.
    class Scratch {
      public:
        /// For so many costs at a time.
        Scratch(const SweepCost& cost, int values);

      private:
        friend class SweepCost;
        std::vector<float> m_u; ///< Where a neighbour shows the pixels of all layers.
        std::vector<float> m_v;
        std::vector<std::int32_t> m_first; ///< The values about those of one layer.
        std::vector<float> m_right;
        std::vector<float> m_down;
        std::vector<std::vector<float>> m_costs; ///< By each neighbour.
        std::vector<float> m_hidden;             ///< From how many neighbours the places are hidden.
        std::vector<float> m_seen;               ///< A neighbour's own 1 / distance at a row's places,
        std::vector<float> m_expected;           ///< and that of the row's things.
    };

    /// How the inverse distances of layers follow each other.
    enum class Order {
        Any,
        BySteps, ///< Evenly: from one layer to the next things move by about a pixel.
    };

    /// The costs of pixels at several inverse distances each: the mean over the neighbours that fit best.
    /// Shape: inverseM and costs have a row of pixels for each layer.
    void at(const RowPart& part, int layers, const float* inverseM, Order order, Scratch& scratch,
            float* costs) const;

    /// The costs of all pixels at one or several inverse distances each. Several at a time take less than one
    /// after the other. Errors: Stopped.
    void all(std::span<const Image<float, 1>> inverseM, int threads, const std::stop_token& stop,
             std::span<Image<float, 1>> costs) const;

  private:
    struct Neighbour {
        SweepPicture picture; ///< Turned as the photo is.
        NeighbourLenses lenses;
        std::vector<float> inverseM; ///< 1 / distance, turned likewise; empty if it is not known.
    };

    /// Where a neighbour shows all layers' pixels. Between layers that are located exactly, the others'
    /// places are interpolated; near the poles, all are exact. If the other lens shows the thing from one
    /// layer to the next, what lies between is off by half of what that moves it.
    void locateLayers(const Neighbour& neighbour, const RowPart& part, int layers, const float* inverseM,
                      int exactEvery, Scratch& scratch) const;
    void neighbourCosts(const Neighbour& neighbour, const RowPart& part, int layer, const float* inverseM,
                        Scratch& scratch, float* hidden, float* costs) const;
    void meanOfSeen(const Scratch& scratch, std::size_t values, float* costs) const;
    void meanOfKept(const Scratch& scratch, std::size_t values, float* costs) const;

    SweepPicture m_photo;
    std::vector<Neighbour> m_neighbours;
    double m_keptShare;
    std::size_t m_kept;
    bool m_knowsDepth;
    PixelAngles m_angles;
};

/// A cost for each pixel and each distance that is tried. Shape: [y][x][distance].
template <class Value>
struct CostVolume {
    CostVolume(int widthPx, int heightPx, int distanceCount)
        : width(widthPx),
          height(heightPx),
          distances(distanceCount),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                 static_cast<std::size_t>(distances)) {}

    Value* at(int x, int y) {
        return values.data() +
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(distances);
    }

    const Value* at(int x, int y) const { return const_cast<CostVolume*>(this)->at(x, y); }

    int width;
    int height;
    int distances;
    std::vector<Value> values;
};

/// The same costs, each smoothed over the 3 x 3 pixels about it, though not across edges of the photo. Wider
/// windows would widen near things. Threads: const, any number.
class SmoothCost {
  public:
    SmoothCost(SweepCost cost, int threads);

    int width() const { return m_cost.width(); }

    int height() const { return m_cost.height(); }

    const SweepPicture& photo() const { return m_cost.photo(); }

    /// A plane of costs for each of inverse distances. Errors: Stopped.
    std::vector<Plane> all(std::span<const Plane> inverseM, const std::stop_token& stop) const;

  private:
    SweepCost m_cost;
    GuidedFilter m_filter;
    int m_threads;
};

/// The cost of a change of distance from one pixel to the next.
struct PathPenalties {
    float step = 6;  ///< To the next distance.
    float jump = 60; ///< To any other distance; less at edges of the picture, at least 1.5 steps.
};

/// The costs summed along eight paths to each pixel (semi-global matching). Horizontal paths cross the seam.
/// threads: the result is the same for any number. Errors: Stopped.
/// Source: Hirschmueller 2008.
CostVolume<std::int16_t> aggregatedOverPaths(const CostVolume<std::uint8_t>& costs, const SweepPicture& guide,
                                             const PathPenalties& penalties, int threads,
                                             const std::stop_token& stop);

} // namespace spherewalk::scene
