// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/pair_estimate.h"
#include "spherewalk/align/photo_pair.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"

#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::align {

/// What is solved, each rung with all that the ones before it solve.
enum class Model {
    Auto,      ///< the richest that held-out matches support
    Yaw,       ///< one heading a photo; tilts as the photos say, positions as planned
    Tilt,      ///< and pitch and roll
    Placement, ///< and where each rail really lay: x, y, heading; its stops stay rigid on it
    Position,  ///< and an offset of each photo from its stop, held by its prior
};

/// As options and reports spell it: "auto", "yaw", "tilt", "placement", "position".
std::string_view name(Model model);

/// Errors: InvalidInput, listing the names.
Model modelNamed(std::string_view name);

struct SolveOptions {
    Model model = Model::Auto;
    double placementSigmaM = 0.01;       ///< prior of a rail's x and y
    Radians placementSigma = Degrees(1); ///< prior of a rail's heading
    double heldOutShare = 0.15;          ///< of the matches, when models are compared
    int threads = 0;                     ///< 0: all that the machine has

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// What the alignment says of one photo.
struct SolvedPose {
    bool isSolved = false;
    std::string why;   ///< a sentence if not solved: "No neighbour shares enough with it."
    int component = 0; ///< photos that constraints connect; 0 is the largest
    Rigid3 roomFromPhoto;
    Radians sigmaYaw; ///< of the photo against all others: the common offset is in Alignment
    Radians sigmaPitch;
    Radians sigmaRoll;
    double sigmaPositionM = 0;
    int constraints = 0;     ///< pairs that hold it
    double residualRad = 0;  ///< root mean square over the matches that hold it
    double outlierShare = 0; ///< of its pairs' inliers, those that the solution contradicts
};

/// What one model of the ladder reached on matches that it was not shown.
struct ModelTrial {
    Model model = Model::Yaw;
    double heldOutRad = 0; ///< robust root mean square
    double seconds = 0;
    bool isSupported = false; ///< better than the simpler ones by more than its noise
};

struct Alignment {
    Model model = Model::Yaw;
    std::string reason; ///< why this model, in a sentence
    std::vector<SolvedPose> photos;
    std::vector<ModelTrial> trials; ///< empty unless the model was chosen
    int components = 0;
    Radians sigmaCommonYaw;            ///< of the yaw common to all photos, which only positions fix
    double residualRad = 0;            ///< robust root mean square over all matches used
    double cycleErrorRad = 0;          ///< median turn that is left around triangles of pair estimates
    std::vector<std::string> warnings; ///< sentences
};

/// Solves all photos at once. estimates: one a pair, of the same order. Photos that nothing holds are named
/// and left unsolved; each connected part is solved for itself. The gauge: positions' priors fix the common
/// yaw. Stop: Error{Stopped}. The same input gives the same result on one machine.
Alignment solve(std::span<const PhotoPrior> photos, std::span<const PhotoPair> pairs,
                std::span<const PairEstimate> estimates, const SolveOptions& options, ProgressSink& progress,
                const std::stop_token& stop);

} // namespace spherewalk::align
