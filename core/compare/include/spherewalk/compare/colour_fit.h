// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/view.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::compare {

/// The colour of a spot in a view and in a robot's picture. Range: red, green and blue as stored, in [0, 1].
struct ColourSample {
    Eigen::Vector3d view;
    Eigen::Vector3d picture;
};

struct ColourSamples {
    std::vector<ColourSample> samples;
    std::size_t clipped = 0; ///< Number of spots left out because one of them is nearly black or white.

    void add(const ColourSamples& other);
};

/// Samples of spots of 8 x 8 pixels. View and picture must be even there and the view must be trusted, so
/// that an error of a few pixels changes no colour. Errors: InvalidInput if the sizes differ.
ColourSamples colourSamples(const RgbImage& view, const render::PixelTrust& trust, const RgbImage& picture);

/// The mean distance of the pictures' colours from the views' colours in red, green and blue. Nothing without
/// samples. Units: grey levels of 255.
std::optional<double> colourError(std::span<const ColourSample> samples);

/// The same after the correction of the views.
std::optional<double> colourError(std::span<const ColourSample> samples,
                                  const render::ColourCorrection& correction);

struct ColourFit {
    std::optional<render::ColourCorrection> correction; ///< Nothing if the colours do not determine it.
    std::string why;         ///< Without a correction, a sentence that says why and what to do.
    std::size_t samples = 0; ///< Number of samples that were used.
    double errorBefore = 0;  ///< colourError() of these samples.
    double errorAfter = 0;
    double hueSpread = 0; ///< Spread of the samples' hues: 0 for grey, about 0.5 for a colour chart.
};

/// The correction that takes the views' colours to the pictures'. It is the least squares solution with a
/// robust loss, and stays near the identity where the samples do not determine it. These samples give no
/// correction: too few, mostly clipped, only grey, only of one colour, or such that a correction does not
/// help. The same samples give the same result. Cost: 0.5 s for 20000 samples; more are thinned out evenly.
ColourFit fittedColour(const ColourSamples& samples);

} // namespace spherewalk::compare
