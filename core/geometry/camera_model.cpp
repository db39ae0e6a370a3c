// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/camera_model.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

namespace spherewalk {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// The counts of distortion parameters that a lens model may have. The greatest is last.
std::vector<std::size_t> parameterCounts(LensModel lens) {
    switch (lens) {
    case LensModel::Pinhole:
        return {0};
    case LensModel::PlumbBob:
        return {5};
    case LensModel::RationalPolynomial:
        return {8, 12, 14};
    case LensModel::Equidistant:
        break;
    }
    return {4};
}

bool isOneOf(std::size_t count, const std::vector<std::size_t>& counts) {
    return std::find(counts.begin(), counts.end(), count) != counts.end();
}

bool areZero(const double* begin, const double* end) {
    return std::all_of(begin, end, [](double one) { return one == 0; });
}

/// Takes the distorted picture to the picture on a sensor that is tilted about its x and y axes, as OpenCV's
/// calib3d does.
Eigen::Matrix3d tiltOf(double aboutX, double aboutY) {
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(-aboutY, Vector3d::UnitY()) * Eigen::AngleAxisd(-aboutX, Vector3d::UnitX()))
            .toRotationMatrix();
    Eigen::Matrix3d onSensor;
    onSensor << turn(2, 2), 0, -turn(0, 2), 0, turn(2, 2), -turn(1, 2), 0, 0, 1;
    return onSensor * turn;
}

[[noreturn]] void refuseCamera(const std::string& what) {
    throw Error(ErrorKind::InvalidInput, text("The camera model cannot be used: ", what, "."));
}

} // namespace

std::optional<LensModel> lensNamed(std::string_view lensName) {
    for (const LensModel lens :
         {LensModel::Pinhole, LensModel::PlumbBob, LensModel::RationalPolynomial, LensModel::Equidistant}) {
        if (lensName == name(lens)) {
            return lens;
        }
    }
    return std::nullopt;
}

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
    const std::vector<std::size_t> counts = parameterCounts(lens);
    if (!isOneOf(distortion.size(), counts)) {
        const std::string possible = counts.size() == 1 ? text(counts[0]) : text("8, 12 or 14");
        refuseCamera(text("the lens model ", name(lens), " has ", possible, " distortion parameters, not ",
                          distortion.size()));
    }
    if (!std::all_of(distortion.begin(), distortion.end(), [](double k) { return std::isfinite(k); })) {
        refuseCamera("a distortion parameter is not a number");
    }
    constexpr double kSteepest = 0.5 * std::numbers::pi;
    if (distortion.size() == kMostDistortion &&
        !(std::abs(distortion[12]) < kSteepest && std::abs(distortion[13]) < kSteepest)) {
        refuseCamera("its sensor is tilted by a quarter turn or more");
    }
}

CameraModel::CameraModel(CameraIntrinsics intrinsics) : m_intrinsics(std::move(intrinsics)) {
    m_intrinsics.validate();
    m_k = m_intrinsics.distortion;
    m_k.resize(CameraIntrinsics::kMostDistortion, 0.0);
    if (!areZero(&m_k[12], &m_k[12] + 2)) {
        m_tilt = tiltOf(m_k[12], m_k[13]);
        m_untilted = m_tilt->inverse();
    }
    m_largestField = largestField();
    if (!seesAnything()) {
        refuseCamera(
            text("its lens sees nothing in the picture; check the parameters of ", name(m_intrinsics.lens)));
    }
}

/// Whether a place of the picture has a ray: of some all over it, and of the pixels about the principal
/// point. That point alone tells nothing: its ray is the axis, whatever the distortion.
bool CameraModel::seesAnything() const {
    if (m_intrinsics.lens == LensModel::Pinhole) {
        return true;
    }
    const Vector2d principal(m_intrinsics.cx, m_intrinsics.cy);
    const Vector2d last(width() - 1, height() - 1);
    constexpr int kSteps = 16;
    constexpr int kAbout = 4;
    constexpr double kBesideAxisPx = 0.25;
    std::vector<Vector2d> places;
    for (int i = 0; i < kAbout * kAbout; ++i) {
        const Vector2d first = principal.array().floor() - 1;
        places.emplace_back(first + Vector2d(i % kAbout, i / kAbout));
    }
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const Vector2d cell(i % kSteps, i / kSteps);
        places.emplace_back(last.array() * (cell.array() + 0.5) / kSteps);
    }
    std::erase_if(places, [&](const Vector2d& place) {
        return (place.array() < 0).any() || (place.array() > last.array()).any() ||
               (place - principal).norm() < kBesideAxisPx;
    });
    return places.empty() || std::any_of(places.begin(), places.end(),
                                         [&](const Vector2d& place) { return ray(place).has_value(); });
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
            return unfoldedField(end * (i - 1) / kSteps);
        }
        last = image;
    }
    return m_intrinsics.lens == LensModel::Pinhole ? HUGE_VAL : unfoldedField(end);
}

/// Where the field ends, at most at `end`, since parts of the distortion that are not radial fold the picture
/// over in some direction.
double CameraModel::unfoldedField(double end) const {
    const bool isRadial = m_k[2] == 0 && m_k[3] == 0 && areZero(&m_k[8], &m_k[8] + 4);
    if (m_intrinsics.lens == LensModel::Equidistant || isRadial) {
        return end;
    }
    constexpr int kDirections = 16;
    constexpr double kFirst = 0.02;
    constexpr double kStep = 1.01;
    double last = 0;
    for (double field = kFirst; field < end; last = field, field *= kStep) {
        for (int i = 0; i < kDirections; ++i) {
            const double towards = 2 * std::numbers::pi * i / kDirections;
            const Vector2d at = field * Vector2d(std::cos(towards), std::sin(towards));
            if (!(jacobian(at).determinant() > 0)) {
                return last;
            }
        }
    }
    return end;
}

Eigen::Matrix2d CameraModel::jacobian(const Vector2d& p) const {
    const double h = 1e-6 * std::max(1.0, p.norm());
    Eigen::Matrix2d result;
    result.col(0) = (distorted(p + Vector2d(h, 0)) - distorted(p - Vector2d(h, 0))) / (2 * h);
    result.col(1) = (distorted(p + Vector2d(0, h)) - distorted(p - Vector2d(0, h))) / (2 * h);
    return result;
}

Vector2d CameraModel::distorted(const Vector2d& p) const {
    const double r2 = p.squaredNorm();
    const double p1 = m_k[2];
    const double p2 = m_k[3];
    const Vector2d tangential(2 * p1 * p.x() * p.y() + p2 * (r2 + 2 * p.x() * p.x()),
                              p1 * (r2 + 2 * p.y() * p.y()) + 2 * p2 * p.x() * p.y());
    const Vector2d prism(r2 * (m_k[8] + r2 * m_k[9]), r2 * (m_k[10] + r2 * m_k[11]));
    return p * radialFactor(r2) + tangential + prism;
}

std::optional<Vector2d> CameraModel::undistorted(const Vector2d& target) const {
    // Newton's method with a numeric Jacobian, damped: converges in a few steps inside the field.
    Vector2d p = target;
    for (int iteration = 0; iteration < 50; ++iteration) {
        const Vector2d error = distorted(p) - target;
        if (error.norm() < 1e-13 * std::max(1.0, target.norm())) {
            break;
        }
        const Eigen::Matrix2d slope = jacobian(p);
        if (std::abs(slope.determinant()) < 1e-12) {
            return std::nullopt;
        }
        Vector2d step = slope.inverse() * error;
        const double limit = 0.5 * (p.norm() + 0.1);
        if (step.norm() > limit) {
            step *= limit / step.norm();
        }
        p -= step;
    }
    const bool found = (distorted(p) - target).norm() < 1e-9 * std::max(1.0, target.norm());
    return found && p.norm() <= m_largestField ? std::optional(p) : std::nullopt;
}

namespace {

/// Where the matrix takes a point of the plane; nothing if that is behind the plane.
std::optional<Vector2d> projected(const Eigen::Matrix3d& matrix, const Vector2d& p) {
    const Vector3d to = matrix * p.homogeneous();
    return to.z() > 0 ? std::optional<Vector2d>(to.hnormalized()) : std::nullopt;
}

/// The angle up to `largest` that a fisheye with these coefficients shows at this radius. distorted: the
/// radius of an angle, which grows up to `largest`.
double fisheyeAngle(double radius, double largest, const std::vector<double>& k,
                    const std::function<double(double)>& distorted) {
    // Newton's method. It halves the bounds wherever it would leave them, as a bend of the curve may throw
    // it.
    constexpr int kMostSteps = 100;
    constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();
    double low = 0;
    double high = largest;
    double angle = std::min(radius, largest);
    for (int i = 0; i < kMostSteps; ++i) {
        const double error = distorted(angle) - radius;
        (error < 0 ? low : high) = angle;
        const double a2 = angle * angle;
        const double slope = 1 + a2 * (3 * k[0] + a2 * (5 * k[1] + a2 * (7 * k[2] + a2 * (9 * k[3]))));
        const double next = angle - error / slope;
        if (std::abs(next - angle) <= kRounding * angle) {
            return std::clamp(next, low, high);
        }
        angle = next > low && next < high ? next : 0.5 * (low + high);
    }
    return angle;
}

} // namespace

std::optional<Vector3d> CameraModel::ray(const Vector2d& pixel) const {
    const CameraIntrinsics& k = m_intrinsics;
    const Vector2d image((pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy);
    if (k.lens == LensModel::Pinhole) {
        return Vector3d(image.x(), image.y(), 1).normalized();
    }
    if (k.lens != LensModel::Equidistant) {
        const std::optional<Vector2d> upright = m_tilt ? projected(m_untilted, image) : image;
        const std::optional<Vector2d> plane = upright ? undistorted(*upright) : std::nullopt;
        return plane ? std::optional<Vector3d>(Vector3d(plane->x(), plane->y(), 1).normalized())
                     : std::nullopt;
    }
    const double radius = image.norm();
    if (!(radius <= distortedAngle(m_largestField))) {
        return std::nullopt;
    }
    const double angle =
        fisheyeAngle(radius, m_largestField, m_k, [this](double a) { return distortedAngle(a); });
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
        if (m_tilt) {
            const std::optional<Vector2d> onSensor = projected(*m_tilt, image);
            if (!onSensor) {
                return std::nullopt;
            }
            image = *onSensor;
        }
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

/// The lens of a calibration with the count of parameters that the model has. Simulators write zero
/// distortion, which a pinhole says more simply. An equidistant lens without distortion is still a fisheye.
void takeLens(const Calibration& calibration, CameraIntrinsics& camera) {
    const std::string& model = calibration.distortionModel;
    const std::vector<double>& d = calibration.d;
    const bool isZero = areZero(d.data(), d.data() + d.size());
    const std::optional<LensModel> lens = model.empty()        ? LensModel::Pinhole
                                          : model == "fisheye" ? LensModel::Equidistant
                                                               : lensNamed(model);
    if (!lens) {
        throw Error(ErrorKind::Unsupported,
                    text("The distortion model \"", printable(model),
                         "\" is unknown; there are plumb_bob, rational_polynomial and equidistant."));
    }
    if (*lens == LensModel::Pinhole && !isZero) {
        throw Error(ErrorKind::InvalidInput,
                    "The camera has distortion coefficients and names no distortion model; name plumb_bob, "
                    "rational_polynomial or equidistant, or leave the coefficients out.");
    }
    if (*lens != LensModel::Equidistant && isZero) {
        return;
    }
    camera.lens = *lens;
    camera.distortion = d;
    if (camera.lens == LensModel::PlumbBob && d.size() == 4) {
        camera.distortion.push_back(0); // k3 left out, as OpenCV allows
    }
    if (camera.lens == LensModel::Equidistant && d.empty()) {
        camera.distortion.resize(4);
    }
    for (const std::size_t count : parameterCounts(camera.lens)) {
        if (camera.distortion.size() > count && isOneOf(d.size(), parameterCounts(camera.lens)) &&
            areZero(d.data() + count, d.data() + d.size())) {
            camera.distortion.resize(count);
        }
    }
}

void checkMatrix(const std::array<double, 9>& k) {
    if (k[1] != 0) {
        throw Error(ErrorKind::Unsupported,
                    text("The camera matrix K has the skew ", k[1],
                         ", and skewed pixels cannot be simulated. Calibrate the camera without skew."));
    }
    if (k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1) {
        throw Error(ErrorKind::Unsupported,
                    "The camera matrix K is not fx 0 cx, 0 fy cy, 0 0 1. Give the focal lengths and the "
                    "centre in pixels, and 1 as the last entry.");
    }
}

} // namespace

CameraIntrinsics intrinsicsOf(const Calibration& calibration) {
    const auto& k = calibration.k;
    checkMatrix(k);
    CameraIntrinsics camera{
        calibration.width, calibration.height, k[0], k[4], k[2], k[5], LensModel::Pinhole, {}};
    takeLens(calibration, camera);
    camera.validate();
    return camera;
}

} // namespace spherewalk
