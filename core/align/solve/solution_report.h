// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solve/component_solver.h"
#include "solve/refinement.h"

#include "spherewalk/align/solve.h"

#include <Eigen/Core>

#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::align {

/// How well a solution fits the inliers that the pairs had.
struct SolutionQuality {
    struct Photo {
        int judged = 0;       ///< Inliers that say something.
        int contradicted = 0; ///< Inliers that lie out of plane or behind.
        int pairs = 0;        ///< Number of pairs that hold the photo.
        double residualRad = 0;
    };

    std::vector<Photo> photos;
    double agreeingShare = 0; ///< Of all judged inliers.
    double residualRad = 0;   ///< Robust root mean square.
};

SolutionQuality quality(const ComponentInput& input, const ComponentState& state);

/// Writes a component's poses and their uncertainty into the alignment. Returns the standard deviation of the
/// lean that all of its photos share, in radians.
double report(const ComponentInput& input, Model model, const ComponentState& state,
              const SolutionQuality& quality, bool hasHeading, int component, Alignment& alignment,
              const std::stop_token& stop);

/// What a person should know of a component's lean, as sentences: that photos on one line leave it open, and
/// how many photos lean from what they state. which: names the photos. commonLeanRad: what report() returned.
std::vector<std::string> leanWarnings(const Alignment& alignment, const ComponentInput& input,
                                      const ComponentState& state, double commonLeanRad,
                                      const std::string& which);

/// Takes the standard deviations from those photos of a component that a quite different rotation may fit,
/// and says why in SolvedPose::doubt.
void doubtPhotos(const ComponentInput& input, const ComponentState& state, std::span<const PairSides> sides,
                 TravelSign travel, Alignment& alignment);

/// The standard deviations of one photo's pose.
struct PhotoUncertainty {
    double yawRad = 0; ///< Against all others, without the common turn.
    double pitchRad = 0;
    double rollRad = 0;
    double positionM = 0; ///< Along either axis of the floor, or in height if that is more.
    double ownRad = 0;    ///< About the worst axis, without the turn common to all.
    double ownM = 0;      ///< The same, when all are moved, turned and scaled together.
};

struct Uncertainty {
    std::vector<PhotoUncertainty> photos;
    double commonYawRad = 0;
    double commonLeanRad = 0; ///< About the worst horizontal axis.
};

/// A standard deviation of so many draws is right to 5 %.
inline constexpr int kBootstrapDraws = 192;

/// Errors that a solution may have, about the room's axes, by chance. Shape: 3 rows a photo, one column a
/// draw. Units: radians and metres.
struct ErrorDraws {
    Eigen::MatrixXd turn;
    Eigen::MatrixXd position;
};

/// How a converged solution may err. A feature takes part in many pairs with the same error, so the usual
/// inverse of the normal matrix promises too much. Instead the residuals go through the normal equations many
/// times, with random signs that are equal within a track (a wild cluster bootstrap). Random errors of the
/// priors go with them. Tilts and positions that the model does not solve err as their priors say and pass
/// their errors on. Errors: Internal if the matrix cannot be factored; Stopped.
/// Source: Cameron, Gelbach, Miller, Bootstrap-Based Improvements for Inference with Clustered Errors, 2008.
ErrorDraws errorDraws(const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                      std::span<const UsedPair> pairs, const RefinementOptions& options,
                      const std::stop_token& stop);

/// The standard deviations of what a solution may err by.
Uncertainty uncertainty(const Unknowns& unknowns, const ErrorDraws& draws);

} // namespace spherewalk::align
