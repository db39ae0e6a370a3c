// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ray_table.h"
#include "tile_footprint.h"

#include <list>
#include <memory>
#include <mutex>

namespace spherewalk::render {

/// What is computed once for a camera.
struct CameraTable {
    std::shared_ptr<const RayTable> rays;
    std::shared_ptr<const ViewFootprint> footprint;
};

/// The tables of the cameras used last. Threads: any.
class CameraTables {
  public:
    /// samplesPerAxis: of the rays. Cost: some milliseconds for a lens that is new, next to nothing
    /// afterwards.
    CameraTable get(const CameraModel& camera, int samplesPerAxis);

  private:
    struct Entry {
        CameraIntrinsics camera;
        CameraTable table;
    };

    std::mutex m_mutex;
    std::list<Entry> m_entries; ///< most recently used first
};

} // namespace spherewalk::render
