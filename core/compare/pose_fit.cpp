// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/pose_fit.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/compare/picture_matches.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Eigenvalues>
#include <ceres/ceres.h>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace spherewalk::compare {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kRansacPx = 4;      ///< room for what depths are off by
constexpr double kLossPx = 1;        ///< of the robust loss
constexpr double kLargestScales = 3; ///< of an inlier's error
constexpr double kLeastScalePx = 0.5;
constexpr int kCells = 8;      ///< along the picture's width
constexpr double kAlike = 0.3; ///< the part of the errors' variance that a cell's points have in common
constexpr double kLeastAxial =
    0.2; ///< z of a ray that RANSAC looks at: it works on a plane before the camera

/// Of the camera as it was thought to stand: small numbers, wherever the room lies.
struct LocalPoint {
    Vector3d at;
    Vector2d pixel;
};

/// A small change of the camera's pose, in its own frame: a turn vector, then a shift.
using Change = std::array<double, 6>;

Rigid3 rigid(const Change& change) {
    const Eigen::Map<const Vector3d> turn(change.data());
    const double angle = turn.norm();
    const Vector3d axis = angle > 0 ? Vector3d(turn / angle) : Vector3d::UnitX();
    return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)),
            Eigen::Map<const Vector3d>(change.data() + 3)};
}

std::optional<Vector2d> error(const LocalPoint& point, const CameraModel& camera,
                              const Rigid3& localFromCamera) {
    const auto shown = camera.project(localFromCamera.inverse() * point.at);
    return shown ? std::optional<Vector2d>(*shown - point.pixel) : std::nullopt;
}

/// For numeric derivatives, since lens models have no others.
class Reprojection {
  public:
    Reprojection(const LocalPoint& point, const CameraModel& camera) : m_point(point), m_camera(camera) {}

    bool operator()(const double* change, double* residual) const {
        Change own;
        std::copy_n(change, own.size(), own.begin());
        const auto off = error(m_point, m_camera, rigid(own));
        if (off) {
            Eigen::Map<Vector2d>(residual, 2) = *off;
        }
        return off.has_value();
    }

  private:
    const LocalPoint& m_point;
    const CameraModel& m_camera;
};

using Points = std::vector<LocalPoint>;

/// The points that a pose agrees with.
Points within(const Points& points, const CameraModel& camera, const Change& change, double mostPx) {
    Points result;
    for (const LocalPoint& point : points) {
        const auto off = error(point, camera, rigid(change));
        if (off && off->norm() <= mostPx) {
            result.push_back(point);
        }
    }
    return result;
}

/// A pose that many points agree on; nothing if there is none.
std::optional<Change> consensus(const Points& points, const CameraModel& camera) {
    std::vector<cv::Point3d> objects;
    std::vector<cv::Point2d> places;
    for (const LocalPoint& point : points) {
        const auto ray = camera.ray(point.pixel);
        if (ray && ray->z() > kLeastAxial) {
            objects.emplace_back(point.at.x(), point.at.y(), point.at.z());
            places.emplace_back(ray->x() / ray->z(), ray->y() / ray->z());
        }
    }
    if (objects.size() < 4) {
        return std::nullopt;
    }
    cv::Mat turn;
    cv::Mat shift;
    std::vector<int> inliers;
    const double focal = std::max(camera.intrinsics().fx, camera.intrinsics().fy);
    const bool isFound =
        cv::solvePnPRansac(objects, places, cv::Matx33d::eye(), cv::noArray(), turn, shift, false, 1000,
                           static_cast<float>(kRansacPx / focal), 0.9999, inliers, cv::SOLVEPNP_P3P);
    if (!isFound || turn.total() != 3 || shift.total() != 3) {
        return std::nullopt;
    }
    const Vector3d vector(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
    const Rigid3 cameraFromLocal{rigid({vector.x(), vector.y(), vector.z(), 0, 0, 0}).rotation,
                                 {shift.at<double>(0), shift.at<double>(1), shift.at<double>(2)}};
    const Rigid3 localFromCamera = cameraFromLocal.inverse();
    const Eigen::AngleAxisd back(localFromCamera.rotation);
    const Vector3d turned = back.angle() * back.axis();
    const Vector3d& at = localFromCamera.translation;
    const Change change{turned.x(), turned.y(), turned.z(), at.x(), at.y(), at.z()};
    const bool isFinite =
        std::all_of(change.begin(), change.end(), [](double v) { return std::isfinite(v); });
    return isFinite ? std::optional(change) : std::nullopt;
}

/// How much each point counts. Errors of depth are alike where points lie close together, on one surface, so
/// that many of them say little more than a few.
std::vector<double> weights(const Points& points, const CameraModel& camera) {
    const double cell = static_cast<double>(camera.width()) / kCells;
    const auto cellOf = [&](const LocalPoint& point) {
        return std::pair(std::floor(point.pixel.x() / cell), std::floor(point.pixel.y() / cell));
    };
    std::map<std::pair<double, double>, int> counts;
    for (const LocalPoint& point : points) {
        ++counts[cellOf(point)];
    }
    std::vector<double> result;
    for (const LocalPoint& point : points) {
        result.push_back(1 / (1 + kAlike * (counts[cellOf(point)] - 1)));
    }
    return result;
}

/// Robust root mean square along an axis.
double scaleOf(const Points& points, const CameraModel& camera, const Change& change) {
    std::vector<double> errors;
    for (const LocalPoint& point : points) {
        const auto off = error(point, camera, rigid(change));
        errors.push_back(off ? off->norm() : HUGE_VAL);
    }
    return std::max(kLeastScalePx, median(std::move(errors)) / std::sqrt(2 * std::log(2.0))); // Rayleigh
}

double meanSquareRoot(const Points& points, const CameraModel& camera, const Change& change) {
    double squares = 0;
    for (const LocalPoint& point : points) {
        squares += error(point, camera, rigid(change))->squaredNorm();
    }
    return std::sqrt(squares / std::max(1.0, 2.0 * static_cast<double>(points.size()) - 6));
}

/// The sum over the points of their squared errors, with what makes wrong ones count little.
void addPoints(const Points& points, const std::vector<double>& weight, const CameraModel& camera,
               Change& change, ceres::Problem& problem) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        problem.AddResidualBlock(
            new ceres::NumericDiffCostFunction<Reprojection, ceres::CENTRAL, 2, 6>(
                new Reprojection(points[i], camera)),
            new ceres::ScaledLoss(new ceres::CauchyLoss(kLossPx), weight[i], ceres::TAKE_OWNERSHIP),
            change.data());
    }
}

Change leastSquares(const Points& points, const CameraModel& camera, Change change) {
    ceres::Problem problem;
    addPoints(points, std::vector<double>(points.size(), 1), camera, change, problem);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 50;
    options.function_tolerance = 1e-10;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return change;
}

using Covariance = Eigen::Matrix<double, 6, 6>;

/// For errors of one pixel; nothing where the points do not determine the pose.
std::optional<Covariance> covarianceOf(const Points& points, const CameraModel& camera, Change change) {
    ceres::Problem problem;
    addPoints(points, weights(points, camera), camera, change, problem);
    ceres::Covariance::Options options;
    options.apply_loss_function = true;
    ceres::Covariance covariance(options);
    const std::vector<const double*> blocks{change.data()};
    Covariance result;
    const bool isKnown = covariance.Compute(blocks, &problem) &&
                         covariance.GetCovarianceBlock(blocks[0], blocks[0], result.data());
    return isKnown ? std::optional(result) : std::nullopt;
}

double largestSigma(const Matrix3d& covariance) {
    return std::sqrt(
        std::max(0.0, Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvalues().maxCoeff()));
}

/// Why the pose is none; nothing if it is one.
std::optional<std::string> refusal(const PoseFit& fit, const Change& change, const PoseFitOptions& options) {
    if (fit.inliers < options.fewest ||
        static_cast<double>(fit.inliers) < options.leastShare * static_cast<double>(fit.points)) {
        return text(
            "Only ", fit.inliers, " of ", fit.points,
            " matched features agree on a pose; the picture may show something else than the view, or the "
            "approximate pose may be too far off.");
    }
    if (!(fit.sigmaPositionM <= options.largestSigmaM) || !(fit.sigmaRotation <= options.largestSigma)) {
        return "The matched features lie too close together to tell where the camera is; take a picture that "
               "shows more of the room, near and far.";
    }
    const Rigid3 moved = rigid(change);
    if (!(moved.translation.norm() <= options.largestMoveM) ||
        !(angleBetween(moved.rotation, Eigen::Quaterniond::Identity()) <= options.largestTurn)) {
        return text("The matched features ask for a pose ", fixed(moved.translation.norm(), 2), " m and ",
                    fixed(Degrees(angleBetween(moved.rotation, Eigen::Quaterniond::Identity())).value(), 1),
                    " degrees from the approximate one, which is too far to be believed.");
    }
    return std::nullopt;
}

PoseFit fitted(const Points& points, const CameraModel& camera, const Rigid3& approximate,
               const PoseFitOptions& options) {
    PoseFit fit;
    fit.roomFromCamera = approximate;
    fit.points = points.size();
    fit.sigmaPositionM = std::numeric_limits<double>::infinity();
    fit.sigmaRotation = Radians(std::numeric_limits<double>::infinity());
    Change change{};
    const auto begin = points.size() < options.fewest ? std::nullopt : consensus(points, camera);
    if (begin) {
        change = *begin;
        Points inside = within(points, camera, change, 2 * kRansacPx);
        for (int round = 0; round < 3 && inside.size() >= options.fewest; ++round) {
            change = leastSquares(inside, camera, change);
            inside = within(points, camera, change, kLargestScales * scaleOf(inside, camera, change));
        }
        fit.inliers = inside.size();
        fit.residualPx = meanSquareRoot(inside, camera, change);
        const auto covariance = inside.empty() ? std::nullopt : covarianceOf(inside, camera, change);
        if (covariance) {
            fit.sigmaPositionM = fit.residualPx * largestSigma(covariance->bottomRightCorner<3, 3>());
            fit.sigmaRotation = Radians(fit.residualPx * largestSigma(covariance->topLeftCorner<3, 3>()));
        }
    }
    if (const auto why = refusal(fit, change, options)) {
        fit.why = *why;
        return fit;
    }
    fit.isFitted = true;
    fit.roomFromCamera = approximate * rigid(change);
    return fit;
}

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

PoseFit fittedPose(std::span<const SeenPoint> points, const CameraModel& camera, const Rigid3& approximate,
                   const PoseFitOptions& options) {
    if (!isPose(approximate)) {
        throw Error(ErrorKind::InvalidInput,
                    "An approximate pose is not a position in metres and a unit quaternion.");
    }
    Points local;
    const Eigen::Quaterniond cameraFromRoom = approximate.rotation.normalized().conjugate();
    for (const SeenPoint& point : points) {
        if (point.pInRoom.allFinite() && point.pixel.allFinite()) {
            local.push_back({cameraFromRoom * (point.pInRoom - approximate.translation), point.pixel});
        }
    }
    try {
        return fitted(local, camera, {approximate.rotation.normalized(), approximate.translation}, options);
    } catch (const cv::Exception& error) {
        throw Error(ErrorKind::Internal,
                    "Could not fit a pose: OpenCV refused the points; please report this.", error.what());
    }
}

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

} // namespace spherewalk::compare
