// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <optional>
#include <span>
#include <vector>

namespace spherewalk::align {

/// Which matches fit where the photos are: both bearings in one plane with the way between the photos, and
/// what they point at in front of both. One list a pair and one entry a match, of the same order; all false
/// for pairs of which a photo was not solved. Things too far to say where they are count as in front.
/// Range: bearings are unit vectors; photos less than a centimetre apart stand at one place.
std::vector<std::vector<bool>> fittingMatches(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                              std::span<const PhotoPair> pairs);

} // namespace spherewalk::align
