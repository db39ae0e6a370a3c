// SPDX-License-Identifier: GPL-3.0-or-later
#include "refinement.h"

#include "pair_block.h"
#include "prior_blocks.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <ceres/ceres.h>

#include <algorithm>

namespace spherewalk::align {

namespace {

// A prior's pull grows no more beyond this many standard deviations: one wrong tag shall not bend all.
constexpr double kLargestPull = 4;

// A lost prior must not leave the matrix singular: a rail that no pair holds stays where it was planned.
constexpr double kLeastSigma = 1e-5;

class Watch : public ceres::IterationCallback {
  public:
    Watch(ProgressSink& progress, const std::stop_token& stop, int iterations)
        : m_progress(progress), m_stop(stop), m_iterations(iterations) {}

    ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
        m_progress.progress(std::min(1.0, (summary.iteration + 1.0) / (m_iterations + 1)), "Solving");
        return m_stop.stop_requested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

  private:
    ProgressSink& m_progress;
    const std::stop_token& m_stop;
    int m_iterations;
};

void addPhotos(ceres::Problem& problem, Unknowns& unknowns, std::span<const PhotoPrior> priors,
               const RefinementOptions& options) {
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const PhotoPrior& prior = priors[static_cast<std::size_t>(unknowns.photo[i])];
        problem.AddParameterBlock(unknowns.turn[i].data(), 3);
        if (solvesTilt(options.model)) {
            const UpPrior up = upPrior(prior);
            problem.AddResidualBlock(new UprightBlock(unknowns.reference[i], up.upInPhoto, up.sigmaRad),
                                     new ceres::HuberLoss(kLargestPull), unknowns.turn[i].data());
        } else {
            problem.SetManifold(unknowns.turn[i].data(), new ceres::SubsetManifold(3, {0, 1}));
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
            .cwiseMax(kLeastSigma);
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
    Watch watch(progress, stop, options.iterations);
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
