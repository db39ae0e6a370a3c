// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace spherewalk::survey {

/// A part of a photo that nobody shall recognise outside of the survey: a face, a screen, a sheet of paper.
/// It is a rectangle in the picture that a camera would show which looks at its middle and stands upright in
/// the photo. Frames: panorama.
struct PrivateRegion {
    Radians azimuth;   ///< Of the middle, counter-clockwise from the photo's middle column.
    Radians elevation; ///< Of the middle, above the photo's middle row.
    Radians width;     ///< The angle between the left and the right side, seen from the camera.
    Radians height;

    bool operator==(const PrivateRegion&) const = default;

    /// Errors: InvalidInput for numbers that are not finite, an elevation beyond a pole, and sizes outside
    /// [kLeastRegion, kLargestRegion].
    void validate() const;
};

inline constexpr Degrees kLeastRegion{0.1};
inline constexpr Degrees kLargestRegion{150};

/// Where directions lie in a region. The middle is (0, 0), the sides are at -1 and 1; x runs to the right and
/// y upwards.
class RegionFrame {
  public:
    /// Range: a valid region.
    explicit RegionFrame(const PrivateRegion& region);

    /// Nothing for directions more than 90 degrees from the middle. Range: not the zero vector.
    std::optional<Eigen::Vector2d> at(const Eigen::Vector3d& direction) const;
    /// The unit vector to this place. Range: finite.
    Eigen::Vector3d direction(const Eigen::Vector2d& at) const;

    bool contains(const Eigen::Vector3d& direction) const;

    const Eigen::Vector3d& middle() const { return m_forward; }

    /// The angle between the middle and a corner.
    Radians reach() const;

  private:
    Eigen::Vector3d m_forward;
    Eigen::Vector3d m_right;
    Eigen::Vector3d m_up;
    Eigen::Vector2d m_half; ///< Tangents of half the width and half the height.
};

/// The region around this direction with these angles. Range: not the zero vector.
PrivateRegion regionAround(const Eigen::Vector3d& middle, Radians width, Radians height);

/// Whether both show the same thing: the middle of one lies within the other.
bool isSameThing(const PrivateRegion& a, const PrivateRegion& b);

/// Whether any of the regions shows the same thing.
bool isAmong(const PrivateRegion& region, std::span<const PrivateRegion> others);

} // namespace spherewalk::survey
