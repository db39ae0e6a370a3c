// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

#include <optional>

namespace spherewalk::align {

/// The solution of matrix * x = right, one column each. Empty if the matrix cannot be factored. Range: the
/// matrix is symmetric and definite; its lower half is read. Eigen's factorisation is compiled here alone,
/// since it takes seconds.
std::optional<Eigen::MatrixXd> solvedSparse(const Eigen::SparseMatrix<double>& matrix,
                                            const Eigen::MatrixXd& right);

} // namespace spherewalk::align
