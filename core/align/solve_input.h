// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/solve.h"

namespace spherewalk::align {

/// Refuses what cannot be solved. Errors: InvalidInput, naming the photo or the pair.
void checkInput(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                std::span<const PairEstimate> estimates);

} // namespace spherewalk::align
