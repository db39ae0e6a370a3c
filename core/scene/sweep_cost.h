// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sweep_picture.h"

#include "spherewalk/scene/depth_sweep.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::scene {

/// How well neighbours bear out distances of a photo's pixels, at one size. Threads: const, any number.
class SweepCost {
  public:
    /// The most that a cost can be.
    static constexpr float kMost = 68.8F;

    SweepCost(const PosedPicture& photo, std::span<const PosedPicture> neighbours, double keptShare,
              int width, int threads);

    int width() const { return m_photo.width(); }

    int height() const { return m_photo.height(); }

    const SweepPicture& photo() const { return m_photo; }

    /// Memory of one thread.
    class Scratch {
      public:
        explicit Scratch(const SweepCost& cost);

      private:
        friend class SweepCost;
        std::vector<std::int32_t> m_first; ///< of where a row's pixels are in a neighbour
        std::vector<float> m_right;
        std::vector<float> m_down;
        std::vector<std::vector<float>> m_costs; ///< of each neighbour
    };

    /// The costs of a row's pixels at these inverse distances, a value a pixel. The mean over the neighbours
    /// that fit best.
    void row(int y, const float* inverseM, Scratch& scratch, float* costs) const;

    /// The same for all pixels.
    void all(const Image<float, 1>& inverseM, int threads, const std::stop_token& stop,
             Image<float, 1>& costs) const;

  private:
    struct Neighbour {
        SweepPicture picture; ///< turned as the photo is
        Eigen::Vector3f fromPhotoM;
    };

    void neighbourRow(const Neighbour& neighbour, int y, const float* inverseM, Scratch& scratch,
                      float* costs) const;

    SweepPicture m_photo;
    std::vector<Neighbour> m_neighbours;
    std::size_t m_kept;
    std::vector<float> m_cosAzimuth; ///< of the columns
    std::vector<float> m_sinAzimuth;
    std::vector<float> m_cosElevation; ///< of the rows
    std::vector<float> m_sinElevation;
};

} // namespace spherewalk::scene
