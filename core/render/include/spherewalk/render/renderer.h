// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/view.h"

#include <cstdint>
#include <memory>
#include <string>

namespace spherewalk::render {

class ViewEngine;

struct RendererOptions {
    std::uint64_t cacheBytes = 512ULL
                               << 20; ///< The budget for decoded pixels. Pixels in use stay in any case.
    VerifyPhotos verify = VerifyPhotos::BeforeUse;
};

/// Answers "what does my camera see from here?" from the nearest photo, or from the three nearest for scene
/// models with surfaces. Only the part of a photo that the view shows is decoded. Threads: render() may be
/// called from any; copies share all that they have.
class Renderer {
  public:
    explicit Renderer(std::shared_ptr<const Dataset> dataset, const RendererOptions& options = {});

    /// The view of a camera. It waits for what is not decoded yet. roomFromCamera: the pose of the camera's
    /// optical frame. Errors: InvalidInput for a pose that is not finite and a scene model that the dataset
    /// does not have; NotFound, Io and Corrupt for the photo.
    View render(const CameraModel& camera, const Rigid3& roomFromCamera,
                const ViewOptions& options = {}) const;

    /// The same into a view whose memory is used again. After an error the view is as before or half made.
    void render(const CameraModel& camera, const Rigid3& roomFromCamera, const ViewOptions& options,
                View& view) const;

    const Dataset& dataset() const;

    /// The sums over all views and streams since the renderer was made.
    LoadCounters counters() const;

  private:
    friend class ViewStream;
    std::shared_ptr<ViewEngine> m_engine;
};

/// The processor's instructions that views are made with on this machine, as Highway calls them: "AVX2". The
/// pixels are the same with any.
std::string simdTarget();

} // namespace spherewalk::render
