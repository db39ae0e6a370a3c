// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solve/match_selection.h"
#include "solve/refinement.h"
#include "solve/unknowns.h"

#include "spherewalk/align/solve.h"
#include "spherewalk/base/progress.h"

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A component while it is solved: its photos and their poses so far.
struct ComponentState {
    Unknowns unknowns;
    std::vector<UsedPair> used; ///< The matches of the last solution.
    double scale = 1;           ///< Of the residuals: 1 if the matches' sigmas are right.
    double cost = 0;
};

/// The data of a component that stay while it is solved.
struct ComponentInput {
    std::span<const PhotoPrior> priors;
    Candidates candidates;
    const SolveOptions* options = nullptr;
    Selection selection;
};

/// Solves one model from the photos' present poses: first on the pairs' own inliers, with ever narrower
/// norms, then twice on all matches that agree with the solution. isWarm: the start is good; the first step
/// is left out. Errors: those of refine().
void solveModel(const ComponentInput& input, Model model, bool isWarm, ComponentState& state,
                ProgressSink& progress, const std::stop_token& stop);

RefinementOptions refinementOptions(const SolveOptions& options, Model model, double scale);

/// The model that held-out matches chose.
struct ModelChoice {
    Model model = Model::Yaw;
    std::string reason;
    std::vector<ModelTrial> trials;
};

/// Solves all models on a share of the matches and chooses by the others. The state is then the chosen
/// model's solution.
ModelChoice chooseModel(const ComponentInput& input, ComponentState& state, ProgressSink& progress,
                        const std::stop_token& stop);

/// Turns single photos to where their neighbours' pair estimates put them, wherever that lowers the cost.
/// Returns the number of photos turned.
int turnStrays(const ComponentInput& input, Model model, ComponentState& state);

} // namespace spherewalk::align
