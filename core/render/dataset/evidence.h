// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dataset/depth_steps.h"

#include "spherewalk/geometry/equirect.h"

#include <cstdint>
#include <vector>

namespace spherewalk::render {

/// What a photo's depth says in one direction, and how sure it is.
struct KnownDepth {
    double inverseM = 0; ///< 1 / distance in 1/m.
    double spreadM = 0;  ///< The greatest minus the least 1 / distance within two degrees.
    bool isSure = false;
    bool isAmongSure = false; ///< Whether everything within a degree is sure.
};

/// A photo's depth at up to 512 pixels in width, with what tells how exact it is. Frames: the photo's.
/// Threads: const functions may run on any number at a time.
class DepthEvidence {
  public:
    explicit DepthEvidence(const DepthSteps& depth);

    /// The size of the equirectangular picture whose coordinates at() takes.
    const EquirectSize& size() const { return m_size; }

    /// What the depth says at a place of that picture. Any other numbers, and what is none, give what some
    /// place says.
    KnownDepth at(double u, double v) const;

    /// The angle of a pixel of the depth.
    double pixelRad() const { return m_pixelRad; }

  private:
    static constexpr int kWidth = 512;

    /// Steps of DepthMap::kStepPerM, times two; plus one if the pixel is sure, or all around it is.
    struct Cell {
        std::uint16_t inverse;
        std::uint16_t spread;
    };

    double m_pixelRad;
    EquirectSize m_size;
    std::vector<Cell> m_cells;
};

} // namespace spherewalk::render
