// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/foreign_check.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::align {

/// Directions of a photo are looked at on this grid, in the rows of an equirectangular picture.
inline constexpr int kSightColumns = 256;
inline constexpr int kSightRowsOfSphere = kSightColumns / 2;
inline constexpr int kSightTop = 14; ///< The row of 70 degrees above the horizon.
inline constexpr int kSightRows = 82;
inline constexpr int kSightCells = kSightColumns * kSightRows;

/// Distances are looked at at these steps of 1 / distance, the nearest first, the last at infinity.
inline constexpr int kSightLevels = 56;
inline constexpr double kNearestSightM = 0.35;

/// 1 / distance of a level, per metre.
inline double inverseOf(int level) {
    return (kSightLevels - 1 - level) / ((kSightLevels - 1) * kNearestSightM);
}

/// The unit vector of a cell, in the photo's frame.
Eigen::Vector3f sightDirection(int row, int column);

inline constexpr float kSightPi = std::numbers::pi_v<float>;

/// Good to 0.0003 radians, a hundredth of a cell. Without branches, so that several are made at once.
inline float quickAtan2(float y, float x) {
    const float ax = std::abs(x);
    const float ay = std::abs(y);
    const float most = std::max(ax, ay);
    const float a = std::min(ax, ay) / (most + 1e-20F);
    const float s = a * a;
    float r = ((-0.0464964749F * s + 0.15931422F) * s - 0.327622764F) * s * a + a;
    r = ay > ax ? kSightPi / 2 - r : r;
    r = x < 0 ? kSightPi - r : r;
    return y < 0 ? -r : r;
}

/// The place of a direction in a picture, in pixels from its upper left corner.
struct SightPlace {
    float u = 0;
    float v = 0;
};

/// Where an equirectangular picture of this width shows a direction of any length.
inline SightPlace placeOf(const Eigen::Vector3f& d, float width) {
    const float perRadian = width / (2 * kSightPi);
    return {(kSightPi - quickAtan2(d.y(), d.x())) * perRadian,
            (kSightPi / 2 - quickAtan2(d.z(), std::sqrt(d.x() * d.x() + d.y() * d.y()))) * perRadian};
}

/// The cell that shows a direction of any length; -1 above and below the rows.
int sightCell(const Eigen::Vector3f& direction);

/// What a photo's neighbours say of one of its cells. Bit k stands for level k.
struct CellSight {
    std::uint64_t shown = 0;      ///< A neighbour shows the same at this distance.
    std::uint64_t shownTwice = 0; ///< Two neighbours do.
    /// 1 / distance between which the surface lies, per metre. Both are negative where nothing tells.
    float nearest = -1;
    float farthest = -1;

    bool isKnown() const { return nearest >= 0; }
};

/// A photo with what its neighbours say of it. Empty if the photo has no picture, pose or neighbours.
using PhotoSight = std::vector<CellSight>;

/// What makes the colours of a photo like those of the others: a factor for each direction and channel, which
/// changes slowly from one direction to the next. Two lenses are not equally bright, and neither are two
/// photos of a room in which a lamp was lit in between.
struct GainField {
    static constexpr int kTerms = 10;
    using Terms = Eigen::Matrix<float, kTerms, 1>;

    Eigen::Matrix<float, 3, kTerms> logs = Eigen::Matrix<float, 3, kTerms>::Zero(); ///< A row a channel.

    /// What is multiplied with logs: 1, the three coordinates and their products, and which of two lenses,
    /// one ahead and one behind, sees the direction; of about equal size.
    static Terms terms(const Eigen::Vector3f& directionInPhoto);
    Eigen::Vector3f at(const Eigen::Vector3f& directionInPhoto) const;
};

/// They are measured where photos show the same point of the room: equal directions of photos that stand
/// apart show different things, which need not be equally bright. Such points are found without the gains.
/// Source: medians of the ratios of photos that stand near each other, averaged over the survey; then least
/// squares of what the points say beyond them, as far as it changes slowly.
std::vector<GainField> gainsOf(std::span<const SightPhoto> photos,
                               std::span<const std::vector<int>> neighbours, int threads,
                               const std::stop_token& stop);

/// A pixel, and what lies between it and the pixels around it: a byte for each channel. Where the photo is
/// burnt out, the true value may be any that is greater.
struct SoftPixel {
    std::uint32_t middle = 0;
    std::uint32_t top = 0; ///< The middle, or 255 if it is burnt out.
    std::uint32_t least = 0;
    std::uint32_t greatest = 0;
};

using SoftPicture = std::vector<SoftPixel>;

/// The same pictures, softened, and with their gains.
std::vector<SoftPicture> softened(std::span<const SightPhoto> photos, std::span<const GainField> gains);

/// Compares one photo with its neighbours at all levels. pictures: as softened() makes them.
PhotoSight sightOf(int photo, std::span<const SightPhoto> photos, std::span<const SoftPicture> pictures,
                   std::span<const int> neighbours);

/// A photo that tells what it sees of places in the room.
struct Observer {
    Eigen::Matrix3f photoFromRoom = Eigen::Matrix3f::Identity();
    Eigen::Vector3f positionM = Eigen::Vector3f::Zero();
    /// The nearest and the farthest surface of each cell and those around it, as 1 / distance. Both are
    /// negative where nothing is known of the cell.
    std::vector<float> nearest;
    std::vector<float> farthest;
};

Observer observer(const SightPhoto& photo, const PhotoSight& sight);

/// Whether a cell shows something that stands where other photos look through.
enum class Foreign : std::uint8_t {
    No,
    Unwitnessed, ///< It shows what no other does, but hardly any looks through where it may stand.
    Yes,
};

/// Of each cell of a photo.
std::vector<Foreign> foreignCells(const SightPhoto& photo, const PhotoSight& sight,
                                  std::span<const Observer* const> observers);

} // namespace spherewalk::align
