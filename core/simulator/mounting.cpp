// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/mounting.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/pose_check.h"
#include "spherewalk/geometry/rotation.h"

namespace spherewalk::simulator {

Rigid3 Mounting::roomFromOptical(const Rigid3& worldFromLink) const {
    const Rigid3 roomFromCamera = roomFromWorld * worldFromLink * linkFromCamera;
    return axes == CameraAxes::Body ? roomFromCamera * Rigid3{bodyFromOptical(), Eigen::Vector3d::Zero()}
                                    : roomFromCamera;
}

void Mounting::validate() const {
    if (!isPose(roomFromWorld) || !isPose(linkFromCamera)) {
        throw Error(ErrorKind::InvalidInput, "The camera's place on its link and the world's in the room "
                                             "must be finite metres and unit quaternions.");
    }
}

} // namespace spherewalk::simulator
