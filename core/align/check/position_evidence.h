// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "graph/pose_graph.h"

#include "spherewalk/align/photo_pair.h"

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace spherewalk::align {

/// How a pair says that its photos stand to each other.
struct Baseline {
    int a = 0;
    int b = 0;
    bool hasDirection = false;
    Eigen::Vector3d inComponent = Eigen::Vector3d::Zero(); ///< Unit vector from a to b; zero if unknown.
    double sigmaRad = 0;
    double parallaxRad = 0;
};

/// The baselines of a component's pairs whose rotation agrees with the average. estimates: all of them.
std::vector<Baseline> baselines(std::span<const PairEstimate> estimates, const Component& component);

/// A photo that is thought to have been taken elsewhere.
struct Move {
    int photo = 0;
    int planned = -1; ///< Index of the planned position; -1 if none is there.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
};

/// How well positions explain the baselines of one component: a robust log-likelihood in nats. Directions
/// tell most. The parallax grows with the distance and tells a little, relative to its median in the
/// component.
class PositionEvidence {
  public:
    /// positionsM, positionSigmasM: one entry a photo, of all photos. Moves of photos outside the component
    /// gain nothing.
    PositionEvidence(std::vector<Baseline> baselines, std::vector<Eigen::Vector3d> positionsM,
                     std::vector<double> positionSigmasM);

    const std::vector<Baseline>& baselines() const { return m_baselines; }

    const std::vector<Eigen::Vector3d>& positionsM() const { return m_positionsM; }

    /// Sets how the component's frame lies in the room.
    void turn(const Eigen::Quaterniond& roomFromComponent);

    const Eigen::Quaterniond& roomFromComponent() const { return m_roomFromComponent; }

    /// Makes the moves.
    void apply(std::span<const Move> moves);

    /// What the log-likelihood would gain by the moves. The positions stay as they are.
    double gain(std::span<const Move> moves);

    /// The log-likelihood of all baselines.
    double score() const;

    /// A photo's baselines with a direction, and how many of them its position contradicts.
    struct Count {
        int directions = 0;
        int contradicted = 0;
    };

    Count count(int photo) const;

    /// The angle between a baseline and the line between its positions, in standard deviations; 0 if either
    /// is unknown.
    double misfit(const Baseline& baseline) const;

    /// The baselines of a photo, as indices among baselines().
    const std::vector<int>& of(int photo) const { return m_of[static_cast<std::size_t>(photo)]; }

  private:
    double sigmaRad(const Baseline& baseline, double distanceM) const;
    double logLikelihood(const Baseline& baseline) const;
    void measureParallax();

    std::vector<Baseline> m_baselines;
    std::vector<Eigen::Vector3d> m_positionsM;
    std::vector<double> m_positionSigmasM;
    std::vector<std::vector<int>> m_of;
    std::vector<double> m_logLikelihoods; ///< One entry a baseline, for the positions of now.
    std::vector<bool> m_isCounted;        ///< Memory of gain().
    Eigen::Quaterniond m_roomFromComponent = Eigen::Quaterniond::Identity();
    double m_parallaxPerM = 0;
    double m_parallaxSpread = 1; ///< Standard deviation of the logarithm.
};

} // namespace spherewalk::align
