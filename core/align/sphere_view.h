// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "resample.h"

#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

#include <vector>

namespace spherewalk::align {

/// A picture of a part of the sphere that distorts no angles, with a margin around the part that is its own:
/// together the views' own parts are the sphere, each direction once. Pixel centres are integers. Source:
/// Snyder 1987, Map Projections, Mercator and stereographic.
class SphereView {
  public:
    static constexpr int kMargin = 48; ///< pixels on all sides

    /// Around the horizon, from lowest (or the lower cap's edge) to the upper cap's edge.
    static SphereView band(const GreyImage& photo, int width, Radians lowest);
    /// Around the zenith or the nadir, seen from inside.
    static SphereView cap(const GreyImage& photo, int width, bool isZenith);

    /// The caps begin here: there the band's pixels are 1.7 times as fine as at the horizon.
    static constexpr Radians edge() { return Degrees(53); }

    const GreyImage& picture() const { return m_picture; }

    /// Unit vector in the photo's panorama frame. Range: any pixel.
    Eigen::Vector3d bearing(double x, double y) const;
    /// The angle that a pixel's side spans there.
    double pixelRad(double x, double y) const;
    /// Where the zenith is, seen from there: the angle from the picture's +x to its +y.
    Radians up(double x, double y) const;
    /// True for the part that no other view has, and that no second pixel of this one shows.
    bool owns(double x, double y) const;

  private:
    enum class Part { Band, Zenith, Nadir };

    SphereView(Part part, int width) : m_part(part), m_width(width) {}

    double pixelsPerRad() const;
    Eigen::Vector2d onPlane(double x, double y) const; ///< of a cap, from its middle, radians

    Part m_part;
    int m_width;
    double m_top = 0; ///< band: Mercator ordinate of the upper edge
    GreyImage m_picture;
};

/// The views that together show all from the lowest elevation to the zenith, or to the caps' edge.
std::vector<SphereView> sphereViews(const GreyImage& photo, int width, Radians lowest, bool usesZenith);

} // namespace spherewalk::align
