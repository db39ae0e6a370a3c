// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <ceres/tiny_solver.h>

#include <utility>

namespace spherewalk::align {

/// The misses after a small change of a few unknowns, for ceres::TinySolver. misses(change): a vector, in
/// standard deviations. Derivatives are numeric; step: small against what the unknowns move by.
template <int Count, class Misses>
class ChangedMisses {
  public:
    using Scalar = double;
    using Change = Eigen::Matrix<double, Count, 1>;
    using Slopes = Eigen::Matrix<double, Eigen::Dynamic, Count>;

    enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Count };

    ChangedMisses(Misses misses, double step)
        : m_misses(std::move(misses)), m_step(step), m_count(m_misses(Change::Zero()).size()) {}

    int NumResiduals() const { return static_cast<int>(m_count); }

    bool operator()(const double* change, double* misses, double* slopes) const {
        const Change at = Eigen::Map<const Change>(change);
        Eigen::Map<Eigen::VectorXd>(misses, m_count) = m_misses(at);
        if (slopes != nullptr) {
            Eigen::Map<Slopes>(slopes, m_count, Count) = slopesAt(at);
        }
        return true;
    }

    /// The change of least squares, from none at all.
    Change solved() const {
        ceres::TinySolver<ChangedMisses> solver;
        Change change = Change::Zero();
        solver.Solve(*this, &change);
        return change;
    }

    Slopes slopesAt(const Change& at) const {
        Slopes slopes(m_count, Count);
        for (int i = 0; i < Count; ++i) {
            const Change move = m_step * Change::Unit(i);
            slopes.col(i) = (m_misses(at + move) - m_misses(at - move)) / (2 * m_step);
        }
        return slopes;
    }

  private:
    Misses m_misses;
    double m_step;
    Eigen::Index m_count;
};

} // namespace spherewalk::align
