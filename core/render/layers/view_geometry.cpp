// SPDX-License-Identifier: Apache-2.0
#include "layers/view_geometry.h"

#include "layers/shown_errors.h"
#include "sphere/exact_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

constexpr double kUnitTolerance = 1e-6;
/// The view's own error is the median of so many pixels.
constexpr int kColumns = 16;
constexpr int kRows = 12;

[[noreturn]] void refuseGeometry(const std::string& what) {
    throw Error(ErrorKind::InvalidInput,
                text("Neither depth nor trust of the view can be told: ", what, "."));
}

/// Depths of a row's pixels in the sphere, without distortion. With rays that are not normalised, the depth
/// along the axis is radius * t of |from + t * ray| = 1, whose root has two forms that do not cancel.
void pinholeRow(const CameraIntrinsics& camera, const DisplacedCamera& inCamera, double radiusM, int y,
                float* depth) {
    const double perPixel = 1 / camera.fx;
    const double down = (y - camera.cy) / camera.fy;
    const double forward = inCamera.fromPhoto().y() * down + inCamera.fromPhoto().z();
    const double across = inCamera.fromPhoto().x();
    const double inside = inCamera.inside();
    const double rest = down * down + 1;
    const double left = camera.cx;
    const int width = camera.width;
    for (int x = 0; x < width; ++x) {
        const double right = (x - left) * perPixel;
        const double along = across * right + forward;
        const double lengthSquared = right * right + rest;
        const double root = std::sqrt(along * along + inside * lengthSquared);
        const double above = along > 0 ? inside : root - along;
        const double below = along > 0 ? along + root : lengthSquared;
        depth[x] = static_cast<float>(radiusM * above / below);
    }
}

} // namespace

void ViewGeometry::validate() const {
    if (!isPose(roomFromCamera, kUnitTolerance) || !isPose(roomFromPhoto, kUnitTolerance)) {
        refuseGeometry(
            "the pose of the camera or of the photo is not a position in metres and a unit quaternion");
    }
    if (photo.width < 1 || photo.height < 1) {
        refuseGeometry(text("the photo has ", photo.width, " x ", photo.height, " pixels"));
    }
    if (!(sphereRadiusM > 0) || !std::isfinite(sphereRadiusM)) {
        refuseGeometry(text("the scene's radius is ", sphereRadiusM, " m; it must be above zero"));
    }
}

DepthImage viewDepth(const ViewGeometry& view, WorkerPool& pool, int threads) {
    view.validate();
    if (view.scene == SceneKind::None) {
        return {};
    }
    const SceneRays scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM);
    DepthImage depth(view.rays.camera().width(), view.rays.camera().height());
    const CameraIntrinsics& camera = view.rays.camera().intrinsics();
    pool.run(depth.height(), threads, [&](int y, int) {
        if (camera.lens == LensModel::Pinhole) {
            pinholeRow(camera, scene.inCamera(), view.sphereRadiusM, y, depth.at(0, y));
            return;
        }
        for (int x = 0; x < depth.width(); ++x) {
            const Vector3d ray = view.rays.ray(x, y);
            *depth.at(x, y) = ray.z() > 0 ? static_cast<float>(ray.z() * scene.distanceM(ray))
                                          : std::numeric_limits<float>::infinity();
        }
    });
    return depth;
}

ViewTrust viewTrust(const ViewGeometry& view, const ViewEvidence& evidence) {
    const CameraModel& camera = view.rays.camera();
    const SceneRays scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM);
    const ShownErrors errors(scene, view, evidence);
    std::vector<double> all;
    int seen = 0;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const int x = (2 * column + 1) * camera.width() / (2 * kColumns);
            const int y = (2 * row + 1) * camera.height() / (2 * kRows);
            const Vector3d ray = view.rays.ray(x, y);
            if (!ray.isZero(0)) {
                const ShownError error = errors.at(x, y, ray);
                all.push_back(error.px);
                seen += error.isFilled || error.isUnsure ? 0 : 1;
            }
        }
    }
    if (all.empty()) {
        return {std::numeric_limits<double>::infinity(), 0};
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return {*middle, seen / static_cast<double>(kRows * kColumns)};
}

} // namespace spherewalk::render
