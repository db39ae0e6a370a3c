// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/refinement.h"

#include "pairs/pair_geometry.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <Eigen/Cholesky>
#include <ceres/ceres.h>

#if __has_include(<glog/logging.h>)
#include <glog/logging.h>
#endif

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::align {

UprightBlock::UprightBlock(const Eigen::Quaterniond& reference, const Eigen::Vector3d& upInPhoto,
                           double sigmaRad)
    : m_up(reference * upInPhoto), m_sigmaRad(sigmaRad) {
}

bool UprightBlock::Evaluate(const double* const* parameters, double* residuals, double** jacobians) const {
    const Eigen::Vector3d moved = Eigen::Map<const Eigen::Vector3d>(parameters[0]);
    const Lean lean = leanOf(turn(moved) * m_up);
    Eigen::Map<Eigen::Vector2d> leaning(residuals);
    leaning = lean.vectorRad / m_sigmaRad;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
        Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>> rows(jacobians[0]);
        rows = lean.byTurn * leftJacobian(moved) / m_sigmaRad;
    }
    return true;
}

bool NearZeroBlock::Evaluate(const double* const* parameters, double* residuals, double** jacobians) const {
    const Eigen::Map<const Eigen::Vector3d> value(parameters[0]);
    Eigen::Map<Eigen::Vector3d> away(residuals);
    away = value.cwiseQuotient(m_sigmas);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
        Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rows(jacobians[0]);
        rows = m_sigmas.cwiseInverse().asDiagonal();
    }
    return true;
}

namespace {

// A matrix R with R^T * R equal to this semidefinite one.
PairNormal rootOf(const PairNormal& normal) {
    const Eigen::LDLT<PairNormal> factor(normal);
    const Eigen::Matrix<double, 10, 1> roots = factor.vectorD().cwiseMax(0).cwiseSqrt();
    PairNormal root = factor.transpositionsP() * PairNormal::Identity();
    root = (factor.matrixU() * root).eval();
    root = (roots.asDiagonal() * root).eval();
    return root;
}

} // namespace

PairEvaluation::PairEvaluation(const Unknowns& unknowns, std::span<const UsedPair> pairs, double scale,
                               double width, int threads, std::stop_token stop)
    : m_unknowns(unknowns),
      m_pairs(pairs),
      m_scale(scale),
      m_width(width),
      m_threads(threads),
      m_stop(std::move(stop)),
      m_normals(pairs.size()),
      m_costs(pairs.size()) {
}

void PairEvaluation::PrepareForEvaluation(bool withDerivatives, bool isNewPoint) {
    if (!isNewPoint && !withDerivatives) {
        return;
    }
    const std::vector<PhotoState> states = m_unknowns.states();
    parallelFor(static_cast<int>(m_pairs.size()), 16, m_threads, [&](int begin, int end) {
        for (int at = begin; at < end && !m_stop.stop_requested(); ++at) {
            const auto i = static_cast<std::size_t>(at);
            const UsedPair& pair = m_pairs[i];
            const PhotoState& a = states[static_cast<std::size_t>(pair.a)];
            const PhotoState& b = states[static_cast<std::size_t>(pair.b)];
            if (withDerivatives) {
                m_normals[i] = pairNormal(pair, a, b, m_scale, m_width);
                m_costs[i] = m_normals[i](9, 9);
            } else {
                m_costs[i] = pairCost(pair, a, b, m_scale, m_width);
            }
        }
    });
}

PairBlock::PairBlock(const PairEvaluation& evaluation, std::size_t index, const UsedPair& pair, Model model)
    : m_evaluation(evaluation),
      m_index(index),
      m_a(static_cast<std::size_t>(pair.a)),
      m_b(static_cast<std::size_t>(pair.b)) {
    set_num_residuals(10);
    using Kind = Moved::Kind;
    m_moved = {{Kind::Turn, true, false}, {Kind::Turn, false, true}};
    const std::vector<int>& rail = evaluation.unknowns().rail;
    if (solvesPlacement(model)) {
        if (rail[m_a] >= 0) {
            m_moved.push_back({Kind::Placement, true, rail[m_a] == rail[m_b]});
        }
        if (rail[m_b] >= 0 && rail[m_a] != rail[m_b]) {
            m_moved.push_back({Kind::Placement, false, true});
        }
    }
    if (solvesPosition(model)) {
        m_moved.push_back({Kind::Offset, true, false});
        m_moved.push_back({Kind::Offset, false, true});
    }
    mutable_parameter_block_sizes()->assign(m_moved.size(), 3);
}

std::vector<double*> PairBlock::parameters(Unknowns& unknowns, const UsedPair& pair, Model model) {
    const auto a = static_cast<std::size_t>(pair.a);
    const auto b = static_cast<std::size_t>(pair.b);
    std::vector<double*> blocks = {unknowns.turn[a].data(), unknowns.turn[b].data()};
    if (solvesPlacement(model)) {
        for (const int rail : {unknowns.rail[a], unknowns.rail[b]}) {
            double* block = rail < 0 ? nullptr : unknowns.placement[static_cast<std::size_t>(rail)].data();
            if (block != nullptr && std::ranges::find(blocks, block) == blocks.end()) {
                blocks.push_back(block);
            }
        }
    }
    if (solvesPosition(model)) {
        blocks.push_back(unknowns.offset[a].data());
        blocks.push_back(unknowns.offset[b].data());
    }
    return blocks;
}

PairBlock::Rows PairBlock::rowsBy(const Moved& moved, const double* parameter, const PairNormal& root) const {
    if (moved.kind == Moved::Kind::Turn) {
        const Eigen::Matrix3d inner = leftJacobian(Eigen::Map<const Eigen::Vector3d>(parameter));
        return root.middleCols<3>(moved.isA ? 0 : 3) * inner;
    }
    Eigen::Matrix3d baselineBy = Eigen::Matrix3d::Zero();
    if (moved.kind == Moved::Kind::Offset) {
        baselineBy = Eigen::Matrix3d::Identity() * (moved.isB ? 1 : -1);
    } else {
        if (moved.isB) {
            baselineBy += m_evaluation.unknowns().positionByPlacement(m_b);
        }
        if (moved.isA) {
            baselineBy -= m_evaluation.unknowns().positionByPlacement(m_a);
        }
    }
    return root.middleCols<3>(6) * baselineBy;
}

bool PairBlock::Evaluate(const double* const* parameters, double* residuals, double** jacobians) const {
    if (m_evaluation.isStopped()) {
        return false;
    }
    Eigen::Map<Eigen::Matrix<double, 10, 1>> value(residuals);
    if (jacobians == nullptr) {
        value.setZero();
        value[0] = std::sqrt(m_evaluation.cost(m_index));
        return true;
    }
    const PairNormal root = rootOf(m_evaluation.normal(m_index));
    value = root.col(9);
    for (std::size_t i = 0; i < m_moved.size(); ++i) {
        if (jacobians[i] != nullptr) {
            Eigen::Map<Rows> rows(jacobians[i]);
            rows = rowsBy(m_moved[i], parameters[i], root);
        }
    }
    return true;
}

namespace {

// In standard deviations: beyond it a prior's pull grows no more, so that one wrong tag does not bend all.
constexpr double kLargestPull = 4;

/// Ceres 2.0 has another name for what keeps the tilt.
void keepTilt(ceres::Problem& problem, double* turn) {
#if CERES_VERSION_MAJOR == 2 && CERES_VERSION_MINOR == 0
    problem.SetParameterization(turn, new ceres::SubsetParameterization(3, {0, 1}));
#else
    problem.SetManifold(turn, new ceres::SubsetManifold(3, {0, 1}));
#endif
}

void addPhotos(ceres::Problem& problem, Unknowns& unknowns, std::span<const PhotoPrior> priors,
               const RefinementOptions& options) {
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const PhotoPrior& prior = priors[static_cast<std::size_t>(unknowns.photo[i])];
        problem.AddParameterBlock(unknowns.turn[i].data(), 3);
        if (solvesTilt(options.model)) {
            const Vertical up = knownUp(prior);
            problem.AddResidualBlock(new UprightBlock(unknowns.reference[i], up.upInPhoto, up.sigmaRad),
                                     new ceres::HuberLoss(kLargestPull), unknowns.turn[i].data());
        } else {
            keepTilt(problem, unknowns.turn[i].data());
        }
        if (solvesPosition(options.model)) {
            problem.AddResidualBlock(new NearZeroBlock(offsetSigmasM(prior)),
                                     new ceres::HuberLoss(kLargestPull), unknowns.offset[i].data());
        }
    }
}

void addRails(ceres::Problem& problem, Unknowns& unknowns, const RefinementOptions& options) {
    if (!solvesPlacement(options.model)) {
        return;
    }
    const Eigen::Vector3d sigmas =
        Eigen::Vector3d(options.placementSigmaM, options.placementSigmaM, options.placementSigmaRad)
            .cwiseMax(kLeastPlacementSigma);
    for (Unknowns::Block& placement : unknowns.placement) {
        problem.AddResidualBlock(new NearZeroBlock(sigmas), new ceres::HuberLoss(kLargestPull),
                                 placement.data());
    }
}

ceres::Solver::Options solverOptions(const RefinementOptions& options) {
    ceres::Solver::Options made;
    made.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    made.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
    made.max_num_iterations = options.iterations;
    made.function_tolerance = options.tolerance;
    made.parameter_tolerance = 1e-10;
    made.num_threads = 1; // PairEvaluation uses the others
    made.initial_trust_region_radius = 1e6;
    made.logging_type = ceres::SILENT;
    return made;
}

} // namespace

SolverWatch::SolverWatch(ProgressSink& progress, const std::stop_token& stop, int iterations,
                         std::string_view what)
    : m_progress(progress), m_stop(stop), m_iterations(iterations), m_what(what) {
#if __has_include(<glog/logging.h>)
    // Whatever its options say, Ceres warns on stderr of each step that it cannot compute and tries shorter.
    [[maybe_unused]] static const int quiet = (FLAGS_minloglevel = google::GLOG_ERROR);
#endif
}

ceres::CallbackReturnType SolverWatch::operator()(const ceres::IterationSummary& summary) {
    m_progress.progress(std::min(1.0, (summary.iteration + 1.0) / (m_iterations + 1)), m_what);
    return m_stop.stop_requested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
}

double refine(Unknowns& unknowns, std::span<const PhotoPrior> priors, std::span<const UsedPair> pairs,
              const RefinementOptions& options, ProgressSink& progress, const std::stop_token& stop) {
    throwIfStopped(stop);
    unknowns.rebase();
    PairEvaluation evaluation(unknowns, pairs, options.scale, options.width, options.threads, stop);
    ceres::Problem::Options problemOptions;
    problemOptions.evaluation_callback = &evaluation;
    ceres::Problem problem(problemOptions);
    addPhotos(problem, unknowns, priors, options);
    addRails(problem, unknowns, options);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        problem.AddResidualBlock(new PairBlock(evaluation, i, pairs[i], options.model), nullptr,
                                 PairBlock::parameters(unknowns, pairs[i], options.model));
    }
    ceres::Solver::Options solver = solverOptions(options);
    SolverWatch watch(progress, stop, options.iterations, "Solving");
    solver.callbacks.push_back(&watch);
    solver.update_state_every_iteration = true;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    throwIfStopped(stop);
    if (!summary.IsSolutionUsable()) {
        throw Error(ErrorKind::Internal,
                    "The alignment could not be solved: the photos' matches contradict "
                    "each other in a way that was not foreseen. Leave out the photos "
                    "taken last, and try again.",
                    summary.message);
    }
    unknowns.rebase();
    return summary.final_cost;
}

} // namespace spherewalk::align
