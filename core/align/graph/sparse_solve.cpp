// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/sparse_solve.h"

#include <Eigen/SparseCholesky>

namespace spherewalk::align {

std::optional<Eigen::MatrixXd> solvedSparse(const Eigen::SparseMatrix<double>& matrix,
                                            const Eigen::MatrixXd& right) {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success) {
        return std::nullopt;
    }
    return Eigen::MatrixXd(factor.solve(right));
}

} // namespace spherewalk::align
