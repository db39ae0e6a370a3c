// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fast_view.h"

#include "spherewalk/base/worker_pool.h"

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>

namespace spherewalk::render {

/// The ray tables of the cameras used last. Threads: any.
class RayTables {
  public:
    /// Cost: some milliseconds for a lens that is new, next to nothing afterwards.
    std::shared_ptr<const RayTable> get(const CameraModel& camera, int samplesPerAxis);

  private:
    struct Entry {
        CameraIntrinsics camera;
        int samplesPerAxis;
        std::shared_ptr<const RayTable> table;
    };

    std::mutex m_mutex;
    std::list<Entry> m_entries; ///< most recently used first
};

/// The planes of the pictures used last, whole and halved, each made when it is first wanted. Threads: any.
class Planes {
  public:
    std::shared_ptr<const PhotoPlane> whole(const std::shared_ptr<const RgbImage>& picture);

    /// Nothing if the picture cannot be halved.
    std::shared_ptr<const PhotoPlane> half(const std::shared_ptr<const RgbImage>& picture);

  private:
    struct Entry {
        std::weak_ptr<const RgbImage> picture;
        std::shared_ptr<const PhotoPlane> whole;
        std::shared_ptr<const PhotoPlane> half;
    };

    Entry& entry(const std::shared_ptr<const RgbImage>& picture);

    std::mutex m_mutex;
    std::list<Entry> m_entries; ///< most recently used first
};

} // namespace spherewalk::render
