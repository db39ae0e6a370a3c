// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/component_solver.h"
#include "solve/match_selection.h"
#include "solve/pair_normal.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>

namespace spherewalk::align {

namespace {

constexpr int kTrialMatches = 40;     // Matches a pair.
constexpr double kBound = 4;          // Of a loss, in standard deviations.
constexpr double kNoiseSigmas = 3;    // Least improvement, in its own standard deviations.
constexpr double kLeastShare = 0.005; // Least improvement, as a share of the loss.

constexpr std::array<Model, 4> kLadder = {Model::Yaw, Model::Tilt, Model::Placement, Model::Position};

// Losses of held-out matches, summed by track, since matches of one track err together.
struct Losses {
    std::map<int, double> byTrack;
    double sum = 0;
    double count = 0;
};

Losses losses(std::span<const UsedPair> pairs, std::span<const PhotoState> states, double scale) {
    Losses made;
    for (const UsedPair& pair : pairs) {
        forEachRow(pair, states, [&](const UsedMatch& match, const MatchRow& row) {
            const double value = bounded(row.residual / scale, kBound).value;
            made.byTrack[match.track] += value * value;
            made.sum += value * value;
            made.count += 1;
        });
    }
    return made;
}

// Whether the second is better than the first by more than chance explains.
bool isBetter(const Losses& first, const Losses& second) {
    double squares = 0;
    const double improvement = first.sum - second.sum;
    for (const auto& [track, loss] : first.byTrack) {
        const auto other = second.byTrack.find(track);
        const double change = loss - (other == second.byTrack.end() ? 0 : other->second);
        squares += change * change;
    }
    return improvement > kNoiseSigmas * std::sqrt(squares) && improvement > kLeastShare * first.sum;
}

double medianSigma(std::span<const UsedPair> pairs) {
    std::vector<double> sigmas;
    for (const UsedPair& pair : pairs) {
        for (const UsedMatch& match : pair.matches) {
            sigmas.push_back(match.sigmaRad);
        }
    }
    return median(std::move(sigmas));
}

std::string degreesText(double radians) {
    return text(fixed(radians * 180 / std::numbers::pi, 3), " degrees");
}

std::string reasonOf(const std::vector<ModelTrial>& trials, std::size_t chosen) {
    std::string figures;
    for (const ModelTrial& trial : trials) {
        figures += text(figures.empty() ? "" : ", ", name(trial.model), " ", degreesText(trial.heldOutRad));
    }
    const std::string_view why = chosen + 1 == trials.size() ? "is the richest, and every step to it helped"
                                                             : "is the richest whose gain exceeds its noise";
    return text("The model '", name(trials[chosen].model), "' ", why, ": matches that were held out miss by ",
                figures, ".");
}

} // namespace

ModelChoice chooseModel(const ComponentInput& input, ComponentState& state, ProgressSink& progress,
                        const std::stop_token& stop) {
    ComponentInput shown = input;
    shown.selection.mostAPair = kTrialMatches;
    shown.selection.heldOutShare = input.options->heldOutShare;
    Selection hidden = shown.selection;
    hidden.wantsHeldOut = true;
    const std::vector<UsedPair> heldOut =
        estimatedMatches(input.candidates, state.unknowns, input.priors, hidden);
    const double sigma = medianSigma(heldOut);
    ModelChoice choice;
    std::vector<Losses> all;
    std::vector<ComponentState> states;
    for (std::size_t rung = 0; rung < kLadder.size(); ++rung) {
        const auto begin = std::chrono::steady_clock::now();
        ProgressStep step(progress, 0.25 * static_cast<double>(rung), 0.25 * (static_cast<double>(rung) + 1));
        ComponentState trial = states.empty() ? state : states.back();
        solveModel(shown, kLadder[rung], rung > 1, trial, step, stop);
        states.push_back(std::move(trial));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        choice.trials.push_back({kLadder[rung], 0, took.count(), false});
    }
    // The richest model's residuals give one measure for all.
    const double scale = residualScale(heldOut, states.back().unknowns.states());
    std::size_t chosen = 0;
    for (std::size_t rung = 0; rung < kLadder.size(); ++rung) {
        all.push_back(losses(heldOut, states[rung].unknowns.states(), scale));
        ModelTrial& trial = choice.trials[rung];
        trial.heldOutRad = std::sqrt(all[rung].sum / std::max(all[rung].count, 1.0)) * scale * sigma;
        trial.isSupported = rung == 0 || isBetter(all[chosen], all[rung]);
        chosen = trial.isSupported ? rung : chosen;
    }
    choice.model = kLadder[chosen];
    choice.reason = reasonOf(choice.trials, chosen);
    state = std::move(states[chosen]);
    return choice;
}

} // namespace spherewalk::align
