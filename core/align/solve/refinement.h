// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solve/unknowns.h"

#include "spherewalk/base/progress.h"

#include <Eigen/Geometry>
#include <ceres/cost_function.h>
#include <ceres/evaluation_callback.h>
#include <ceres/iteration_callback.h>
#include <ceres/sized_cost_function.h>

#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

namespace spherewalk::align {

struct RefinementOptions {
    Model model = Model::Position; ///< Any but Auto.
    double scale = 1;              ///< Factor by which the matches' sigmas are too small.
    double width = 4;              ///< Of the bounded norm, in scaled standard deviations.
    double placementSigmaM = 0.01;
    double placementSigmaRad = 0.0175;
    int iterations = 25;
    double tolerance = 1e-7; ///< Of the cost, relative.
    int threads = 0;
};

/// Of a rail's placement. A lost prior must not leave the matrix singular: a rail that no pair holds stays
/// where it was planned.
constexpr double kLeastPlacementSigma = 1e-5;

/// Matches of one thing err together: all of them know a number so many times worse than each by itself
/// would.
constexpr double kErrTogether = 10.0 / 3;

/// Holds a photo upright. Residuals: the lean of the photo's own up vector in the room (leanOf()), in
/// standard deviations. A photo that hangs upside down costs most, so upright is the only rest. Parameters:
/// the photo's turn from its reference.
class UprightBlock : public ceres::SizedCostFunction<2, 3> {
  public:
    UprightBlock(const Eigen::Quaterniond& reference, const Eigen::Vector3d& upInPhoto, double sigmaRad);

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override;

  private:
    Eigen::Vector3d m_up; ///< Turned by the reference.
    double m_sigmaRad;
};

/// Holds three numbers near zero, each within its own standard deviation.
class NearZeroBlock : public ceres::SizedCostFunction<3, 3> {
  public:
    explicit NearZeroBlock(const Eigen::Vector3d& sigmas) : m_sigmas(sigmas) {}

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override;

  private:
    Eigen::Vector3d m_sigmas;
};

/// Sums up all pairs whenever Ceres asks for a new point, on several threads, each pair for itself. So the
/// result does not depend on the number of threads, as it would if Ceres summed up on several.
class PairEvaluation : public ceres::EvaluationCallback {
  public:
    PairEvaluation(const Unknowns& unknowns, std::span<const UsedPair> pairs, double scale, double width,
                   int threads, std::stop_token stop);

    void PrepareForEvaluation(bool withDerivatives, bool isNewPoint) override;

    const PairNormal& normal(std::size_t pair) const { return m_normals[pair]; }

    double cost(std::size_t pair) const { return m_costs[pair]; }

    bool isStopped() const { return m_stop.stop_requested(); }

    const Unknowns& unknowns() const { return m_unknowns; }

  private:
    const Unknowns& m_unknowns;
    std::span<const UsedPair> m_pairs;
    double m_scale;
    double m_width;
    int m_threads;
    std::stop_token m_stop;
    std::vector<PairNormal> m_normals;
    std::vector<double> m_costs;
};

/// One pair's matches as ten residuals with the same sum of squares, gradient and Gauss-Newton matrix.
/// Parameters: the turns of a and b, then, as far as the model has them, the placements of their rails (one
/// if it is the same rail) and their offsets.
class PairBlock : public ceres::CostFunction {
  public:
    PairBlock(const PairEvaluation& evaluation, std::size_t index, const UsedPair& pair, Model model);

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override;

    /// The parameter blocks in Evaluate's order.
    static std::vector<double*> parameters(Unknowns& unknowns, const UsedPair& pair, Model model);

  private:
    using Rows = Eigen::Matrix<double, 10, 3, Eigen::RowMajor>;

    /// The thing that a parameter block moves.
    struct Moved {
        enum class Kind { Turn, Placement, Offset };

        Kind kind = Kind::Turn;
        bool isA = false;
        bool isB = false;
    };

    Rows rowsBy(const Moved& moved, const double* parameter, const PairNormal& root) const;

    const PairEvaluation& m_evaluation;
    std::size_t m_index;
    std::size_t m_a;
    std::size_t m_b;
    std::vector<Moved> m_moved;
};

/// Tells how far a solver is, and ends it when asked. Owner: what it is given must outlive it.
class SolverWatch : public ceres::IterationCallback {
  public:
    SolverWatch(ProgressSink& progress, const std::stop_token& stop, int iterations, std::string_view what);

    ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override;

  private:
    ProgressSink& m_progress;
    const std::stop_token& m_stop;
    int m_iterations;
    std::string_view m_what;
};

/// Moves the unknowns to the least squares of the matches and the priors, and returns the cost. Errors:
/// Internal if Ceres gives up. Stop: Error{Stopped}.
double refine(Unknowns& unknowns, std::span<const PhotoPrior> priors, std::span<const UsedPair> pairs,
              const RefinementOptions& options, ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::align
