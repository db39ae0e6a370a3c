// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"
#include "solve/component_solver.h"
#include "solve/normal_equations.h"
#include "solve/pair_normal.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace spherewalk::align {

namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;

constexpr double kMostLeverage = 0.3;
constexpr double kWorstLeverage = 0.95; ///< Rounding must not make it 1.

/// A match's rows as least squares count them.
Eigen::Matrix<double, 9, 1> weighted(const MatchRow& row, const RefinementOptions& options) {
    return bounded(row.residual / options.scale, options.width).slope / options.scale * row.by;
}

/// The largest of row * covariance * row, for each match of a pair.
std::vector<double> leverages(const UsedPair& pair, std::span<const PhotoState> states,
                              const RefinementOptions& options, const Matrix9d& covariance) {
    std::vector<double> made;
    for (const UsedMatch& match : pair.matches) {
        MatchRow rows[2];
        const int count = matchRows(pair, match, states[static_cast<std::size_t>(pair.a)],
                                    states[static_cast<std::size_t>(pair.b)], rows);
        double most = 0;
        for (int i = 0; i < count; ++i) {
            const Eigen::Matrix<double, 9, 1> row = weighted(rows[i], options);
            most = std::max(most, row.dot(covariance * row));
        }
        made.push_back(most);
    }
    return made;
}

/// What the pair's matches would know without any other pair, which can only be less.
Matrix9d aloneCovariance(const Matrix9d& normal) {
    return normal.completeOrthogonalDecomposition().pseudoInverse();
}

/// The pairs of which some match may hardly be confirmed by others, each with what its matches know.
struct WeakPairs {
    std::vector<std::size_t> at;    ///< Indices among the used pairs.
    std::vector<Matrix9d> matrices; ///< One a used pair.
};

WeakPairs weakPairs(const ComponentState& state, std::span<const PhotoState> states,
                    const RefinementOptions& options) {
    WeakPairs made{{}, matchMatrices(state.used, states, options)};
    for (std::size_t i = 0; i < state.used.size(); ++i) {
        const std::vector<double> alone =
            leverages(state.used[i], states, options, aloneCovariance(made.matrices[i]));
        if (!alone.empty() && *std::ranges::max_element(alone) > kMostLeverage) {
            made.at.push_back(i);
        }
    }
    return made;
}

/// The covariance of the nine numbers of each of these pairs, by all matches and priors. Empty if the
/// equations cannot be solved.
std::vector<Matrix9d> covariances(const WeakPairs& weak, const ComponentInput& input,
                                  const ComponentState& state, const RefinementOptions& options) {
    const Columns columns(state.unknowns, options.model);
    Eigen::MatrixXd right =
        Eigen::MatrixXd::Zero(columns.count(), 9 * static_cast<Eigen::Index>(weak.at.size()));
    for (std::size_t i = 0; i < weak.at.size(); ++i) {
        const PairColumns at = pairColumns(columns, state.unknowns, state.used[weak.at[i]]);
        for (std::size_t row = 0; row < at.column.size(); ++row) {
            right.block<1, 9>(at.column[row], 9 * static_cast<Eigen::Index>(i)) =
                at.chain.row(static_cast<Eigen::Index>(row));
        }
    }
    const std::optional<Eigen::MatrixXd> solved =
        solvedSparse(normalMatrix(columns, state.unknowns, state.used, weak.matrices,
                                  priorRows(columns, state.unknowns, input.priors, options)),
                     right);
    std::vector<Matrix9d> made;
    for (std::size_t i = 0; solved && i < weak.at.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(9 * i);
        made.emplace_back(right.middleCols<9>(at).transpose() * solved->middleCols<9>(at));
    }
    return made;
}

/// Writes into each match by how much the solution follows it.
void findLeverages(const ComponentInput& input, const RefinementOptions& options, ComponentState& state) {
    const std::vector<PhotoState> states = state.unknowns.states();
    for (UsedPair& pair : state.used) {
        for (UsedMatch& match : pair.matches) {
            match.leverage = 0;
        }
    }
    const WeakPairs weak = weakPairs(state, states, options);
    const std::vector<Matrix9d> known =
        weak.at.empty() ? std::vector<Matrix9d>() : covariances(weak, input, state, options);
    for (std::size_t i = 0; i < known.size(); ++i) {
        UsedPair& pair = state.used[weak.at[i]];
        const std::vector<double> found = leverages(pair, states, options, known[i]);
        for (std::size_t j = 0; j < found.size(); ++j) {
            pair.matches[j].leverage = std::clamp(found[j], 0.0, kWorstLeverage);
        }
    }
}

/// A match with more is not confirmed by the others. Sources: Huber, Robust Statistics, 1981 (up to 0.2 is
/// safe, above 0.5 is to be avoided); Hoaglin and Welsch, The Hat Matrix in Regression and ANOVA, 1978 (twice
/// the mean), since each match of few has much.
double mostLeverage(const UsedPair& pair) {
    double sum = 0;
    for (const UsedMatch& match : pair.matches) {
        sum += match.leverage;
    }
    return std::max(kMostLeverage,
                    2 * sum / static_cast<double>(std::max<std::size_t>(1, pair.matches.size())));
}

} // namespace

bool dropSelfWilled(const ComponentInput& input, Model model, ComponentState& state, ProgressSink& progress,
                    const std::stop_token& stop) {
    constexpr int kMostRounds = 5;
    RefinementOptions options = refinementOptions(*input.options, model, state.scale);
    options.iterations = 15;
    options.tolerance = 1e-8;
    bool isAny = false;
    for (int round = 0; round < kMostRounds; ++round) {
        findLeverages(input, options, state);
        if (input.candidates.solvesPlaces) {
            break; // Few matches would be left to tell places and turns.
        }
        std::size_t dropped = 0;
        for (UsedPair& pair : state.used) {
            const double most = mostLeverage(pair);
            dropped +=
                std::erase_if(pair.matches, [most](const UsedMatch& match) { return match.leverage > most; });
        }
        if (dropped == 0) {
            break;
        }
        isAny = true;
        state.cost = refine(state.unknowns, input.priors, state.used, options, progress, stop);
    }
    return isAny;
}

} // namespace spherewalk::align
