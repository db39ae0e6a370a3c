// SPDX-License-Identifier: GPL-3.0-or-later
#include "prior_blocks.h"

#include "so3.h"

namespace spherewalk::align {

UprightBlock::UprightBlock(const Eigen::Quaterniond& reference, const Eigen::Vector3d& upInPhoto,
                           double sigmaRad)
    : m_up(reference * upInPhoto), m_sigmaRad(sigmaRad) {
}

bool UprightBlock::Evaluate(const double* const* parameters, double* residuals, double** jacobians) const {
    const Eigen::Vector3d moved = Eigen::Map<const Eigen::Vector3d>(parameters[0]);
    const Eigen::Vector3d up = turn(moved) * m_up;
    Eigen::Map<Eigen::Vector2d> leaning(residuals);
    leaning = up.head<2>() / m_sigmaRad;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
        const Eigen::Matrix3d by = -skew(up) * leftJacobian(moved);
        Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>> rows(jacobians[0]);
        rows = by.topRows<2>() / m_sigmaRad;
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

} // namespace spherewalk::align
