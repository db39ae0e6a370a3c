// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/overlay_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/jobs/object_overlay.h"

#include <cmath>

namespace spherewalk::jobs {

namespace {

/// Faces that look away from the light differ from each other, too.
double faceBrightness(const Eigen::Vector3d& normalInRoom) {
    static const Eigen::Vector3d kLight = Eigen::Vector3d(0.5, 0.35, 0.8).normalized();
    return 0.3 + 0.35 * (1 + normalInRoom.dot(kLight));
}

} // namespace

void PlacedMesh::validate() const {
    if (mesh == nullptr || !footM.allFinite() || !std::isfinite(yaw.value()) || !std::isfinite(sizeM) ||
        sizeM <= 0) {
        throw Error(ErrorKind::InvalidInput,
                    "An object has a mesh, a place in metres, a heading, and a size above zero.");
    }
}

render::Overlay meshOverlay(const PlacedMesh& object, const CameraModel& camera,
                            const Rigid3& roomFromCamera) {
    object.validate();
    render::Overlay overlay = emptyOverlay(camera);
    const Eigen::Matrix3d roomFromObject =
        Eigen::AngleAxisd(object.yaw.value(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d objectFromRoom = roomFromObject.transpose() / object.sizeM;
    const Eigen::Vector3d eye = objectFromRoom * (roomFromCamera.translation - object.footM);
    if (object.mesh->contains(eye)) {
        return overlay;
    }
    const Eigen::Matrix3d objectFromCamera = objectFromRoom * roomFromCamera.rotation.toRotationMatrix();
    const Eigen::Vector3d sidesM = object.sizeM * object.mesh->sides().cast<double>();
    const Eigen::Vector3d middle =
        roomFromCamera.inverse() * (object.footM + Eigen::Vector3d(0, 0, 0.5 * sidesM.z()));
    const PixelBox box = boxAround(middle, 0.5 * sidesM.norm(), camera);
    constexpr int kRows = 16; // a piece of the work
    parallelFor(std::max(0, box.bottom - box.top), kRows, 0, [&](int begin, int end) {
        for (int y = box.top + begin; y < box.top + end; ++y) {
            for (int x = box.left; x < box.right; ++x) {
                const auto ray = camera.ray(Eigen::Vector2d(x, y));
                ObjectMesh::Hit hit;
                if (ray && ray->z() > 0 && object.mesh->meets(eye, objectFromCamera * *ray, hit)) {
                    *overlay.depth.at(x, y) = static_cast<float>(hit.along * ray->z());
                    shade(object.colour, faceBrightness(roomFromObject * hit.normal.cast<double>()),
                          overlay.picture.at(x, y));
                }
            }
        }
    });
    return overlay;
}

} // namespace spherewalk::jobs
