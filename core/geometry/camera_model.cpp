// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/camera_model.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace spherewalk {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

std::size_t parameterCount(LensModel lens) {
    switch (lens) {
    case LensModel::Pinhole:
        return 0;
    case LensModel::PlumbBob:
        return 5;
    case LensModel::RationalPolynomial:
        return 8;
    case LensModel::Equidistant:
        break;
    }
    return 4;
}

[[noreturn]] void refuseCamera(const std::string& what) {
    throw Error(ErrorKind::InvalidInput, text("The camera model cannot be used: ", what, "."));
}

} // namespace

std::string_view name(LensModel model) {
    switch (model) {
    case LensModel::Pinhole:
        return "none";
    case LensModel::PlumbBob:
        return "plumb_bob";
    case LensModel::RationalPolynomial:
        return "rational_polynomial";
    case LensModel::Equidistant:
        break;
    }
    return "equidistant";
}

bool CameraIntrinsics::operator==(const CameraIntrinsics& other) const {
    const auto members = [](const CameraIntrinsics& camera) {
        return std::tie(camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy, camera.lens,
                        camera.distortion);
    };
    return members(*this) == members(other);
}

CameraIntrinsics CameraIntrinsics::pinhole(int width, int height, double horizontalFovRad) {
    const double focal = 0.5 * width / std::tan(0.5 * horizontalFovRad);
    CameraIntrinsics result;
    result.width = width;
    result.height = height;
    result.fx = focal;
    result.fy = focal;
    result.cx = 0.5 * width - 0.5; // sizes are checked later: no integer may overflow here
    result.cy = 0.5 * height - 0.5;
    return result;
}

void CameraIntrinsics::validate() const {
    constexpr int kLargest = 32768;
    if (width < 1 || height < 1 || width > kLargest || height > kLargest) {
        refuseCamera(
            text("its picture is ", width, " x ", height, " pixels, and 1 to ", kLargest, " are possible"));
    }
    if (!(std::isfinite(fx) && std::isfinite(fy) && fx > 0 && fy > 0)) {
        refuseCamera(text("its focal lengths are ", fx, " and ", fy, ", and must be positive"));
    }
    if (!std::isfinite(cx) || !std::isfinite(cy)) {
        refuseCamera("its principal point is not a number");
    }
    if (distortion.size() != parameterCount(lens)) {
        refuseCamera(text("the lens model ", name(lens), " has ", parameterCount(lens),
                          " distortion parameters, not ", distortion.size()));
    }
    if (!std::all_of(distortion.begin(), distortion.end(), [](double k) { return std::isfinite(k); })) {
        refuseCamera("a distortion parameter is not a number");
    }
}

CameraModel::CameraModel(CameraIntrinsics intrinsics) : m_intrinsics(std::move(intrinsics)) {
    m_intrinsics.validate();
    m_k = m_intrinsics.distortion;
    m_k.resize(8, 0.0);
    m_largestField = largestField();
}

double CameraModel::radialFactor(double r2) const {
    return (1 + r2 * (m_k[0] + r2 * (m_k[1] + r2 * m_k[4]))) /
           (1 + r2 * (m_k[5] + r2 * (m_k[6] + r2 * m_k[7])));
}

double CameraModel::distortedAngle(double angle) const {
    const double a2 = angle * angle;
    return angle * (1 + a2 * (m_k[0] + a2 * (m_k[1] + a2 * (m_k[2] + a2 * m_k[3]))));
}

double CameraModel::largestField() const {
    // Beyond the first maximum of the distorted radius one pixel would show two directions: the field ends
    // there.
    const bool fisheye = m_intrinsics.lens == LensModel::Equidistant;
    const double end = fisheye ? std::numbers::pi : 60.0; // tan(89.05 degrees)
    constexpr int kSteps = 6000;
    double last = 0;
    for (int i = 1; i <= kSteps; ++i) {
        const double field = end * i / kSteps;
        const double image = fisheye ? distortedAngle(field) : field * radialFactor(field * field);
        if (!(image > last)) {
            return end * (i - 1) / kSteps;
        }
        last = image;
    }
    return fisheye ? end : m_intrinsics.lens == LensModel::Pinhole ? HUGE_VAL : end;
}

Vector2d CameraModel::distorted(const Vector2d& p) const {
    const double r2 = p.squaredNorm();
    const double p1 = m_k[2];
    const double p2 = m_k[3];
    const Vector2d tangential(2 * p1 * p.x() * p.y() + p2 * (r2 + 2 * p.x() * p.x()),
                              p1 * (r2 + 2 * p.y() * p.y()) + 2 * p2 * p.x() * p.y());
    return p * radialFactor(r2) + tangential;
}

std::optional<Vector2d> CameraModel::undistorted(const Vector2d& target) const {
    // Newton's method with a numeric Jacobian, damped: converges in a few steps inside the field.
    Vector2d p = target;
    for (int iteration = 0; iteration < 50; ++iteration) {
        const Vector2d error = distorted(p) - target;
        if (error.norm() < 1e-13 * std::max(1.0, target.norm())) {
            break;
        }
        const double h = 1e-6 * std::max(1.0, p.norm());
        Eigen::Matrix2d jacobian;
        jacobian.col(0) = (distorted(p + Vector2d(h, 0)) - distorted(p - Vector2d(h, 0))) / (2 * h);
        jacobian.col(1) = (distorted(p + Vector2d(0, h)) - distorted(p - Vector2d(0, h))) / (2 * h);
        if (std::abs(jacobian.determinant()) < 1e-12) {
            return std::nullopt;
        }
        Vector2d step = jacobian.inverse() * error;
        const double limit = 0.5 * (p.norm() + 0.1);
        if (step.norm() > limit) {
            step *= limit / step.norm();
        }
        p -= step;
    }
    const bool found = (distorted(p) - target).norm() < 1e-9 * std::max(1.0, target.norm());
    return found && p.norm() <= m_largestField ? std::optional(p) : std::nullopt;
}

std::optional<Vector3d> CameraModel::ray(const Vector2d& pixel) const {
    const CameraIntrinsics& k = m_intrinsics;
    const Vector2d image((pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy);
    if (k.lens == LensModel::Pinhole) {
        return Vector3d(image.x(), image.y(), 1).normalized();
    }
    if (k.lens != LensModel::Equidistant) {
        const std::optional<Vector2d> plane = undistorted(image);
        return plane ? std::optional<Vector3d>(Vector3d(plane->x(), plane->y(), 1).normalized())
                     : std::nullopt;
    }
    const double radius = image.norm();
    if (!(radius <= distortedAngle(m_largestField))) {
        return std::nullopt;
    }
    double low = 0; // bisection: monotone up to the end of the field, and immune to any coefficients
    double high = m_largestField;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (distortedAngle(middle) < radius ? low : high) = middle;
    }
    const double angle = 0.5 * (low + high);
    const Vector2d across = radius > 0 ? Vector2d(image / radius * std::sin(angle)) : Vector2d::Zero();
    return Vector3d(across.x(), across.y(), std::cos(angle));
}

std::optional<Vector2d> CameraModel::project(const Vector3d& p) const {
    const CameraIntrinsics& k = m_intrinsics;
    Vector2d image;
    if (k.lens == LensModel::Equidistant) {
        const double across = std::hypot(p.x(), p.y());
        const double angle = std::atan2(across, p.z());
        if (!(angle <= m_largestField) || (across == 0 && p.z() <= 0)) {
            return std::nullopt;
        }
        image = across > 0 ? Vector2d(p.head<2>() / across * distortedAngle(angle)) : Vector2d::Zero();
    } else {
        if (!(p.z() > 0)) {
            return std::nullopt;
        }
        const Vector2d plane = p.head<2>() / p.z();
        if (!(plane.norm() <= m_largestField)) {
            return std::nullopt;
        }
        image = k.lens == LensModel::Pinhole ? plane : distorted(plane);
    }
    return Vector2d(k.fx * image.x() + k.cx, k.fy * image.y() + k.cy);
}

Calibration calibration(const CameraIntrinsics& camera) {
    const auto& [width, height, fx, fy, cx, cy, lens, distortion] = camera;
    const bool isPinhole = lens == LensModel::Pinhole;
    return {width,
            height,
            std::string(name(isPinhole ? LensModel::PlumbBob : lens)),
            isPinhole ? std::vector<double>(5) : distortion,
            {fx, 0, cx, 0, fy, cy, 0, 0, 1},
            {1, 0, 0, 0, 1, 0, 0, 0, 1},
            {fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0}};
}

namespace {

LensModel lensOf(const Calibration& calibration) {
    if (std::all_of(calibration.d.begin(), calibration.d.end(), [](double one) { return one == 0; })) {
        return LensModel::Pinhole;
    }
    for (const LensModel lens :
         {LensModel::PlumbBob, LensModel::RationalPolynomial, LensModel::Equidistant}) {
        if (calibration.distortionModel == name(lens)) {
            return lens;
        }
    }
    throw Error(ErrorKind::Unsupported,
                text("The distortion model \"", printable(calibration.distortionModel),
                     "\" is unknown; there are plumb_bob, rational_polynomial and equidistant."));
}

} // namespace

CameraIntrinsics intrinsicsOf(const Calibration& calibration) {
    const auto& k = calibration.k;
    if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1) {
        throw Error(
            ErrorKind::Unsupported,
            "The camera matrix K is not fx 0 cx, 0 fy cy, 0 0 1; a camera with skewed pixels cannot be "
            "simulated.");
    }
    const LensModel lens = lensOf(calibration);
    CameraIntrinsics camera{calibration.width,
                            calibration.height,
                            k[0],
                            k[4],
                            k[2],
                            k[5],
                            lens,
                            lens == LensModel::Pinhole ? std::vector<double>() : calibration.d};
    camera.validate();
    return camera;
}

} // namespace spherewalk
