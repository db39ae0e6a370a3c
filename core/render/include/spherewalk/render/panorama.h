// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/ladder.h"

#include <memory>
#include <optional>

namespace spherewalk::render {

class PhotoPlane;

/// A decoded photo to be viewed by itself, without a dataset. Threads: const functions may run on any number
/// at a time. Copies share the pixels.
class Panorama {
  public:
    /// Errors: Unsupported for a picture that is not twice as wide as high, or not 16 to 16384 pixels wide.
    explicit Panorama(const RgbImage& photo);

    EquirectSize size() const;

  private:
    friend class PanoramaRenderer;
    std::shared_ptr<const PhotoPlane> m_plane;
};

/// The pose of a panorama, and the distance of the things around it.
struct PanoramaScene {
    Rigid3 roomFromPhoto;
    /// The radius of the sphere of things, for a camera beside the photo. Without it things are infinitely
    /// far.
    std::optional<double> sphereRadiusM;
};

/// Views of single photos by the renderer's fast path. Threads: one view at a time.
class PanoramaRenderer {
  public:
    /// threads: the most to use, 0 for all that the machine has. The pixels are the same for any number.
    explicit PanoramaRenderer(int threads = 0);
    ~PanoramaRenderer();
    PanoramaRenderer(PanoramaRenderer&&) noexcept;
    PanoramaRenderer& operator=(PanoramaRenderer&&) noexcept;

    /// Makes a view into a picture whose memory is used again. roomFromCamera: the pose of the camera's
    /// optical frame. sampling: Auto and Reduced are taken as Bilinear, as the photo is not there at half its
    /// size. Errors: InvalidInput for poses that are not finite and a radius that is not above zero.
    void render(const Panorama& photo, const PanoramaScene& scene, const CameraModel& camera,
                const Rigid3& roomFromCamera, Sampling sampling, RgbImage& picture);

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spherewalk::render
