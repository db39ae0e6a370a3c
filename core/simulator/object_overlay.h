// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/worker_pool.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/render/overlay.h"
#include "spherewalk/render/pixel_rays.h"
#include "spherewalk/simulator/overlay_options.h"

#include <array>
#include <optional>

namespace spherewalk::simulator {

/// Makes of a simulator's pictures an overlay that shows its objects and nothing else. Threads: one at a
/// time.
class ObjectOverlay {
  public:
    /// camera: that took the pictures. Errors: InvalidInput for ObjectsBy::Depth with a dataset that has no
    /// outline or no ceiling.
    ObjectOverlay(const OverlayOptions& options, const render::DatasetInfo& dataset,
                  const CameraIntrinsics& camera, int threads);

    const CameraIntrinsics& camera() const { return m_camera; }

    /// Range: parts that are whole, of the camera's size.
    render::Overlay overlay(OverlayParts parts, const Rigid3& roomFromCamera);

  private:
    bool isObject(const OverlayParts& parts, const Rigid3& roomFromCamera, int x, int y) const;
    bool isNearer(float depth, const Rigid3& roomFromCamera, int x, int y) const;

    OverlayOptions m_options;
    CameraIntrinsics m_camera;
    int m_threads;
    WorkerPool m_pool;
    std::array<bool, 256> m_isRoom{}; ///< of each label
    render::RoomShape m_room;         ///< ObjectsBy::Depth
    std::optional<render::PixelRays> m_rays;
};

} // namespace spherewalk::simulator
