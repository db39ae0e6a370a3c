// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/sampling.h"

#include <memory>
#include <optional>

namespace spherewalk::render {

class PhotoPlane;

/// A decoded photo to be looked at by itself, without a dataset. Threads: const, any number; copies share the
/// pixels.
class Panorama {
  public:
    /// Errors: Unsupported for a picture that is not twice as wide as high, or not 16 to 16384 pixels wide.
    explicit Panorama(const RgbImage& photo);

    EquirectSize size() const;

  private:
    friend class PanoramaRenderer;
    std::shared_ptr<const PhotoPlane> m_plane;
};

/// Where a panorama was taken, and how far things are taken to be.
struct PanoramaPlace {
    Rigid3 roomFromPhoto;
    /// Of the sphere that a camera beside the photo sees it on; nothing: things are infinitely far.
    std::optional<double> sphereRadiusM;
};

/// Views of single photos with the renderer's fast path. Threads: one view at a time.
class PanoramaRenderer {
  public:
    /// threads: 0: all that the machine has; the pixels are the same for any number.
    explicit PanoramaRenderer(int threads = 0);
    ~PanoramaRenderer();
    PanoramaRenderer(PanoramaRenderer&&) noexcept;
    PanoramaRenderer& operator=(PanoramaRenderer&&) noexcept;

    /// Into a picture whose memory is used again. roomFromCamera: of the camera's optical frame. sampling:
    /// Auto and Reduced are taken as Bilinear, as there is no half of the photo. Errors: InvalidInput for
    /// poses or a radius that are none.
    void render(const Panorama& photo, const PanoramaPlace& place, const CameraModel& camera,
                const Rigid3& roomFromCamera, Sampling sampling, RgbImage& picture);

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::render
