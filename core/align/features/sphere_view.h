// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace spherewalk::align {

using GreyImage = Image<std::uint8_t, 1>;

/// Luma of Rec. 601.
GreyImage grey(const RgbImage& picture);

/// How many times narrower a view shows things, as a flat thing is seen by who looks at it aslant.
struct Squeeze {
    double across = 1;
    double upright = 1;
};

/// A picture of a region of the sphere that distorts no angles, unless it is squeezed. Around the region that
/// the view owns there is a margin. Together the owned regions of all views are the sphere, each direction
/// once. Pixel centres are integers. Source: Snyder 1987, Map Projections, Mercator and stereographic.
class SphereView {
  public:
    static constexpr int kMargin = 48; ///< Pixels on all sides.

    /// A band around the horizon, from the lowest elevation (or the lower cap's edge) to the upper cap's
    /// edge.
    static SphereView band(const GreyImage& photo, int width, Radians lowest, Squeeze squeeze = {});
    /// A cap around the zenith or the nadir, seen from inside.
    static SphereView cap(const GreyImage& photo, int width, bool isZenith);

    /// The elevation where the caps begin. There the band's pixels are 1.7 times as fine as at the horizon.
    static constexpr Radians edge() { return Degrees(53); }

    const GreyImage& picture() const { return m_picture; }

    /// The direction of a pixel: a unit vector in the photo's panorama frame. Range: any pixel.
    Eigen::Vector3d bearing(double x, double y) const;
    /// The angle that a pixel's side spans at this place, the longer one of a squeezed view.
    double pixelRad(double x, double y) const;
    /// Whether the view owns this place: no other view has it, and no second pixel of this view shows it.
    bool owns(double x, double y) const;

  private:
    enum class Part { Band, Zenith, Nadir };

    SphereView(Part part, int width, double upright = 1)
        : m_part(part), m_width(width), m_perRadDown(pixelsPerRad() / upright) {}

    double pixelsPerRad() const;                       ///< Along a row.
    Eigen::Vector2d onPlane(double x, double y) const; ///< Place on a cap's plane, from its middle, radians.

    Part m_part;
    int m_width;
    double m_perRadDown; ///< Pixels a radian along a column.
    double m_top = 0;    ///< Mercator ordinate of a band's upper edge.
    GreyImage m_picture;
};

/// The views that together show the sphere from the lowest elevation to the zenith, or to the cap's edge.
std::vector<SphereView> sphereViews(const GreyImage& photo, int width, Radians lowest, bool usesZenith);

} // namespace spherewalk::align
