// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/compare/picture_matches.h"

#include <cstddef>
#include <optional>

namespace spherewalk::compare {

/// A true picture and the view from its pose.
struct Frame {
    PictureFeatures truth;
    PictureFeatures view;
};

/// How much a walk's picture trembles between two frames. Units: pixels.
struct Steadiness {
    std::optional<double> medianPx; ///< Nothing if fewer than 12 things are known in all four pictures.
    std::optional<double> p95Px;
    std::size_t things = 0; ///< Number of things that were followed.
};

/// The part of the change between two frames that the camera's motion does not explain. A thing is displaced
/// in each view against the truth. The motion explains how the true place moves; what is left is how the
/// displacement changes, as the length of the difference of both displacements. A view that is wrong in the
/// same way in both frames is steady. Things are followed by witnessedMatches(), through both true pictures.
/// Errors: InvalidInput if the sizes differ.
Steadiness steadiness(const Frame& before, const Frame& after);

} // namespace spherewalk::compare
