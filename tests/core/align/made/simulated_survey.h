// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"

#include "spherewalk/align/position_check.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Geometry>

#include <vector>

namespace spherewalk::align {

struct SimulationOptions {
    int rails = 5;
    int stops = 5; ///< of each rail
    double stepM = 0.2;
    Eigen::Vector3d originM = {1, 1, 1.2};
    double positionSigmaM = 0.003;
    double wrongShare = 0.15; ///< of the pairs: half of them in all, half in the baseline alone
    int nearest = 8;          ///< partners that each photo is paired with
    int further = 2;          ///< and some at random
};

/// A survey whose pair estimates are simulated directly: each is the truth and noise, or wrong. The pairs are
/// chosen by the tags, as the matching would.
class SimulatedSurvey {
  public:
    SimulatedSurvey(const SimulationOptions& options, spherewalk::test::Random& random);

    int planned(int rail, int stop) const { return rail * m_options.stops + stop; }

    /// Says that a photo was taken elsewhere than at its tag; -1: one stop beyond its rail's end.
    void takeAt(int photo, int planned) { takenAt[static_cast<std::size_t>(photo)] = planned; }

    /// Makes the photos' true poses and the pairs' estimates from where they were taken.
    void expose(spherewalk::test::Random& random);

    std::vector<PhotoPrior> photos; ///< one a planned position, tagged with it
    std::vector<PlannedPosition> plannedPositions;
    std::vector<int> takenAt; ///< one a photo, the truth
    std::vector<Rigid3> roomFromPhoto;
    std::vector<PairEstimate> estimates;

  private:
    Eigen::Vector3d truePositionM(int photo) const;
    void choosePairs(spherewalk::test::Random& random);
    PairEstimate estimate(int a, int b, spherewalk::test::Random& random) const;

    SimulationOptions m_options;
    std::vector<Eigen::Vector3d> m_pointsM; ///< what the room shows
};

} // namespace spherewalk::align
