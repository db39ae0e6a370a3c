// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/private_region.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace spherewalk::survey {

using Eigen::Vector2d;
using Eigen::Vector3d;

void PrivateRegion::validate() const {
    const auto fail = [](std::string_view why) {
        throw Error(ErrorKind::InvalidInput, text("This is no region of a photo: ", why, "."));
    };
    for (const Radians angle : {azimuth, elevation, width, height}) {
        if (!std::isfinite(angle.value())) {
            fail("an angle is no number");
        }
    }
    if (std::abs(Degrees(elevation).value()) > 90 + 1e-9) {
        fail(text("an elevation of ", Degrees(elevation).value(),
                  " degrees lies beyond a pole; it must be -90 to 90"));
    }
    for (const Radians size : {width, height}) {
        if (size < Radians(kLeastRegion) || size > Radians(kLargestRegion)) {
            fail(text("a side of ", Degrees(size).value(), " degrees must be ", kLeastRegion.value(), " to ",
                      kLargestRegion.value()));
        }
    }
}

// The azimuth gives the sides a direction at the poles, too.
RegionFrame::RegionFrame(const PrivateRegion& region)
    : m_forward(spherewalk::direction(SphericalDirection{region.azimuth, region.elevation})),
      m_right(sin(region.azimuth), -cos(region.azimuth), 0),
      m_up(m_right.cross(m_forward)),
      m_half(tan(region.width * 0.5), tan(region.height * 0.5)) {
}

std::optional<Vector2d> RegionFrame::at(const Vector3d& direction) const {
    const double along = direction.dot(m_forward);
    if (!(along > 0)) {
        return std::nullopt;
    }
    return Vector2d(direction.dot(m_right) / along / m_half.x(), direction.dot(m_up) / along / m_half.y());
}

Vector3d RegionFrame::direction(const Vector2d& at) const {
    return (m_forward + at.x() * m_half.x() * m_right + at.y() * m_half.y() * m_up).normalized();
}

bool RegionFrame::contains(const Vector3d& direction) const {
    const auto place = at(direction);
    return place && place->cwiseAbs().maxCoeff() <= 1;
}

Radians RegionFrame::reach() const {
    return Radians(std::atan(m_half.norm()));
}

PrivateRegion regionAround(const Vector3d& middle, Radians width, Radians height) {
    const SphericalDirection angles = sphericalDirection(middle);
    return {angles.azimuth, angles.elevation, width, height};
}

bool isSameThing(const PrivateRegion& a, const PrivateRegion& b) {
    const RegionFrame inA(a);
    const RegionFrame inB(b);
    return inA.contains(inB.middle()) || inB.contains(inA.middle());
}

bool isAmong(const PrivateRegion& region, std::span<const PrivateRegion> others) {
    return std::ranges::any_of(others,
                               [&](const PrivateRegion& other) { return isSameThing(region, other); });
}

} // namespace spherewalk::survey
