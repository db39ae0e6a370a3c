// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/scene/depth_sweep.h"
#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <array>
#include <span>

namespace spherewalk::scene {

/// What a camera carries along: its cart, tripod or robot, a hand that holds it, or an operator who always
/// stands on the same side of it. All photos show it at about the same place. It reaches from straight down
/// up to an angle that depends on the azimuth. Frames: the photos' own.
class CarriedThings {
  public:
    static constexpr int kAzimuths = 180;

    /// Nothing is carried along.
    CarriedThings() = default;

    /// reachRad: the angles from straight down, one for each two degrees of azimuth from -pi on.
    explicit CarriedThings(const std::array<float, kAzimuths>& reachRad) : m_reachRad(reachRad) {}

    bool empty() const;

    /// The share of the sphere that they cover.
    double share() const;

    /// How far a direction lies within their border: an angle in radians, below 0 outside. Range: any length
    /// but 0.
    double depthInside(const Eigen::Vector3d& pInPhoto) const;

    /// The same. azimuth: in radians, from -pi to pi. angle: from straight down.
    double depthInside(double azimuth, double angle) const;

    const std::array<float, kAzimuths>& reachRad() const { return m_reachRad; }

  private:
    std::array<float, kAzimuths> m_reachRad{};
};

/// Finds what the camera carries along, from up to 24 of the photos. Its edges are at the same place in
/// most photos; edges of the room move, as the camera does. Where it moves a little, as a hand does, the
/// colour of most photos changes there from what is alike in all to what is not. It finds nothing if there
/// are fewer than six photos or if all stand at one place. In one line, edges along it do not count, and no
/// hand is found. Range: pictures of about 256 pixels are enough. Errors: InvalidInput for an empty
/// picture.
CarriedThings carriedThings(std::span<const PosedPicture> photos);

/// A picture and which of its pixels are other than they were.
struct FilledPicture {
    RgbImage picture;
    MaskImage filled; ///< 255 where a pixel was replaced.
};

/// The photo with floor and walls in place of what is carried along, as other photos show them. Those that
/// stand near a place and see it beside what they carry themselves give its colour, each as bright as the
/// photo is about there (Farbman et al., Coordinates for instant image cloning, 2009). What none of them
/// sees stays. The room is its drawn outline and its ceiling; without an outline it is a floor, and what
/// lies less than 15 degrees below the horizon stays. Range: roomFromPhoto of all photos above the floor.
FilledPicture withoutCarried(const PosedPicture& photo, std::span<const PosedPicture> others,
                             const CarriedThings& things, const survey::Room& room);

} // namespace spherewalk::scene
