// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "content_witness.h"

#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

namespace spherewalk::align {

/// A disc of directions in a photo's frame.
struct PhotoPart {
    Eigen::Vector3d middle = Eigen::Vector3d::UnitX();
    Radians radius;
};

/// Whether the witness expects its thing in the part, or in one so many times as large.
bool isWithin(const Witness& witness, const PhotoPart& part, double times = 1);

/// Whether the photos that see what the photo misses there all stand to one side of it: then something may
/// hide it from the photo. Seen from both sides, hardly anything is hidden in the middle.
bool isSeenFromOneSide(const PhotoWitnesses& witnesses, const PhotoPart& part, int photo,
                       const Sightings& sightings);

/// Whether the photo shows, there or beside it, things on which it agrees with its neighbours and which are
/// nearer than what it misses: they may hide it.
bool hasNearerThings(const PhotoWitnesses& witnesses, const PhotoPart& part);

} // namespace spherewalk::align
