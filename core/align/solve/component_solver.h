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

/// Solves again with wider priors where the solved places contradict what the priors promise: a camera in the
/// hand does not keep its height like a cart, and heights that are believed too much make the whole lean.
/// priors: those of the input. Returns whether anything changed.
bool widenPriors(std::vector<PhotoPrior>& priors, const ComponentInput& input, Model model,
                 ComponentState& state, ProgressSink& progress, const std::stop_token& stop);

/// Solves again with narrower priors where rails and photos lie nearer to their places than the priors
/// promise, all in all: then a room behind a door is held by its tags rather than by the little that is seen
/// through the door. What the matches do not know counts for nothing. A model that solves no places is not
/// solved again; its errors are then those of the narrower priors. priors, options: those of the input.
/// Returns whether anything changed.
/// Source: MacKay, Bayesian Interpolation, 1992 (the effective number of parameters).
bool narrowPriors(std::vector<PhotoPrior>& priors, SolveOptions& options, const ComponentInput& input,
                  Model model, ComponentState& state, ProgressSink& progress, const std::stop_token& stop);

/// Takes out the matches that the solution follows although no other match says the same, and solves again
/// without them. A few photos that see little of each other, as through a door, are turned by one wrong match
/// otherwise, and it fits then. Where places are solved along, all stay. Writes the leverage of those that
/// stay. Returns whether any was taken out.
bool dropSelfWilled(const ComponentInput& input, Model model, ComponentState& state, ProgressSink& progress,
                    const std::stop_token& stop);

/// Turns single photos to where their neighbours' pair estimates put them, wherever that lowers the cost.
/// Returns the number of photos turned.
int turnStrays(const ComponentInput& input, Model model, ComponentState& state);

/// Where the rays of a pair's inliers meet, at the photos' present poses: numbers of matches.
struct PairSides {
    int pair = 0; ///< Index among the given pairs.
    int a = 0;    ///< Place of the photo within the component.
    int b = 0;
    bool isTurn = false;
    int same = 0;     ///< On one side of the baseline in both photos. Photos of one place: within 90 degrees.
    int opposite = 0; ///< On opposite sides, as where one photo is half a turn off about the baseline.
    int front = 0;    ///< Of `same`, with real parallax: they meet in front of both photos.
    int behind = 0;   ///< Of `same`, with real parallax: they meet behind.
};

std::vector<PairSides> pairSides(const ComponentInput& input, const ComponentState& state);

/// Which way the photos of a component lie from one another, by what lies in front of them.
enum class TravelSign {
    Right,
    Reversed, ///< Half a turn of the whole about the vertical explains the matches.
    Unclear,  ///< Too little moved between the photos, or what moved does not agree.
};

TravelSign travelSign(std::span<const PairSides> pairs);

/// Turns parts of a component that are half a turn off about the baselines to the rest. The estimates of the
/// pairs between the parts say where to. Returns the number of photos turned.
int turnHalves(const ComponentInput& input, ComponentState& state);

/// For each photo of the component, whether its turn against the others is not what the pictures alone say:
/// no chain of pairs whose solved turn is that of their estimate joins it to most others. Wrong positions
/// bend a solution so.
std::vector<bool> bentPhotos(const ComponentInput& input, const ComponentState& state);

/// For each photo of the component, whether too many rays lie on opposite sides of its baselines.
std::vector<bool> unclearSides(const ComponentState& state, std::span<const PairSides> pairs);

} // namespace spherewalk::align
