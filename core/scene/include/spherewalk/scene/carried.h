// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/scene/depth_sweep.h"
#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <array>
#include <span>

namespace spherewalk::scene {

/// What a camera carries along: its cart, tripod or robot, or an operator who always stands on the same side
/// of it. All photos show it at the same place. It reaches from straight down up to an angle that depends on
/// the azimuth. Frames: the photos' own.
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

    const std::array<float, kAzimuths>& reachRad() const { return m_reachRad; }

  private:
    std::array<float, kAzimuths> m_reachRad{};
};

/// Finds what the camera carries along, from up to 24 of the photos. An edge belongs to it if most photos
/// show it at the same place of the photo. Edges of the room move, as the camera does. Walking up from
/// straight down, the carried things end at the last such edge before the room's own edges begin. It finds
/// nothing if there are fewer than six photos or if they stand in one line, since lines on the floor then
/// stay in place, too. Range: pictures of about 256 pixels are enough. Errors: InvalidInput for an empty
/// picture.
CarriedThings carriedThings(std::span<const PosedPicture> photos);

/// A picture and which of its pixels are other than they were.
struct FilledPicture {
    RgbImage picture;
    MaskImage filled; ///< 255 where a pixel was replaced.
};

/// The photo with floor and walls in place of what is carried along, as other photos show them. The three
/// that stand nearest to a place and see it beside their own cart give its colour: their median, each as
/// bright as the photo. What none of them sees stays as it is. The room is its drawn outline and its ceiling;
/// without an outline it is a floor, and what lies less than 15 degrees below the horizon stays. Range:
/// roomFromPhoto of all photos above the floor.
FilledPicture withoutCarried(const PosedPicture& photo, std::span<const PosedPicture> others,
                             const CarriedThings& things, const survey::Room& room);

} // namespace spherewalk::scene
