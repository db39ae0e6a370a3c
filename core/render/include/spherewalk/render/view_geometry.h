// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/pixel_rays.h"
#include "spherewalk/render/scene_model.h"

namespace spherewalk::render {

/// A view, the photo that it is taken from, and what the scene is taken for.
struct ViewGeometry {
    const PixelRays& rays; ///< of the view's camera
    Rigid3 roomFromCamera; ///< of the optical frame
    Rigid3 roomFromPhoto;
    EquirectSize photo; ///< the whole photo, whichever level of it the view was made from
    SceneKind scene = SceneKind::None;
    /// Of SceneKind::Sphere; with SceneKind::None, the distance at which things usually are.
    double sphereRadiusM = 0;

    /// Errors: InvalidInput with a sentence for a photo without pixels, poses that are not finite or not
    /// turned by unit quaternions, and a radius that is not above zero.
    void validate() const;
};

} // namespace spherewalk::render
