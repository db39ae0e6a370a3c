// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "guided_filter.h"

namespace spherewalk::scene {

/// The middle value of each 3 x 3 pixels of an equirectangular plane.
Plane median3x3(const Plane& plane, int threads);

} // namespace spherewalk::scene
