// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/pixel_trust.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk::measure {

/// The colour of a spot as a view and as a robot's picture have it. Range: red, green and blue as stored, in
/// [0, 1].
struct ColourSample {
    Eigen::Vector3d view;
    Eigen::Vector3d picture;
};

struct ColourSamples {
    std::vector<ColourSample> samples;
    std::size_t clipped = 0; ///< spots left out because either is as dark or as bright as can be stored

    void add(const ColourSamples& other);
};

/// Spots of 8 x 8 pixels in which view and picture are even and which the view is trusted to show, so that
/// being off by a few pixels changes no colour. Errors: InvalidInput if the sizes differ.
ColourSamples colourSamples(const RgbImage& view, const render::PixelTrust& trust, const RgbImage& picture);

/// How far the pictures' colours are from those of the views: the mean over the spots of the distance of
/// both in red, green and blue, in grey levels of 255. Nothing without spots.
std::optional<double> colourError(std::span<const ColourSample> samples);

/// The same after the correction of the views.
std::optional<double> colourError(std::span<const ColourSample> samples,
                                  const render::ColourCorrection& correction);

} // namespace spherewalk::measure
