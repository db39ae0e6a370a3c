// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "check/position_evidence.h"

#include "spherewalk/align/position_check.h"

#include <span>
#include <vector>

namespace spherewalk::align {

/// The planned positions in the order in which a cart reaches them: one line for each rail and height.
class PlannedLines {
  public:
    explicit PlannedLines(std::span<const PlannedPosition> planned);

    /// One list a line: indices among the planned positions, sorted by stop.
    const std::vector<std::vector<int>>& lines() const { return m_lines; }

    struct Place {
        int line = -1; ///< -1 if it lies on none.
        int index = 0; ///< Place along the line.
    };

    Place place(int planned) const;

    /// The planned position that a photo is tagged with, found by its position. Of several at one place it is
    /// the one with the photo's rail and stop. -1 if none lies within 2 cm.
    int tag(const PhotoPrior& photo) const;

    const PlannedPosition& operator[](int planned) const {
        return m_planned[static_cast<std::size_t>(planned)];
    }

    int size() const { return static_cast<int>(m_planned.size()); }

    /// The line's position with this index. One beyond either end is extrapolated, which takes at least two
    /// positions. Range of index: [-1, size of the line].
    Eigen::Vector3d positionM(int line, int index) const;

  private:
    std::vector<PlannedPosition> m_planned;
    std::vector<std::vector<int>> m_lines;
    std::vector<Place> m_places;
};

/// What may have gone wrong when photos were tagged.
enum class Blunder {
    Reversed,  ///< A rail was walked from the other end.
    Shifted,   ///< Photos in a row are each one stop off.
    Swapped,   ///< Two photos are tagged with each other's position.
    Elsewhere, ///< One photo was taken at another planned position or at none.
};

/// A blunder with the moves that would undo it.
struct Hypothesis {
    Blunder blunder = Blunder::Elsewhere;
    std::vector<Move> moves;
    double gain = 0;      ///< In nats, less what the blunder's rarity costs.
    int stopsFarther = 0; ///< For Shifted: +1 or -1 along the rail.
};

/// Where each photo is thought to have been taken: an index among the planned positions, or -1.
using Places = std::vector<int>;

/// The blunders that the evidence gains from, the best first; at most 100. Tried are only blunders of photos
/// that several baselines contradict. The evidence comes back as it was.
std::vector<Hypothesis> hypotheses(PositionEvidence& evidence, const PlannedLines& lines,
                                   const Places& places);

} // namespace spherewalk::align
