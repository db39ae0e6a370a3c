// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planned_lines.h"
#include "position_hypotheses.h"

#include <span>
#include <string>

namespace spherewalk::align {

/// How a photo's position was found to be wrong.
struct Finding {
    Blunder blunder = Blunder::Elsewhere;
    int stopsFarther = 0;
    int together = 0; ///< photos that were moved with it, and itself
    int timesMoved = 0;
    double confidence = 0;
};

/// What people read of it. takenM: where the photo was taken, as is thought now.
std::string sentence(int photo, std::span<const PhotoPrior> photos, const Places& places,
                     const Finding& finding, const Eigen::Vector3d& takenM, const PlannedLines& lines);

} // namespace spherewalk::align
