// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"
#include "solve/component_solver.h"
#include "solve/normal_equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spherewalk::align {

namespace {

void scaleSigmas(std::vector<PhotoPrior>& priors, const Unknowns& unknowns, const PriorScatter& by) {
    constexpr double kMostM = 5;
    for (const int photo : unknowns.photo) {
        PhotoPrior& prior = priors[static_cast<std::size_t>(photo)];
        prior.positionSigmaM = std::min(kMostM, by.along * prior.positionSigmaM);
        prior.heightSigmaM = std::min(kMostM, by.height * prior.heightSigmaM);
    }
}

/// How much more the offsets may scatter by chance than their priors promise. A scatter that is found by a
/// median is good to its part of 0.83 / sqrt(freedom) (one standard deviation).
double mostByChance(double freedom) {
    constexpr double kSigmas = 3;
    constexpr double kHarmless = 1.5;
    return std::max(kHarmless, 1 + kSigmas * 0.83 / std::sqrt(std::max(1.0, freedom)));
}

} // namespace

bool widenPriors(std::vector<PhotoPrior>& priors, const ComponentInput& input, Model model,
                 ComponentState& state, ProgressSink& progress, const std::stop_token& stop) {
    constexpr double kSettled = 1.2;
    constexpr int kMostRounds = 4;
    PriorScatter widened;
    const Eigen::Vector3d freedom = offsetFreedom(state.unknowns);
    const auto step = [](double scatter, double most, double& all) {
        const bool isOff = all > 1 ? std::max(scatter, 1 / scatter) > kSettled : scatter > most;
        const double by = isOff ? std::max(scatter, 1 / all) : 1;
        all *= by;
        return by;
    };
    for (int round = 0; round < kMostRounds && solvesPosition(model); ++round) {
        PriorScatter scatter = priorScatter(state.unknowns, priors);
        scatter.height = std::max(scatter.height, commonLeanScatter(state.unknowns, priors));
        const PriorScatter by = {step(scatter.along, mostByChance(freedom.x()), widened.along),
                                 step(scatter.height, mostByChance(freedom.z()), widened.height)};
        if (by.along == 1 && by.height == 1) {
            break;
        }
        scaleSigmas(priors, state.unknowns, by);
        solveModel(input, model, true, state, progress, stop);
    }
    return widened.along > 1 || widened.height > 1;
}

namespace {

/// What is held by a prior of its own kind: rails across the floor and in heading, photos along the floor and
/// in height.
enum class Held { RailPlace, RailHeading, PhotoPlace, PhotoHeight };

constexpr std::size_t kKinds = 4;

/// One number that a prior holds near zero.
struct HeldNumber {
    Held kind = Held::RailPlace;
    int column = 0;
    double value = 0; ///< As solved.
    double sigma = 1; ///< Of its prior, as stated.
};

std::vector<HeldNumber> heldNumbers(const Columns& columns, const Unknowns& unknowns,
                                    std::span<const PhotoPrior> priors, const RefinementOptions& options) {
    std::vector<HeldNumber> held;
    for (std::size_t rail = 0; rail < unknowns.placement.size(); ++rail) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double sigma = i < 2 ? options.placementSigmaM : options.placementSigmaRad;
            held.push_back({i < 2 ? Held::RailPlace : Held::RailHeading, columns.placement(rail)[i],
                            unknowns.placement[rail][i], std::max(sigma, kLeastPlacementSigma)});
        }
    }
    for (std::size_t photo = 0; photo < unknowns.photo.size(); ++photo) {
        const Eigen::Vector3d sigmas = offsetSigmasM(priors[static_cast<std::size_t>(unknowns.photo[photo])]);
        for (std::size_t i = 0; i < 3; ++i) {
            held.push_back({i < 2 ? Held::PhotoPlace : Held::PhotoHeight, columns.offset(photo)[i],
                            unknowns.offset[photo][i], sigmas[static_cast<Eigen::Index>(i)]});
        }
    }
    return held;
}

/// How far the numbers of a kind lie from zero, and how many of them the matches know.
struct Evidence {
    double squares = 0; ///< In standard deviations of the priors.
    double freedom = 0; ///< A number counts by the part that the matches know of it.
};

/// What the priors' deviations would have to be multiplied by at most: few numbers tell little, and then it
/// is 1.
double mostFactor(const Evidence& evidence) {
    constexpr double kDeviations = 1.5; // The variance of a chi-square is twice its freedom.
    const double sure = evidence.freedom - kDeviations * std::sqrt(2 * evidence.freedom);
    return sure > 1 ? std::min(1.0, std::sqrt((evidence.squares + 1) / sure)) : 1;
}

/// The equations of a solved component, for other deviations of its priors than the stated ones.
class PriorTrial {
  public:
    PriorTrial(const ComponentInput& input, const ComponentState& state)
        : m_options(refinementOptions(*input.options, Model::Position, state.scale)),
          m_columns(state.unknowns, Model::Position),
          m_held(heldNumbers(m_columns, state.unknowns, input.priors, m_options)) {
        std::vector<Eigen::Matrix<double, 9, 9>> matrices =
            matchMatrices(state.used, state.unknowns.states(), m_options);
        for (Eigen::Matrix<double, 9, 9>& matrix : matrices) {
            matrix /= kErrTogether * kErrTogether;
        }
        m_stated = normalMatrix(m_columns, state.unknowns, state.used, matrices,
                                priorRows(m_columns, state.unknowns, input.priors, m_options));
    }

    /// One entry a kind, in the order of Held. Empty if the equations cannot be solved.
    std::optional<std::array<Evidence, kKinds>> evidence(const std::array<double, kKinds>& factors) const {
        Eigen::SparseMatrix<double> matrix = m_stated;
        // The first column moves the solution to where these priors put it.
        Eigen::MatrixXd right =
            Eigen::MatrixXd::Zero(m_columns.count(), 1 + static_cast<Eigen::Index>(m_held.size()));
        for (std::size_t i = 0; i < m_held.size(); ++i) {
            const HeldNumber& held = m_held[i];
            const double more = weightOf(held, factors) - weightOf(held, kAsStated);
            matrix.coeffRef(held.column, held.column) += more;
            right(held.column, 0) -= more * held.value;
            right(held.column, static_cast<Eigen::Index>(i) + 1) = 1;
        }
        const std::optional<Eigen::MatrixXd> solved = solvedSparse(matrix, right);
        if (!solved) {
            return std::nullopt;
        }
        std::array<Evidence, kKinds> made;
        for (std::size_t i = 0; i < m_held.size(); ++i) {
            const HeldNumber& held = m_held[i];
            const double weight = weightOf(held, factors);
            const double value = held.value + (*solved)(held.column, 0);
            const double variance = (*solved)(held.column, static_cast<Eigen::Index>(i) + 1);
            Evidence& evidence = made[static_cast<std::size_t>(held.kind)];
            evidence.squares += weight * value * value;
            evidence.freedom += std::clamp(1 - weight * variance, 0.0, 1.0);
        }
        return made;
    }

    static constexpr std::array<double, kKinds> kAsStated = {1, 1, 1, 1};

  private:
    static double weightOf(const HeldNumber& held, const std::array<double, kKinds>& factors) {
        const double sigma = factors[static_cast<std::size_t>(held.kind)] * held.sigma;
        return 1 / (sigma * sigma);
    }

    RefinementOptions m_options;
    Columns m_columns;
    std::vector<HeldNumber> m_held;
    Eigen::SparseMatrix<double> m_stated; ///< With the priors as stated.
};

/// What the priors' deviations shall be multiplied by.
std::array<double, kKinds> narrowFactors(const ComponentInput& input, const ComponentState& state) {
    constexpr int kRounds = 6;
    constexpr double kLeast = 0.2;
    constexpr double kSettled = 0.95;
    const PriorTrial trial(input, state);
    std::array<double, kKinds> factors = PriorTrial::kAsStated;
    for (int round = 0; round < kRounds; ++round) {
        const auto evidence = trial.evidence(factors);
        if (!evidence) {
            break;
        }
        bool isSettled = true;
        for (std::size_t kind = 0; kind < kKinds; ++kind) {
            const double before = factors[kind];
            factors[kind] = std::max(kLeast, before * mostFactor((*evidence)[kind]));
            isSettled = isSettled && factors[kind] > kSettled * before;
        }
        if (isSettled) {
            break;
        }
    }
    return factors;
}

} // namespace

bool narrowPriors(std::vector<PhotoPrior>& priors, SolveOptions& options, const ComponentInput& input,
                  Model model, ComponentState& state, ProgressSink& progress, const std::stop_token& stop) {
    constexpr double kWorthwhile = 0.8;
    ComponentState trial = state;
    if (!solvesPosition(model)) {
        solveModel(input, Model::Position, true, trial, progress, stop);
    }
    const std::array<double, kKinds> factors = narrowFactors(input, trial);
    const auto factor = [&](Held kind) { return factors[static_cast<std::size_t>(kind)]; };
    if (*std::ranges::min_element(factors) > kWorthwhile) {
        return false;
    }
    options.placementSigmaM *= factor(Held::RailPlace);
    options.placementSigma = options.placementSigma * factor(Held::RailHeading);
    scaleSigmas(priors, state.unknowns, {factor(Held::PhotoPlace), factor(Held::PhotoHeight)});
    if (solvesPlacement(model)) {
        solveModel(input, model, true, state, progress, stop);
    }
    return true;
}

} // namespace spherewalk::align
