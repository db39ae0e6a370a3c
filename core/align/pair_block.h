// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pair_normal.h"
#include "unknowns.h"

#include <ceres/cost_function.h>
#include <ceres/evaluation_callback.h>

#include <atomic>
#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::align {

/// Sums up all pairs whenever Ceres asks for a new point, on several threads, each pair for itself: the
/// result does not depend on their number, as it would if Ceres itself summed up on several.
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

/// One pair's matches as ten residuals that have the same squares, gradient and Gauss-Newton matrix as all of
/// them. Parameters: the turns of a and b, then, as the model has them, the placements of their rails (one if
/// it is the same) and their offsets.
class PairBlock : public ceres::CostFunction {
  public:
    PairBlock(const PairEvaluation& evaluation, std::size_t index, const UsedPair& pair, Model model);

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override;

    /// The parameter blocks in Evaluate's order.
    static std::vector<double*> parameters(Unknowns& unknowns, const UsedPair& pair, Model model);

  private:
    using Rows = Eigen::Matrix<double, 10, 3, Eigen::RowMajor>;

    /// What a parameter block moves.
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

} // namespace spherewalk::align
