// SPDX-License-Identifier: Apache-2.0
#include "layers/view_geometry.h"

#include "layers/layer_rows.h"
#include "layers/shown_errors.h"
#include "sphere/exact_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
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

DepthImage viewDepth(const ViewGeometry& view, WorkerPool& pool, int threads, DepthImage memory) {
    view.validate();
    if (view.scene == SceneKind::None) {
        return {};
    }
    const SceneRays scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM);
    const CameraIntrinsics& camera = view.rays.camera().intrinsics();
    DepthImage depth = std::move(memory);
    if (depth.width() != camera.width || depth.height() != camera.height) {
        depth = DepthImage(camera.width, camera.height);
    }
    pool.run(depth.height(), threads, [&](int y, int) {
        if (camera.lens == LensModel::Pinhole) {
            simd::sphereDepths(camera, scene.inCamera(), view.sphereRadiusM, y, depth.row(y));
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
    std::vector<ViewPixel> pixels;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const int x = (2 * column + 1) * camera.width() / (2 * kColumns);
            const int y = (2 * row + 1) * camera.height() / (2 * kRows);
            const Vector3d ray = view.rays.ray(x, y);
            if (!ray.isZero(0)) {
                pixels.push_back({x, y, ray});
            }
        }
    }
    std::vector<double> all;
    int seen = 0;
    for (const ShownError& error : errors.of(pixels)) {
        all.push_back(error.px);
        seen += error.isFilled || error.isUnsure ? 0 : 1;
    }
    if (all.empty()) {
        return {std::numeric_limits<double>::infinity(), 0};
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return {*middle, seen / static_cast<double>(kRows * kColumns)};
}

} // namespace spherewalk::render
