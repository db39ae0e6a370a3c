// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sweep_cost.h"
#include "vector_math.h"

#include "spherewalk/base/image.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/scene/carried.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

/// Directions of a photo by their azimuth and by steps from straight down, as CarriedThings has them.
namespace spherewalk::scene {

inline constexpr int kAzimuths = CarriedThings::kAzimuths;
inline constexpr double kPolarStepRad = 1.4 * std::numbers::pi / 180;
inline constexpr int kPolarSteps = 78; ///< To 20 degrees above the horizon.

/// The direction at an angle from straight down.
inline Eigen::Vector3d fromBelow(double azimuth, double angle) {
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), -std::cos(angle)};
}

inline double azimuthOf(int index) {
    return -std::numbers::pi + 2 * std::numbers::pi * (index + 0.5) / kAzimuths;
}

/// The inverse of azimuthOf(). Range: azimuth in radians, from -pi to pi.
inline double indexOf(double azimuth) {
    return (azimuth + std::numbers::pi) / (2 * std::numbers::pi) * kAzimuths - 0.5;
}

inline Eigen::Vector3d wayOf(int azimuth, int step) {
    return fromBelow(azimuthOf(azimuth), (step + 0.5) * kPolarStepRad);
}

/// Where a picture shows a direction.
inline FastPixel placeIn(const RgbImage& picture, const Eigen::Vector3d& way) {
    const Eigen::Vector3f to = way.cast<float>();
    return fastPixel(to.x(), to.y(), to.z(), static_cast<float>(picture.width()));
}

inline Eigen::Vector3f colourAt(const RgbImage& picture, const FastPixel& at) {
    Eigen::Vector3f colour;
    sampleColour(picture, at.u, at.v, colour.data());
    return colour;
}

/// A value for each azimuth and each step up from straight down.
template <class Value>
class PolarMap {
  public:
    PolarMap() : m_values(static_cast<std::size_t>(kAzimuths) * kPolarSteps) {}

    /// Range: azimuth from -kAzimuths on.
    Value& at(int azimuth, int step) {
        const auto row = static_cast<std::size_t>((azimuth + kAzimuths) % kAzimuths);
        return m_values[row * kPolarSteps + static_cast<std::size_t>(step)];
    }

    const Value& at(int azimuth, int step) const { return const_cast<PolarMap*>(this)->at(azimuth, step); }

    /// Sets each value to what find(azimuth, step) returns.
    template <class Find>
    explicit PolarMap(const Find& find) : PolarMap() {
        for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
            for (int step = 0; step < kPolarSteps; ++step) {
                at(azimuth, step) = static_cast<Value>(find(azimuth, step));
            }
        }
    }

    /// The median from the first of these steps up to the other.
    Value median(int begin, int end) const {
        std::vector<Value> values;
        for (int azimuth = 0; azimuth < kAzimuths; ++azimuth) {
            values.insert(values.end(), &at(azimuth, begin), &at(azimuth, begin) + (end - begin));
        }
        return static_cast<Value>(quantileInPlace(values, 0.5));
    }

  private:
    std::vector<Value> m_values;
};

} // namespace spherewalk::scene
