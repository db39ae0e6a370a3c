// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

#include <Eigen/Core>

#include <vector>

namespace spherewalk::scene {

/// What is compared between photos: brightness, its slopes, and red against blue, four values a pixel, in
/// grey levels. One column and one row more than the picture repeat its first column and its last row, so
/// that four neighbours can be read at any place.
class SweepPicture {
  public:
    /// The photo turned, as seen in a frame that the rotation takes to the photo's, at this width. Pixels are
    /// means over what they cover.
    SweepPicture(const RgbImage& photo, const Eigen::Matrix3d& photoFromFrame, int width, int threads);

    int width() const { return m_width; }

    int height() const { return m_width / 2; }

    const float* at(int x, int y) const {
        return m_values.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width + 1) +
                                      static_cast<std::size_t>(x));
    }

    float brightness(int x, int y) const { return at(x, y)[0]; }

    /// Values from one row to the next.
    int stride() const { return 4 * (m_width + 1); }

  private:
    void differentiate(const Image<float, 3>& turned, int y);
    void repeatEdges();

    float* at(int x, int y) { return const_cast<float*>(static_cast<const SweepPicture*>(this)->at(x, y)); }

    int m_width;
    std::vector<float> m_values;
};

} // namespace spherewalk::scene
