// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/scene/depth_sweep.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk::scene {

/// With them photos are about equally bright, as the camera's settings tell. A photo whose settings are not
/// known has none. No photo has if all have the same settings: then something else makes photos differ.
/// stops: see photo::exposureStops().
std::vector<std::optional<Gains>> toldGains(std::span<const std::optional<double>> stops);

/// The gains with which other photos are as bright as this one, without depths: what the camera's settings
/// tell, or else the median of the factor over directions, since two photos of a room mostly show the same
/// wall in a direction. Burnt and black pixels do not count. A gain that cannot be told from 1 is 1.
std::vector<Gains> gainsTo(const PosedPicture& photo, std::span<const PosedPicture> others);

/// The same over places that the photo shows, where it is about known how far away they are. Beside a wall
/// that is nearer than the other photo, the same direction shows other things. Where the settings of both
/// photos are known, they count as well: the more, the more the factors of places differ, and the less, the
/// more they contradict photos whose places agree. inverseM: 1 / distance, of an equirectangular picture of
/// any size.
std::vector<Gains> gainsTo(const PosedPicture& photo, const Image<float, 1>& inverseM,
                           std::span<const PosedPicture> others);

/// How the same places look in two photos.
struct SharedLight {
    static constexpr std::size_t kBins = 16;

    Gains gains{}; ///< With them, the other photo is as bright as this one.
    /// For red, green and blue, where the other photo has values about 16 i + 8: the median of this one's
    /// values. It is negative where they share less than 30 places.
    std::array<std::array<float, kBins>, 3> values{};
    double weight = 1; ///< How much the gains count among those of other photos.
};

/// How another photo shows the places that this one shows, as the depths of both tell. Gains are the median
/// of the factor. Burnt and black pixels do not count, and bright ones only where the photos share less than
/// a hundred darker places. Where they share less than a hundred places, it is what the camera's settings
/// tell, with little weight, or nothing. Range: pictures and depths of any 2:1 sizes; pictures of about 256
/// pixels are enough.
std::optional<SharedLight> sharedLight(const KnownPhoto& photo, const KnownPhoto& other);

/// How much brighter one photo is than another.
struct ExposureRatio {
    std::size_t photo = 0;
    std::size_t other = 0;
    SharedLight light;
};

/// The gains with which all photos are equally bright, in the mean of their logarithms as bright as they are.
/// The logarithms fit the ratios best by least squares. Photos that no ratio joins are each as bright as they
/// are. Range: gains above 0.
std::vector<Gains> commonGains(std::size_t photos, std::span<const ExposureRatio> ratios);

/// How softly the camera's values end at white, see render::exposedValue(): with it, gains make the photos'
/// values most alike, in steps of 0.01 up to 0.5. It is 0 where that is hardly better, or where too few
/// photos differ in brightness. gains: those of commonGains().
double highlightRolloff(std::span<const Gains> gains, std::span<const ExposureRatio> ratios);

} // namespace spherewalk::scene
