// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"

#include <cstddef>
#include <optional>

namespace spherewalk::compare {

/// How alike two pictures look to people: the mean structural similarity of their brightness. The window is
/// Gaussian, 11 x 11 pixels with a sigma of 1.5, and pictures are mirrored at their borders. valid: 0 where a
/// picture shows nothing; only windows without such a pixel count. An empty mask counts all. Nothing if no
/// window counts. Range: [-1, 1], and 1 for equal pictures. Errors: InvalidInput if sizes differ or are 0.
/// Source: Wang, Bovik, Sheikh, Simoncelli 2004.
std::optional<double> structuralSimilarity(const RgbImage& a, const RgbImage& b, const MaskImage& valid = {});

/// Edges that one picture has and the other lacks. A picture without edges has a share of 0.
struct EdgeAgreement {
    double falseShare = 0;      ///< Of the view's edge pixels, those without one of the truth within 2 px.
    double missedShare = 0;     ///< Of the truth's edge pixels, those without one of the view within 2 px.
    std::size_t viewEdges = 0;  ///< Edge pixels of the view that were counted.
    std::size_t truthEdges = 0; ///< Edge pixels of the truth that were counted.
};

/// The edges of brightness after a Gaussian blur of 1 pixel, with thresholds of 40 and 120. valid: as above;
/// edge pixels within 4 pixels of an invalid one are not counted, because the blur mixes both. Errors:
/// InvalidInput if sizes differ or are 0. Source: Canny 1986.
EdgeAgreement edgeAgreement(const RgbImage& truth, const RgbImage& view, const MaskImage& valid = {});

} // namespace spherewalk::compare
