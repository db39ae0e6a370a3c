// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk {

/// The lens models that ROS camera_info names.
enum class LensModel {
    Pinhole,            ///< No distortion. Files spell it "" or "none".
    PlumbBob,           ///< Brown-Conrady: k1 k2 p1 p2 k3.
    RationalPolynomial, ///< Parameters k1 k2 p1 p2 k3 k4 k5 k6; then s1 s2 s3 s4 of a thin prism; then the
                        ///< angles of a tilted sensor. There are 8, 12 or 14.
    Equidistant,        ///< Fisheye: k1 k2 k3 k4 of the angle to the axis.
};

/// The name in ROS messages; "none" for a pinhole.
std::string_view name(LensModel model);

/// The lens model of that name(), if there is one.
std::optional<LensModel> lensNamed(std::string_view lensName);

/// The intrinsic parameters of a robot's camera. Frames: optical, z forward, x right, y down.
/// Units: pixels; the centre of pixel (0, 0) has the coordinates (0, 0).
/// Source: ROS sensor_msgs/CameraInfo, OpenCV calib3d and fisheye.
struct CameraIntrinsics {
    /// No lens model has more distortion parameters.
    static constexpr std::size_t kMostDistortion = 14;

    int width = 0;
    int height = 0;
    double fx = 0;
    double fy = 0;
    double cx = 0;
    double cy = 0;
    LensModel lens = LensModel::Pinhole;
    std::vector<double> distortion; ///< All parameters of the lens model, in its order.

    bool operator==(const CameraIntrinsics& other) const;

    /// A camera without distortion whose axis meets the picture's centre. Range: 0 < horizontalFovRad < pi.
    static CameraIntrinsics pinhole(int width, int height, double horizontalFovRad);

    /// Throws for a camera that cannot exist. Errors: InvalidInput for sizes outside [1, 32768], focal
    /// lengths that are not positive, values that are not finite, a wrong count of distortion parameters, or
    /// a sensor that is tilted by a quarter turn or more.
    void validate() const;
};

/// Takes pixels of a camera to rays and back. Threads: any number may share one.
class CameraModel {
  public:
    /// Errors: those of CameraIntrinsics::validate(); InvalidInput for a lens that sees nothing.
    explicit CameraModel(CameraIntrinsics intrinsics);

    const CameraIntrinsics& intrinsics() const { return m_intrinsics; }

    int width() const { return m_intrinsics.width; }

    int height() const { return m_intrinsics.height; }

    /// The unit direction in the optical frame that lands on this pixel. Nothing beyond the field in which
    /// the distortion is invertible.
    std::optional<Eigen::Vector3d> ray(const Eigen::Vector2d& pixel) const;

    /// The pixel on which this point or direction of the optical frame lands, inside the picture or outside.
    /// Nothing for a point behind the camera or beyond the field in which the distortion is invertible.
    std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& pInOptical) const;

  private:
    std::optional<Eigen::Vector2d> undistorted(const Eigen::Vector2d& distorted) const;
    Eigen::Vector2d distorted(const Eigen::Vector2d& undistorted) const;
    double distortedAngle(double angle) const;
    double radialFactor(double radiusSquared) const;
    Eigen::Matrix2d jacobian(const Eigen::Vector2d& undistorted) const;
    double largestField() const;
    double unfoldedField(double end) const;
    bool seesAnything() const;

    CameraIntrinsics m_intrinsics;
    std::vector<double> m_k;               ///< The distortion, padded with zeros.
    double m_largestField = 0;             ///< Up to this undistorted radius, or angle, the distortion grows.
    std::optional<Eigen::Matrix3d> m_tilt; ///< That of a tilted sensor, and its inverse.
    Eigen::Matrix3d m_untilted = Eigen::Matrix3d::Identity();
};

/// A camera in the form of sensor_msgs/CameraInfo and gz.msgs.CameraInfo. Shape: k and r are 3 x 3, p is
/// 3 x 4, row after row.
struct Calibration {
    int width = 0;
    int height = 0;
    std::string distortionModel; ///< "plumb_bob", "rational_polynomial" or "equidistant".
    std::vector<double> d;       ///< All parameters of the model; five zeros for a pinhole.
    std::array<double, 9> k{};
    std::array<double, 9> r{};  ///< The identity, because there is one camera.
    std::array<double, 12> p{}; ///< The matrix k with a baseline of zero.
};

Calibration calibration(const CameraIntrinsics& camera);

/// The camera of a calibration from outside. The distortion model may also be "fisheye", "none" or empty.
/// Parameters that are zero are left out where that changes nothing: plumb_bob without distortion becomes a
/// pinhole. The matrices r and p concern rectified pictures and are ignored. Errors: InvalidInput for numbers
/// that describe no camera, and for distortion without a model. Unsupported for an unknown distortion model,
/// and for a matrix k with entries besides focal lengths and centre.
CameraIntrinsics intrinsicsOf(const Calibration& calibration);

} // namespace spherewalk
