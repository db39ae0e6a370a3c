// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/component_solver.h"

#include "solve/pair_normal.h"
#include "solve/refinement.h"

#include "spherewalk/geometry/rotation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::align {

namespace {

constexpr int kFirstMatches = 60; // Matches a pair that are enough to come near.
constexpr double kStrayRad = 0.01;

void refineState(const ComponentInput& input, RefinementOptions options, ComponentState& state,
                 ProgressSink& progress, const std::stop_token& stop) {
    state.cost = refine(state.unknowns, input.priors, state.used, options, progress, stop);
}

void comeNear(const ComponentInput& input, Model model, ComponentState& state, ProgressSink& progress,
              const std::stop_token& stop) {
    Selection few = input.selection;
    few.mostAPair = std::min(kFirstMatches, few.mostAPair);
    state.used = estimatedMatches(input.candidates, state.unknowns, input.priors, few);
    for (const double width : {30.0, 10.0}) {
        RefinementOptions options = refinementOptions(*input.options, model, 1);
        options.width = width;
        options.iterations = 12;
        options.tolerance = 1e-4;
        refineState(input, options, state, progress, stop);
    }
}

// The pairs of each photo of the component.
std::vector<std::vector<const UsedPair*>> pairsOfPhotos(const ComponentState& state) {
    std::vector<std::vector<const UsedPair*>> pairs(state.unknowns.photo.size());
    for (const UsedPair& pair : state.used) {
        pairs[static_cast<std::size_t>(pair.a)].push_back(&pair);
        pairs[static_cast<std::size_t>(pair.b)].push_back(&pair);
    }
    return pairs;
}

// The rotation that the neighbours' estimates give a photo: the estimate that lies nearest to all others.
Eigen::Quaterniond asNeighboursSay(const ComponentInput& input, std::span<const UsedPair* const> pairs,
                                   std::span<const PhotoState> states, std::size_t photo) {
    std::vector<Eigen::Quaterniond> said;
    for (const UsedPair* pair : pairs) {
        const PairEstimate& estimate = input.candidates.estimates[static_cast<std::size_t>(pair->pair)];
        const bool isA = static_cast<std::size_t>(pair->a) == photo;
        const PhotoState& other = states[static_cast<std::size_t>(isA ? pair->b : pair->a)];
        said.push_back(other.roomFromPhoto * (isA ? estimate.aFromB.conjugate() : estimate.aFromB));
    }
    std::size_t best = 0;
    double least = -1;
    for (std::size_t i = 0; i < said.size(); ++i) {
        double sum = 0;
        for (const Eigen::Quaterniond& other : said) {
            sum += std::min(0.1, angleBetween(said[i], other).value());
        }
        if (least < 0 || sum < least) {
            least = sum;
            best = i;
        }
    }
    return said.empty() ? states[photo].roomFromPhoto : said[best];
}

/// Finds how the lenses stand, by what the matches miss if both stand in one place. Photos of a camera that
/// joins its pictures as if they did give 0.
void fitLenses(const RefinementOptions& options, ComponentState& state) {
    constexpr double kPriorM = 0.02;
    constexpr double kFarthestM = 0.05;
    constexpr double kTogether = 10.0 / 3; // Matches of one thing err together.
    constexpr double kClearSigmas = 3;
    std::vector<PhotoState> states = state.unknowns.states();
    LensPair lenses = state.unknowns.lenses;
    double weight = 0;
    for (int round = 0; round < 3; ++round) {
        double slope = lenses.aheadM / (kPriorM * kPriorM);
        weight = 1 / (kPriorM * kPriorM);
        for (PhotoState& photo : states) {
            photo.lenses = lenses;
        }
        for (const UsedPair& pair : state.used) {
            const PhotoState& a = states[static_cast<std::size_t>(pair.a)];
            const PhotoState& b = states[static_cast<std::size_t>(pair.b)];
            const Eigen::Vector3d aheadOfA = a.roomFromPhoto * Eigen::Vector3d::UnitX();
            const Eigen::Vector3d aheadOfB = b.roomFromPhoto * Eigen::Vector3d::UnitX();
            MatchRow rows[2];
            for (const UsedMatch& match : pair.matches) {
                if (matchRows(pair, match, a, b, rows) != 1) {
                    continue; // A turn alone tells nothing of places.
                }
                const Bounded robust = bounded(rows[0].residual / options.scale, options.width);
                const Eigen::Vector3d moved = softSide(match.inB) * aheadOfB - softSide(match.inA) * aheadOfA;
                const double by = robust.slope / options.scale * rows[0].by.tail<3>().dot(moved);
                slope += by * robust.value;
                weight += by * by;
            }
        }
        lenses.aheadM = std::clamp(lenses.aheadM - slope / weight, -kFarthestM, kFarthestM);
    }
    state.unknowns.lensSigmaM = kTogether / std::sqrt(weight);
    const bool isClear = std::abs(lenses.aheadM) > kClearSigmas * state.unknowns.lensSigmaM;
    state.unknowns.lenses = isClear ? lenses : LensPair{};
}

} // namespace

RefinementOptions refinementOptions(const SolveOptions& options, Model model, double scale) {
    RefinementOptions made;
    made.model = model;
    made.scale = scale;
    made.placementSigmaM = options.placementSigmaM;
    made.placementSigmaRad = options.placementSigma.value();
    made.threads = options.threads;
    return made;
}

void solveModel(const ComponentInput& input, Model model, bool isWarm, ComponentState& state,
                ProgressSink& progress, const std::stop_token& stop) {
    if (model == Model::Yaw) {
        level(state.unknowns, input.priors);
    }
    ProgressStep first(progress, 0, 0.3);
    if (!isWarm) {
        comeNear(input, model, state, first, stop);
    }
    constexpr int kRounds = 2;
    for (int round = 0; round < kRounds; ++round) {
        ProgressStep step(progress, 0.3 + 0.35 * round, 0.3 + 0.35 * (round + 1));
        const std::vector<UsedPair> estimated =
            estimatedMatches(input.candidates, state.unknowns, input.priors, input.selection);
        state.scale = residualScale(estimated, state.unknowns.states());
        // In the first round the photos are not yet in place; the scale is large, so few matches are lost.
        state.used =
            agreeingMatches(input.candidates, state.unknowns, input.priors, state.scale, input.selection);
        RefinementOptions options = refinementOptions(*input.options, model, state.scale);
        options.iterations = round == 0 ? 10 : 15;
        options.tolerance = round == 0 ? 1e-5 : 1e-8;
        refineState(input, options, state, step, stop);
        if (solvesTilt(model)) {
            fitLenses(options, state);
        }
    }
    state.scale = residualScale(state.used, state.unknowns.states());
}

int turnStrays(const ComponentInput& input, Model model, ComponentState& state) {
    if (!solvesTilt(model)) {
        return 0;
    }
    const auto pairs = pairsOfPhotos(state);
    std::vector<PhotoState> states = state.unknowns.states();
    const RefinementOptions options = refinementOptions(*input.options, model, state.scale);
    const auto costOf = [&](std::size_t photo) {
        double sum = 0;
        for (const UsedPair* pair : pairs[photo]) {
            sum += pairCost(*pair, states[static_cast<std::size_t>(pair->a)],
                            states[static_cast<std::size_t>(pair->b)], options.scale, options.width);
        }
        return sum;
    };
    int turned = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Eigen::Quaterniond said = asNeighboursSay(input, pairs[i], states, i);
        if (angleBetween(said, states[i].roomFromPhoto).value() < kStrayRad) {
            continue;
        }
        const double before = costOf(i);
        const Eigen::Quaterniond kept = states[i].roomFromPhoto;
        states[i].roomFromPhoto = said;
        if (costOf(i) < before) {
            state.unknowns.reference[i] = said;
            state.unknowns.turn[i] = {};
            ++turned;
        } else {
            states[i].roomFromPhoto = kept;
        }
    }
    return turned;
}

} // namespace spherewalk::align
