// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/rigid3.h"

#include <cmath>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::align {

/// What is solved for. Each model solves also all that the models before it solve.
enum class Model {
    Auto,      ///< The richest model that the largest component's held-out matches support.
    Yaw,       ///< One heading a photo; tilts as the photos say, positions as planned.
    Tilt,      ///< Also pitch and roll of each photo.
    Placement, ///< Also x, y and heading of each rail; its stops stay rigid on it.
    Position,  ///< Also an offset of each photo from its stop, held by its prior.
};

/// The model as options and reports spell it: "auto", "yaw", "tilt", "placement", "position".
std::string_view name(Model model);

/// Errors: InvalidInput, listing the names.
Model modelNamed(std::string_view name);

struct SolveOptions {
    Model model = Model::Auto;
    double placementSigmaM = 0.01;       ///< Prior standard deviation of a rail's x and y, [0, 10].
    Radians placementSigma = Degrees(1); ///< Prior standard deviation of a rail's heading, [0, 180] degrees.
    double heldOutShare = 0.15;          ///< Share of the matches that compares models, (0, 0.5].
    int threads = 0;                     ///< 0 means all that the machine has.
    /// Whether the positions are tags, which may confirm photos and be better than they promise. Positions
    /// that come from the same pictures would confirm themselves.
    bool areTagged = true;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// The pose of one photo and how far it is to be believed: standard deviations.
struct SolvedPose {
    bool isSolved = false;
    std::string why; ///< A sentence if not solved: "No neighbour shares enough with it."
    /// A sentence if solved, but a quite different rotation may be the right one. Such a photo has no
    /// standard deviations: those of its turn are pi.
    std::string doubt;
    /// Angle between what the solution calls up and what the photo says is up (its metadata, or upright where
    /// they say nothing).
    Radians leanFromStated;
    int component = 0;    ///< Index of the connected component; 0 for the largest, and for photos in none.
    Rigid3 roomFromPhoto; ///< Without a solution: the planned position, not turned.
    Radians sigmaYaw;     ///< Against all other photos; Alignment::sigmaCommonYaw holds the common part.
    Radians sigmaPitch;
    Radians sigmaRoll;
    /// The standard deviation of its turn against the other photos of its component, about the worst axis.
    /// Yaw and lean that all of them share are no part of it.
    Radians sigmaOwn;
    /// Standard deviation along either axis of the floor, or in height if that is more.
    double sigmaPositionM = 0;
    /// The same of its place among the other photos of its component. What all of them are moved, turned and
    /// scaled by together is no part of it.
    double sigmaOwnPositionM = 0;
    /// How the lenses of its camera stand, as far as the matches tell.
    LensPair lenses;
    double lensSigmaM =
        HUGE_VAL;            ///< Standard deviation of how far they stand ahead; infinite if nothing tells.
    int constraints = 0;     ///< Number of pairs that hold the photo.
    double residualRad = 0;  ///< Root mean square over the matches that hold the photo.
    double outlierShare = 0; ///< Share of its pairs' inliers that the solution contradicts; 1 if none counts.

    bool hasSigmas() const { return isSolved && doubt.empty(); }
};

/// A photo that leans farther than this from what it states contradicts itself. SolvedPose::doubt says so.
inline constexpr Radians kContradictingLean = Degrees(20);

/// How well one model predicts matches that were held out.
struct ModelTrial {
    Model model = Model::Yaw;
    double heldOutRad = 0; ///< Robust root mean square.
    double seconds = 0;
    bool isSupported = false; ///< Better than the last supported model by more than noise; true for Yaw.
};

struct Alignment {
    Model model = Model::Yaw;
    std::string reason; ///< A sentence that says why this model was taken.
    std::vector<SolvedPose> photos;
    std::vector<ModelTrial> trials; ///< Empty unless the model was Auto.
    int components = 0;
    Radians sigmaCommonYaw;            ///< Of the largest component's common yaw; pi if nothing fixes it.
    Radians sigmaCommonLean;           ///< Of the largest component's common lean, about the worst axis.
    double residualRad = 0;            ///< Robust root mean square over the largest component's matches.
    double cycleErrorRad = 0;          ///< Median turn around triangles of pair estimates; 0 without any.
    std::vector<std::string> warnings; ///< Sentences for people.
};

/// The poses of all photos in the room frame. estimates: one a pair, in the order of the pairs. Each
/// connected component is solved for itself; the positions' priors fix its common yaw. Photos that nothing
/// holds stay unsolved, with a sentence that says why. The same input gives the same result on one machine.
/// Warnings go to the result and to the progress sink. Errors: InvalidInput, naming the option, the photo or
/// the pair; Internal if the equations cannot be solved; Stopped. Stop: heard at each solver iteration.
/// Source: `resources/docs/alignment.md`.
Alignment solve(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                std::span<const PairEstimate> estimates, const SolveOptions& options, ProgressSink& progress,
                const std::stop_token& stop);

} // namespace spherewalk::align
