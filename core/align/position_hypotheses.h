// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planned_lines.h"
#include "position_evidence.h"

#include <span>
#include <vector>

namespace spherewalk::align {

/// What may have gone wrong when photos were tagged.
enum class Blunder {
    Reversed,  ///< a rail walked from the other end
    Shifted,   ///< photos in a row, each one stop off
    Swapped,   ///< two photos, each tagged with the other's position
    Elsewhere, ///< one photo, taken at another planned position or at none
};

struct Hypothesis {
    Blunder blunder = Blunder::Elsewhere;
    std::vector<Move> moves;
    double gain = 0;      ///< nats, less what the blunder's rarity costs
    int stopsFarther = 0; ///< of Shifted: +1 or -1 along the rail
};

/// Where each photo is thought to have been taken: an index among the planned positions, -1 for none of them.
using Places = std::vector<int>;

/// All blunders that the evidence gains from, the best first; at most 100. Only those are tried in which a
/// photo takes part that several baselines contradict.
std::vector<Hypothesis> hypotheses(PositionEvidence& evidence, const PlannedLines& lines,
                                   const Places& places);

} // namespace spherewalk::align
