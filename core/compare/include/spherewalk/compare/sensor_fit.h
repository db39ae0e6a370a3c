// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/compare/colour_fit.h"
#include "spherewalk/render/sensor.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::compare {

/// Light and noise of a spot of a robot's picture. Units: linear light of red, green and blue, of white; its
/// variance.
struct NoiseSample {
    Eigen::Vector3d light;
    Eigen::Vector3d variance;
};

/// The noise of spots of 8 x 8 pixels, but of those that are nearly black or white. Even light and slopes add
/// nothing to it; fine structures do. Stored values are taken for sRGB, and their rounding is taken off.
/// Source: Immerkaer, Fast noise variance estimation, 1996.
std::vector<NoiseSample> noiseSamples(const RgbImage& picture);

struct SensorFit {
    /// Gain, gains of colour and noise, as far as the pictures tell them; all else is off.
    render::SensorModel sensor;
    bool hasExposure = false;     ///< Whether gain and gains of colour are known.
    bool hasNoise = false;        ///< Whether noise is known.
    std::vector<std::string> why; ///< A sentence for each of them that is not known.
    std::size_t colourSpots = 0;  ///< Spots that exposure was fitted to.
    std::size_t noiseSpots = 0;   ///< Spots that noise was fitted to.
};

/// The sensor with which views are as bright, as warm and as noisy as the pictures. Exposure: the median
/// ratio of light in each channel. Noise: the line of variance over light (photon transfer curve), through
/// the quietest quarter of the spots at each light. What a JPEG or a filter has taken from the noise is not
/// in it. colours: in the views' colours as they are given out. Cost: milliseconds.
SensorFit fittedSensor(std::span<const ColourSample> colours, std::span<const NoiseSample> noise);

} // namespace spherewalk::compare
