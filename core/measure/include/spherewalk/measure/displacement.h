// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/measure/picture_matches.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace spherewalk::measure {

/// A feature of the true picture, and how far off it is in the computed one. Units: pixels.
struct Displacement {
    Eigen::Vector2d pixel;
    double errorPx = 0;
};

/// Displacements of features that are found in both pictures: SIFT, each the other's best by far, and moved
/// about as two of its nearest neighbours are, since parallax is even where surfaces are and wrong matches
/// are not. Errors: InvalidInput if the sizes differ; Internal, for what OpenCV refuses.
std::vector<Displacement> matchedDisplacements(const RgbImage& truth, const RgbImage& computed);
std::vector<Displacement> matchedDisplacements(const PictureFeatures& truth, const PictureFeatures& computed);

/// Displacements where the true depth is known, of every `every`th pixel of every `every`th row. At each
/// pixel, the photo shows what lies in the direction that the depth taken leads to, at about the distance at
/// which the true thing lies from the photo; how far from the pixel that would have to appear is the error.
/// z: along the optical axis, metres, true and as the scene model had it (empty or +infinity: infinitely
/// far). Pixels without a true depth are left out. Errors: InvalidInput if sizes differ.
std::vector<Displacement> exactDisplacements(const CameraModel& camera, const Rigid3& roomFromCamera,
                                             const Eigen::Vector3d& photoInRoom, const DepthImage& trueZ,
                                             const DepthImage& takenZ, int every = 4);

/// The value that this share of the errors does not exceed; nothing if there are none. Range: share in [0,
/// 1].
std::optional<double> quantile(const std::vector<Displacement>& displacements, double share);

} // namespace spherewalk::measure
