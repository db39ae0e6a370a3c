// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "match_selection.h"
#include "refinement.h"
#include "unknowns.h"

#include "spherewalk/align/solve.h"
#include "spherewalk/base/progress.h"

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A component being solved: its photos, what is known of them, and where they are so far.
struct ComponentState {
    Unknowns unknowns;
    std::vector<UsedPair> used; ///< what the last solution was made with
    double scale = 1;           ///< of the residuals: 1 if the matches' sigmas are right
    double cost = 0;
};

/// What does not change while a component is solved.
struct ComponentInput {
    std::span<const PhotoPrior> priors;
    Candidates candidates;
    const SolveOptions* options = nullptr;
    Selection selection;
};

/// Solves one model from where the photos are: first on the pairs' own inliers, at an ever narrower norm,
/// then on all matches that agree with the solution, twice. Starts of good quality skip the first part.
void solveModel(const ComponentInput& input, Model model, bool isWarm, ComponentState& state,
                ProgressSink& progress, const std::stop_token& stop);

RefinementOptions refinementOptions(const SolveOptions& options, Model model, double scale);

/// The model chosen by matches that no solution was shown.
struct ModelChoice {
    Model model = Model::Yaw;
    std::string reason;
    std::vector<ModelTrial> trials;
};

/// Climbs the ladder of models on a share of the matches; state is left where the chosen one ended.
ModelChoice chooseModel(const ComponentInput& input, ComponentState& state, ProgressSink& progress,
                        const std::stop_token& stop);

/// Turns single photos to where their neighbours' pair estimates put them, wherever that lowers the cost.
/// Returns how many.
int turnStrays(const ComponentInput& input, Model model, ComponentState& state);

} // namespace spherewalk::align
