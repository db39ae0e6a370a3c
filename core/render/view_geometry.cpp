// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/view_geometry.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/pose_check.h"

#include <cmath>

namespace spherewalk::render {

namespace {

constexpr double kUnitTolerance = 1e-6;

[[noreturn]] void refuse(const std::string& what) {
    throw Error(ErrorKind::InvalidInput,
                text("Neither depth nor trust of the view can be told: ", what, "."));
}

} // namespace

void ViewGeometry::validate() const {
    if (!isPose(roomFromCamera, kUnitTolerance) || !isPose(roomFromPhoto, kUnitTolerance)) {
        refuse("the pose of the camera or of the photo is not a position in metres and a unit quaternion");
    }
    if (photo.width < 1 || photo.height < 1) {
        refuse(text("the photo has ", photo.width, " x ", photo.height, " pixels"));
    }
    if (!(sphereRadiusM > 0) || !std::isfinite(sphereRadiusM)) {
        refuse(text("the scene's radius is ", sphereRadiusM, " m; it must be above zero"));
    }
}

} // namespace spherewalk::render
