// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rough_rotations.h"

#include "spherewalk/align/pair_estimate.h"
#include "spherewalk/align/photo_pair.h"

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace spherewalk::align {

/// What one pair says of where its photos stand to each other.
struct Baseline {
    int a = 0;
    int b = 0;
    bool hasDirection = false;
    Eigen::Vector3d inPart = Eigen::Vector3d::Zero(); ///< unit, from a to b; zero without direction
    double sigmaRad = 0;
    double parallaxRad = 0;
};

/// The baselines among the photos of one part, of pairs whose rotation agrees with the average.
std::vector<Baseline> baselines(std::span<const PairEstimate> estimates, const RoughRotations& rotations,
                                int part);

/// One photo laid elsewhere.
struct Move {
    int photo = 0;
    int planned = -1; ///< index among the planned positions; -1: none is there
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
};

/// How well positions explain the baselines of one part: a robust log-likelihood in nats. Directions tell
/// most; the parallax, which grows with the distance, tells a little, relative to its median in the part.
class PositionEvidence {
  public:
    /// positionsM: one a photo, of all photos. Moves of photos outside the part gain nothing.
    PositionEvidence(std::vector<Baseline> baselines, std::vector<Eigen::Vector3d> positionsM,
                     std::vector<double> positionSigmasM);

    const std::vector<Baseline>& baselines() const { return m_baselines; }

    const std::vector<Eigen::Vector3d>& positionsM() const { return m_positionsM; }

    /// How the part's frame lies in the room; takes effect at once.
    void turn(const Eigen::Quaterniond& roomFromPart);

    const Eigen::Quaterniond& roomFromPart() const { return m_roomFromPart; }

    void apply(std::span<const Move> moves);

    /// What the log-likelihood gains if the moves are made.
    double gain(std::span<const Move> moves);

    /// The same over the baselines of one photo, which moves alone.
    double score() const;

    /// A photo's baselines with a direction, and how many of them its position contradicts.
    struct Count {
        int directions = 0;
        int contradicted = 0;
    };

    Count count(int photo) const;

    /// A baseline's angle to where the positions say it points, over its sigma; nothing said: 0.
    double misfit(const Baseline& baseline) const;

    /// Indices among baselines().
    const std::vector<int>& of(int photo) const { return m_of[static_cast<std::size_t>(photo)]; }

  private:
    double sigmaRad(const Baseline& baseline, double distanceM) const;
    double logLikelihood(const Baseline& baseline) const;
    void measureParallax();

    std::vector<Baseline> m_baselines;
    std::vector<Eigen::Vector3d> m_positionsM;
    std::vector<double> m_positionSigmasM;
    std::vector<std::vector<int>> m_of;
    std::vector<double> m_logLikelihoods; ///< one a baseline, where the photos now are
    std::vector<bool> m_isCounted;        ///< scratch of gain()
    Eigen::Quaterniond m_roomFromPart = Eigen::Quaterniond::Identity();
    double m_parallaxPerM = 0;
    double m_parallaxSpread = 1; ///< of its logarithm
};

} // namespace spherewalk::align
