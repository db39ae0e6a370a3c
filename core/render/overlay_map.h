// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/worker_pool.h"
#include "spherewalk/geometry/camera_model.h"

#include <cstdint>
#include <limits>

namespace spherewalk::render {

/// Where a view's pixels fall in a picture taken by another camera from the same pose. Threads: const, any
/// number.
class OverlayMap {
  public:
    static constexpr int kOne = 256; ///< units in a pixel
    static constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::min();

    /// In the other picture's pixels, fixed point; u is kNowhere where it shows nothing of the view's pixel.
    struct Place {
        std::int32_t u;
        std::int32_t v;
    };

    /// Cost: about a microsecond a pixel of the view.
    OverlayMap(const CameraModel& view, const CameraModel& other, WorkerPool& pool, int threads);

    Place at(int x, int y) const {
        const std::int32_t* place = m_places.at(x, y);
        return {place[0], place[1]};
    }

  private:
    Image<std::int32_t, 2> m_places;
};

} // namespace spherewalk::render
