// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"

#include <string>

namespace spherewalk::jobs {

/// The pose as a part of a cache key. Two poses have the same key only if all their numbers are equal.
inline std::string keyOf(const Rigid3& pose) {
    const Eigen::Quaterniond& q = pose.rotation;
    const Eigen::Vector3d& t = pose.translation;
    return text(q.w(), " ", q.x(), " ", q.y(), " ", q.z(), " ", t.x(), " ", t.y(), " ", t.z());
}

/// The outline as a part of a cache key.
inline std::string keyOf(const Polygon& outline) {
    std::string key;
    for (const Eigen::Vector2d& corner : outline) {
        key += text(" ", corner.x(), " ", corner.y());
    }
    return key;
}

/// The camera as a part of a cache key.
inline std::string keyOf(const CameraIntrinsics& camera) {
    std::string key = text(camera.width, " ", camera.height, " ", camera.fx, " ", camera.fy, " ", camera.cx,
                           " ", camera.cy, " ", name(camera.lens));
    for (const double parameter : camera.distortion) {
        key += text(" ", parameter);
    }
    return key;
}

} // namespace spherewalk::jobs
