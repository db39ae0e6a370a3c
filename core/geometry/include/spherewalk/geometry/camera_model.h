// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk {

/// The lens models of ROS camera_info, by its names.
enum class LensModel {
    Pinhole,            ///< no distortion ("" or "none" in files)
    PlumbBob,           ///< k1 k2 p1 p2 k3 (Brown-Conrady)
    RationalPolynomial, ///< k1 k2 p1 p2 k3 k4 k5 k6
    Equidistant,        ///< k1 k2 k3 k4 of the angle to the axis (fisheye)
};

std::string_view name(LensModel model);

/// Intrinsic parameters of a robot's camera. Frames: optical, z forward, x right, y down. Units: pixels; the
/// centre of pixel (0, 0) has the coordinates (0, 0). Source: ROS sensor_msgs/CameraInfo, OpenCV calib3d and
/// fisheye.
struct CameraIntrinsics {
    int width = 0;
    int height = 0;
    double fx = 0;
    double fy = 0;
    double cx = 0;
    double cy = 0;
    LensModel lens = LensModel::Pinhole;
    std::vector<double> distortion; ///< as many as the lens model has, in its order

    bool operator==(const CameraIntrinsics&) const = default;

    /// A camera without distortion whose axis meets the picture's centre. Range: 0 < horizontalFov < pi.
    static CameraIntrinsics pinhole(int width, int height, double horizontalFovRad);

    /// Errors: InvalidInput with a sentence for sizes outside [1, 32768], focal lengths that are not
    /// positive, values that are not finite, and a count of distortion parameters that does not fit the lens.
    void validate() const;
};

/// A camera: pixels to rays and back. Threads: const, any number.
class CameraModel {
  public:
    /// Errors: those of CameraIntrinsics::validate().
    explicit CameraModel(CameraIntrinsics intrinsics);

    const CameraIntrinsics& intrinsics() const { return m_intrinsics; }

    int width() const { return m_intrinsics.width; }

    int height() const { return m_intrinsics.height; }

    /// The unit direction, in the optical frame, that lands on this pixel; nothing where the lens model has
    /// none (beyond the field in which its distortion is invertible).
    std::optional<Eigen::Vector3d> ray(const Eigen::Vector2d& pixel) const;

    /// The pixel on which this point or direction of the optical frame lands, inside the picture or not;
    /// nothing for what lies behind the camera or beyond the field in which the distortion is invertible.
    std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& pInOptical) const;

  private:
    std::optional<Eigen::Vector2d> undistorted(const Eigen::Vector2d& distorted) const;
    Eigen::Vector2d distorted(const Eigen::Vector2d& undistorted) const;
    double distortedAngle(double angle) const;
    double radialFactor(double radiusSquared) const;
    double largestField() const;

    CameraIntrinsics m_intrinsics;
    std::vector<double> m_k;   ///< the distortion, padded with zeros to 8 values
    double m_largestField = 0; ///< radius (undistorted) or angle up to which the distortion grows
};

} // namespace spherewalk
