// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/component_solver.h"

#include "graph/pose_graph.h"
#include "solve/normal_equations.h"
#include "solve/pair_normal.h"

#include "spherewalk/geometry/rotation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spherewalk::align {

namespace {

constexpr int kFirstMatches = 60; // Matches a pair that are enough to come near.
constexpr double kStrayRad = 0.01;

void refineState(const ComponentInput& input, RefinementOptions options, ComponentState& state,
                 ProgressSink& progress, const std::stop_token& stop) {
    state.cost = refine(state.unknowns, input.priors, state.used, options, progress, stop);
}

/// A pair's baseline as a row of least squares: the way from a to b has this direction, whatever its length.
struct BaselineRow {
    int a = 0; ///< Place of the photo within the component.
    int b = 0;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< In the room.
    double sigmaRad = 0;
    double tagSigmaM = 0; ///< Of the way by the tags.
};

std::vector<BaselineRow> baselineRows(const ComponentInput& input, const Unknowns& unknowns) {
    constexpr double kLeastSigmaRad = 0.02; // The rotations err, too.
    std::vector<BaselineRow> rows;
    for (const int at : input.candidates.chosen) {
        const PairEstimate& estimate = input.candidates.estimates[static_cast<std::size_t>(at)];
        if (estimate.baselineInA) {
            const int a = input.candidates.indexOf[static_cast<std::size_t>(estimate.a)];
            const int b = input.candidates.indexOf[static_cast<std::size_t>(estimate.b)];
            rows.push_back({a, b,
                            unknowns.state(static_cast<std::size_t>(a)).roomFromPhoto * *estimate.baselineInA,
                            std::hypot(kLeastSigmaRad, estimate.baselineSigmaRad),
                            waySigmaM(input.priors[static_cast<std::size_t>(estimate.a)],
                                      input.priors[static_cast<std::size_t>(estimate.b)])});
        }
    }
    return rows;
}

/// Moves places that are known roughly to where the baselines of the pairs point, as far as the tags let
/// them: from a start that is half a metre off, matches would agree with the wrong planes. Robust least
/// squares, Cauchy's norm.
void followBaselines(const ComponentInput& input, Unknowns& unknowns) {
    constexpr int kRounds = 10;
    constexpr double kLeastWayM = 0.05;
    const std::vector<BaselineRow> rows = baselineRows(input, unknowns);
    const auto count = static_cast<Eigen::Index>(3 * unknowns.photo.size());
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
        for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
            const Eigen::Vector3d sigmas =
                offsetSigmasM(input.priors[static_cast<std::size_t>(unknowns.photo[i])]);
            for (int k = 0; k < 3; ++k) {
                const auto at = static_cast<int>(3 * i) + k;
                entries.emplace_back(at, at, 1 / (sigmas[k] * sigmas[k]));
            }
        }
        for (const BaselineRow& row : rows) {
            const auto a = static_cast<std::size_t>(row.a);
            const auto b = static_cast<std::size_t>(row.b);
            const Eigen::Vector3d way = unknowns.state(b).positionM - unknowns.state(a).positionM;
            const Eigen::Vector3d planned = unknowns.plannedM[b] - unknowns.plannedM[a];
            // Matches do not tell how long a way is: without the tags' word, it would shrink to nothing
            // wherever its direction contradicts them.
            const double leastM =
                std::max({planned.norm() - 2 * row.tagSigmaM, 0.1 * planned.norm(), kLeastWayM});
            const double length = std::max(row.direction.dot(way), leastM);
            const double sigmaM = row.sigmaRad * length;
            const double miss = (way - length * row.direction).norm() / sigmaM;
            const double weight = 1 / (sigmaM * sigmaM * (1 + miss * miss / 25));
            const Eigen::Vector3d wanted = weight * (length * row.direction - planned);
            for (int k = 0; k < 3; ++k) {
                const int ofA = 3 * row.a + k;
                const int ofB = 3 * row.b + k;
                entries.emplace_back(ofA, ofA, weight);
                entries.emplace_back(ofB, ofB, weight);
                entries.emplace_back(std::max(ofA, ofB), std::min(ofA, ofB), -weight);
                right[ofA] -= wanted[k];
                right[ofB] += wanted[k];
            }
        }
        Eigen::SparseMatrix<double> matrix(count, count);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const std::optional<Eigen::MatrixXd> offsets = solvedSparse(matrix, right);
        if (!offsets) {
            return;
        }
        for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                unknowns.offset[i][k] = (*offsets)(static_cast<Eigen::Index>(3 * i + k), 0);
            }
        }
    }
}

void comeNear(const ComponentInput& input, Model model, ComponentState& state, ProgressSink& progress,
              const std::stop_token& stop) {
    if (input.candidates.solvesPlaces) {
        followBaselines(input, state.unknowns);
    }
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

/// What the matches say of the lenses at the present poses.
struct LensEquation {
    double slope = 0;       ///< Derivative of half the cost by the lenses' distance.
    double weight = 0;      ///< Its second derivative, the poses answering.
    Eigen::VectorXd answer; ///< What the unknowns change by as the distance grows, by the columns.
};

LensEquation lensEquation(const Columns& columns, const RefinementOptions& options,
                          std::span<const PhotoPrior> priors, const ComponentState& state) {
    const std::vector<PhotoState> states = state.unknowns.states();
    LensEquation made;
    std::vector<Eigen::Matrix<double, 9, 9>> matrices;
    Eigen::VectorXd mixed = Eigen::VectorXd::Zero(columns.count());
    for (const UsedPair& pair : state.used) {
        const PhotoState& a = states[static_cast<std::size_t>(pair.a)];
        const PhotoState& b = states[static_cast<std::size_t>(pair.b)];
        const Eigen::Vector3d aheadOfA = a.roomFromPhoto * Eigen::Vector3d::UnitX();
        const Eigen::Vector3d aheadOfB = b.roomFromPhoto * Eigen::Vector3d::UnitX();
        Eigen::Matrix<double, 9, 9> matrix = Eigen::Matrix<double, 9, 9>::Zero();
        Eigen::Matrix<double, 9, 1> byLenses = Eigen::Matrix<double, 9, 1>::Zero();
        forEachRow(pair, states, [&](const UsedMatch& match, const MatchRow& row) {
            const Bounded robust = bounded(row.residual / options.scale, options.width);
            const Eigen::Matrix<double, 9, 1> by = robust.slope / options.scale * row.by;
            // A turn alone tells nothing of places: the end of its row is zero.
            const double byLens =
                by.tail<3>().dot(softSide(match.inB) * aheadOfB - softSide(match.inA) * aheadOfA);
            made.slope += byLens * robust.value;
            made.weight += byLens * byLens;
            byLenses += byLens * by;
            matrix.selfadjointView<Eigen::Lower>().rankUpdate(by);
        });
        matrices.emplace_back(matrix.selfadjointView<Eigen::Lower>());
        const PairColumns at = pairColumns(columns, state.unknowns, pair);
        const Eigen::VectorXd sums = at.chain * byLenses;
        for (std::size_t i = 0; i < at.column.size(); ++i) {
            mixed[at.column[i]] += sums[static_cast<Eigen::Index>(i)];
        }
    }
    const std::optional<Eigen::MatrixXd> solved =
        solvedSparse(normalMatrix(columns, state.unknowns, state.used, matrices,
                                  priorRows(columns, state.unknowns, priors, options)),
                     mixed);
    if (solved) {
        made.answer = -solved->col(0);
        made.weight = std::max(0.0, made.weight + mixed.dot(made.answer));
    } else {
        made.answer = Eigen::VectorXd::Zero(columns.count());
    }
    return made;
}

/// Finds how the lenses stand, by what the matches miss if both stand in one place; the poses go along.
/// Photos of a camera that joins its pictures as if they did give 0.
void fitLenses(const RefinementOptions& options, std::span<const PhotoPrior> priors, ComponentState& state) {
    constexpr double kPriorM = 0.02;
    constexpr double kFarthestM = 0.05;
    constexpr double kClearSigmas = 3;
    Unknowns& unknowns = state.unknowns;
    const Columns columns(unknowns, options.model);
    const LensEquation equation = lensEquation(columns, options, priors, state);
    const double weight = equation.weight + 1 / (kPriorM * kPriorM);
    const double before = unknowns.lenses.aheadM;
    const double fitted = before - (equation.slope + before / (kPriorM * kPriorM)) / weight;
    unknowns.lensSigmaM = kErrTogether / std::sqrt(weight);
    const bool isClear = std::abs(fitted) > kClearSigmas * unknowns.lensSigmaM;
    unknowns.lenses.aheadM = isClear ? std::clamp(fitted, -kFarthestM, kFarthestM) : 0;
    move(columns, (unknowns.lenses.aheadM - before) * equation.answer, unknowns);
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
            fitLenses(options, input.priors, state);
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
