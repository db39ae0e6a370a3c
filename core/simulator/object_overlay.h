// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/parallel.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/render/overlay.h"
#include "spherewalk/render/pixel_rays.h"
#include "spherewalk/simulator/camera_options.h"

#include <array>
#include <optional>

namespace spherewalk::simulator {

/// Makes an overlay from a simulator's pictures that shows nothing but the objects. Threads: one at a time.
class ObjectOverlay {
  public:
    /// camera: the camera that took the pictures. withLabels: whether overlays have the objects' labels.
    /// Errors: InvalidInput for ObjectsBy::Depth with a dataset that has no outline or no ceiling.
    ObjectOverlay(const OverlayOptions& options, bool withLabels, const render::DatasetInfo& dataset,
                  const CameraIntrinsics& camera, int threads);

    const CameraIntrinsics& camera() const { return m_camera; }

    /// The overlay of these pictures. The simulator's model of the room hides objects. The view's scene model
    /// hides them too if it has surfaces, or with ObjectsBy::Alone. Range: whole parts of the camera's size.
    render::Overlay overlay(OverlayParts parts, const Rigid3& roomFromCamera, render::SceneKind scene);

  private:
    template <class IsObject>
    void show(const OverlayParts& parts, const IsObject& isObject, render::Overlay& overlay);
    bool isNearer(float depth, const Rigid3& roomFromCamera, int x, int y) const;

    OverlayOptions m_options;
    bool m_withLabels;
    CameraIntrinsics m_camera;
    int m_threads;
    WorkerPool m_pool;
    std::array<bool, 256> m_isRoom{}; ///< Index: label.
    DepthImage m_nothing;             ///< The depth of a room that hides nothing.
    render::RoomShape m_room;         ///< Set with ObjectsBy::Depth.
    std::optional<render::PixelRays> m_rays;
};

} // namespace spherewalk::simulator
