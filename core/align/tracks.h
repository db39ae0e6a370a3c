// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"

#include <span>
#include <vector>

namespace spherewalk::align {

/// Which matches show one thing: features joined by matches, over all photos, are one track.
/// Shape: as the pairs and their matches. isUsed: of the same shape; the others join nothing and get a track
/// of their own, as those whose features have no index.
std::vector<std::vector<int>> tracks(std::span<const PhotoPair> pairs,
                                     std::span<const std::vector<bool>> isUsed);

/// Whether this share of the tracks holds this one. The same for any other tracks.
bool isHeldOut(int track, double share);

} // namespace spherewalk::align
