// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/load_counters.h"
#include "spherewalk/render/view.h"

#include <cstdint>
#include <memory>

namespace spherewalk::render {

class ViewEngine;

/// When the SHA-256 of a photo is compared with that of dataset.json.
enum class VerifyPhotos {
    AtOpen,       ///< the dataset was opened with Verify::Hashes: all are verified already
    BeforeUse,    ///< when a photo is first used; the view waits for it
    InBackground, ///< by a ViewStream some time after a photo was first used; a view made before then is not
                  ///< verified, and its report says so
};

struct RendererOptions {
    std::uint64_t cacheBytes = 512ULL << 20; ///< for decoded pixels; those in use are kept in any case
    VerifyPhotos verify = VerifyPhotos::BeforeUse;
};

/// Answers "what does my camera see from here?" from the nearest photo, of which only the part that the view
/// shows is decoded. Threads: render() may be called from any; copies share all they have.
class Renderer {
  public:
    explicit Renderer(std::shared_ptr<const Dataset> dataset, const RendererOptions& options = {});

    /// Waits for what is not decoded yet. roomFromCamera: of the camera's optical frame. Errors: InvalidInput
    /// for a pose that is not finite, or a scene model that the dataset does not have; those of reading and
    /// decoding the photo.
    View render(const CameraModel& camera, const Rigid3& roomFromCamera,
                const ViewOptions& options = {}) const;

    /// The same into a view whose memory is used again. On an error it is left as it was, or half made.
    void render(const CameraModel& camera, const Rigid3& roomFromCamera, const ViewOptions& options,
                View& view) const;

    const Dataset& dataset() const;

    /// Of all views and streams since the renderer was made.
    LoadCounters counters() const;

  private:
    friend class ViewStream;
    std::shared_ptr<ViewEngine> m_engine;
};

} // namespace spherewalk::render
