// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/pose_refinement.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/measure/picture_matches.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::measure {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kMostJump = 0.05; ///< of 1 / depth, between pixels of one surface
/// Once the pose is known but for a little, weaker features will do, since each has few rivals.
constexpr double kWeakContrast = 0.02;
constexpr double kReachPx = 12;
constexpr double kSmallMoveM = 0.002;
constexpr double kSmallTurnDeg = 0.02;

std::vector<SeenPoint> pointsOf(const render::View& view, const RgbImage& picture, const CameraModel& camera,
                                const Rigid3& roomFromCamera, bool isNearlyThere) {
    const double contrast = isNearlyThere ? kWeakContrast : PictureFeatures::kUsualContrast;
    std::vector<SeenPoint> points;
    for (const PictureMatch& match :
         pictureMatches(PictureFeatures(view.picture, contrast), PictureFeatures(picture, contrast),
                        isNearlyThere ? kReachPx : 0)) {
        if (const auto place = placeShown(view.depth, camera, roomFromCamera, match.inA)) {
            points.push_back({*place, match.inB});
        }
    }
    return points;
}

bool isStill(const Rigid3& before, const Rigid3& after) {
    return (before.translation - after.translation).norm() < kSmallMoveM &&
           angleBetween(before.rotation, after.rotation) < Radians(Degrees(kSmallTurnDeg));
}

/// The fit as one from the first pose: together the rounds must not lead farther than one may.
PoseFit bounded(PoseFit fit, const Rigid3& approximate, const PoseFitOptions& options) {
    if (fit.isFitted &&
        ((fit.roomFromCamera.translation - approximate.translation).norm() > options.largestMoveM ||
         angleBetween(fit.roomFromCamera.rotation, approximate.rotation) > options.largestTurn)) {
        fit.isFitted = false;
        fit.why = "The matched features lead farther from the approximate pose than can be believed.";
    }
    if (!fit.isFitted) {
        fit.roomFromCamera = approximate;
    }
    return fit;
}

} // namespace

std::optional<Vector3d> placeShown(const DepthImage& depth, const CameraModel& camera,
                                   const Rigid3& roomFromCamera, const Vector2d& pixel) {
    const int x = static_cast<int>(std::floor(pixel.x()));
    const int y = static_cast<int>(std::floor(pixel.y()));
    const auto ray = camera.ray(pixel);
    if (x < 0 || y < 0 || x + 1 >= depth.width() || y + 1 >= depth.height() || !ray || !(ray->z() > 0)) {
        return std::nullopt;
    }
    const auto inverse = [&](int right, int down) {
        return 1.0 / static_cast<double>(*depth.at(x + right, y + down));
    };
    const auto [least, most] = std::minmax({inverse(0, 0), inverse(1, 0), inverse(0, 1), inverse(1, 1)});
    if (!(least > 0) || !std::isfinite(most) || most - least > kMostJump * most) {
        return std::nullopt;
    }
    // 1 / depth is even along a plane.
    const double right = pixel.x() - x;
    const double down = pixel.y() - y;
    const double between = (1 - down) * ((1 - right) * inverse(0, 0) + right * inverse(1, 0)) +
                           down * ((1 - right) * inverse(0, 1) + right * inverse(1, 1));
    return roomFromCamera * Vector3d(*ray / (ray->z() * between));
}

PoseFit refinedPose(const render::Renderer& renderer, const CameraModel& camera, const RgbImage& picture,
                    const Rigid3& approximate, const PoseRefinementOptions& options,
                    const std::stop_token& stop) {
    if (picture.width() != camera.width() || picture.height() != camera.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("A picture of ", picture.width(), " x ", picture.height(),
                         " pixels is not one of a camera of ", camera.width(), " x ", camera.height(), "."));
    }
    render::ViewOptions view = options.view;
    view.wantsDepth = true;
    PoseFit fit;
    fit.roomFromCamera = approximate;
    for (int round = 0; round < std::max(1, options.rounds); ++round) {
        throwIfStopped(stop);
        const Rigid3 from = fit.roomFromCamera;
        const render::View seen = renderer.render(camera, from, view);
        if (seen.depth.empty()) {
            fit.why =
                "The view's scene model knows no depth, without which a pose cannot be refined; export the "
                "dataset with --scene depth.";
            return fit;
        }
        PoseFit next =
            fittedPose(pointsOf(seen, picture, camera, from, round > 0), camera, from, options.fit);
        if (!next.isFitted && fit.isFitted) {
            break;
        }
        fit = std::move(next);
        if (!fit.isFitted || (round > 0 && isStill(from, fit.roomFromCamera))) {
            break;
        }
    }
    return bounded(std::move(fit), approximate, options.fit);
}

} // namespace spherewalk::measure
