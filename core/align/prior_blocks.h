// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <ceres/sized_cost_function.h>

namespace spherewalk::align {

/// Holds a photo upright: where the vector that it calls up points, seen from above, in standard deviations.
/// Parameters: the photo's turn from its reference.
class UprightBlock : public ceres::SizedCostFunction<2, 3> {
  public:
    UprightBlock(const Eigen::Quaterniond& reference, const Eigen::Vector3d& upInPhoto, double sigmaRad);

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override;

  private:
    Eigen::Vector3d m_up; ///< turned by the reference
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

} // namespace spherewalk::align
