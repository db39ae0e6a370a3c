// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/ladder.h"
#include "spherewalk/render/pixel_rays.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/render/view.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace spherewalk::render {

class DepthEvidence;

/// What follows from a view's geometry without its colours: the depth and the trust of each pixel.

/// A view, the photo that it is taken from, and the scene model.
struct ViewGeometry {
    const PixelRays& rays; ///< The rays of the view's camera must outlive this.
    Rigid3 roomFromCamera; ///< The pose of the optical frame.
    Rigid3 roomFromPhoto;
    EquirectSize photo; ///< The size of the whole photo, whichever level of it the view was made from.
    SceneKind scene = SceneKind::None;
    /// The radius for SceneKind::Sphere. With SceneKind::None it is the usual distance of things.
    double sphereRadiusM = 0;

    /// Errors: InvalidInput for a photo without pixels, poses that are not finite or not turned by unit
    /// quaternions, and a radius that is not above zero.
    void validate() const;
};

/// The depth of each pixel in the view's scene model: z along the optical axis, in metres, at the pixel's
/// centre. It is the depth of a model: a table in the sphere has the depth of the sphere. The sphere is seen
/// from where directionOnSphere() takes the camera to stand.
///
/// Shape: that of the view; empty with SceneKind::None, which knows no depth. Range: > 0. It is +infinity
/// where the lens sees nothing and where a ray lies 90 degrees or more off the axis. threads: the most to
/// use, 0 for all of the pool; the values are the same for any number. memory: the result of a view before,
/// whose memory is used again. Errors: as ViewGeometry::validate().
DepthImage viewDepth(const ViewGeometry& view, WorkerPool& pool, int threads = 0, DepthImage memory = {});

/// What a photo knows about the things that it shows, and how well its own pose is known.
struct PhotoEvidence {
    Rigid3 roomFromPhoto;
    std::shared_ptr<const DepthEvidence> depth; ///< Nothing if the photo has no depth.
    double rotationSigmaRad = 0;                ///< By how much it is turned across a ray.
    double positionSigmaM = 0;                  ///< By how much it is displaced across a ray.
};

/// What is known about a view besides its scene model.
struct ViewEvidence {
    std::vector<PhotoEvidence> photos; ///< The photos that the view shows, and then others near the camera.
    std::size_t shown = 1;             ///< The number of photos that the view shows.
    bool showsDepths = false;          ///< Whether the view's distances are those of the photos' depths.
    /// 1 / distance along a pixel's ray in the view. It is empty for scene models without surfaces.
    std::function<double(int x, int y, const Eigen::Vector3d& ray)> inverseM;
    /// How far 1 / distance spreads, as a share of it, where no depth was measured.
    double priorShare = 0.3;
    std::optional<RoomShape> room; ///< What lies beyond it is a mirror image or outside of a window.
    bool isKnown = true;           ///< Whether anything can be said. If not, all errors are infinite.
};

struct TrustOptions {
    /// Photo pixels along one pixel of the picture that the view was made from: 1 for the photo itself, 2 for
    /// its half.
    double coarseness = 1;
    Degrees poleRadius{
        10}; ///< The radius for PixelFlag::Pole is a choice: camera feet have different widths.
    /// Half the width of the zone of PixelFlag::Stitching about azimuth +-90 degrees of the photo. Two-lens
    /// cameras join their pictures there. Use 0 for photos of other cameras and for drawn ones. It is a
    /// choice: the true width depends on the camera, and levelling in the camera tilts the zone.
    Degrees stitchingHalfWidth{5};
    const MaskImage* overlays = nullptr; ///< The mask that Composer::compose() gave, if there are overlays.

    /// Errors: InvalidInput for values that are not finite or negative, and a coarseness below 1.
    void validate() const;
};

/// How far each pixel of a view can be believed. The error is the sum of displacement and blur.
///
/// Displacement is the product of three factors: the part of the offset between camera and photo that lies
/// across the ray; the error of the scene model's 1 / distance along the ray; the pixels per radian that the
/// lens has there. The photos' depths tell that error: how far the scene model is from the photo's own depth,
/// how far other photos' depths disagree, how steep the depth is close by, and whether it was measured at
/// all. The uncertainty of the photo's pose is added. resources/docs/trust.md says more. Blur is half of what
/// a pixel of a coarser picture spans beyond a pixel of the view, or of the photo where that is the larger.
///
/// threads: the most to use, 0 for all of the pool; the values are the same for any number. Errors: as
/// validate() of the view and of the options; InvalidInput for a mask of another size. memory: as in
/// viewDepth().
PixelTrust pixelTrust(const ViewGeometry& view, const ViewEvidence& evidence, const TrustOptions& options,
                      WorkerPool& pool, int threads = 0, PixelTrust memory = {});

/// How far a view can be believed as a whole.
struct ViewTrust {
    double displacementPx = 0; ///< The median of the pixels' displacements.
    double seenShare = 0;      ///< The share of pixels that are neither filled nor unsure.
};

/// The trust of a view from 16 x 12 of its pixels. Cost: a tenth of a millisecond.
ViewTrust viewTrust(const ViewGeometry& view, const ViewEvidence& evidence);

} // namespace spherewalk::render
