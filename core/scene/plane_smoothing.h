// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "guided_filter.h"

namespace spherewalk::scene {

/// Each value taken from the plane through those about it that belong to the same surface: 1 / distance is a
/// plane's where the surface is flat, and what differs by more than two percent (more, farther away) lies on
/// another. threads: the result is the same for any number.
Plane smoothedSurfaces(const Plane& inverseM, int threads);

} // namespace spherewalk::scene
