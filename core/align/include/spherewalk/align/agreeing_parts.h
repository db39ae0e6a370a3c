// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <optional>
#include <span>
#include <vector>

namespace spherewalk::align {

/// Cuts the photos into parts within which neighbours show what they see of each other's things. Where two
/// parts are joined although neither shows what should stand around it by the other, what joined them is
/// something that is there twice: a room with the same furniture, or a door like another.
///
/// Two photos disagree if they show, where they belong, less than `leastShare` of the things that the other
/// one shares with third photos, counted as its usual neighbours show them. Where fewer than 20 things are
/// expected, nothing speaks against the pair. Two photos contradict each other if hardly any of 50 things or
/// more is there: they are never in one part, and the pairs that agree least are cut between them.
///
/// Shape: roomFromPhoto has one entry a photo, empty where the photo was not solved; isInlier is what
/// fittingMatches() returns. The result has one entry a photo: the number of its part, 0 for the one with the
/// most photos; -1 for photos without a pose. Frames: the room's. Errors: InvalidInput if the lists' lengths
/// differ or a pair names a photo that does not exist.
std::vector<int> agreeingParts(std::span<const std::optional<Rigid3>> roomFromPhoto,
                               std::span<const PhotoPair> pairs, std::span<const std::vector<bool>> isInlier,
                               double leastShare);

} // namespace spherewalk::align
