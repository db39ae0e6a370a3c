// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "refinement.h"

#include <Eigen/SparseCore>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace spherewalk::align {

/// Where each unknown stands in the vector of all that a model solves; -1: the model does not solve it.
/// Three numbers each, of a turn only the third in the model Yaw.
class Columns {
  public:
    Columns(const Unknowns& unknowns, Model model);

    int count() const { return m_count; }

    std::array<int, 3> turn(std::size_t photo) const { return m_turn[photo]; }

    std::array<int, 3> offset(std::size_t photo) const { return m_offset[photo]; }

    std::array<int, 3> placement(std::size_t rail) const { return m_placement[rail]; }

  private:
    std::array<int, 3> next();

    int m_count = 0;
    std::vector<std::array<int, 3>> m_turn;
    std::vector<std::array<int, 3>> m_offset;
    std::vector<std::array<int, 3>> m_placement;
};

/// A derivative by a pair's nine numbers (PairNormal's order) as one by the model's columns.
struct PairColumns {
    std::vector<int> column;                        ///< of each row of the chain
    Eigen::Matrix<double, Eigen::Dynamic, 9> chain; ///< the nine numbers by the columns, transposed
};

PairColumns pairColumns(const Columns& columns, const Unknowns& unknowns, const UsedPair& pair);

/// The priors' rows of a photo or a rail: columns, and how much each is held, 1 / sigma.
struct PriorRow {
    std::vector<int> column;
    std::vector<double> by;                ///< one a column, in standard deviations
    std::optional<std::size_t> offsetAxis; ///< if it holds a photo to its stop
};

std::vector<PriorRow> priorRows(const Columns& columns, const Unknowns& unknowns,
                                std::span<const PhotoPrior> priors, const RefinementOptions& options);

/// The normal matrix of the matches, times curvature, and of the priors.
Eigen::SparseMatrix<double> normalMatrix(const Columns& columns, const Unknowns& unknowns,
                                         std::span<const UsedPair> pairs,
                                         std::span<const Eigen::Matrix<double, 9, 9>> pairMatrices,
                                         std::span<const PriorRow> priors);

} // namespace spherewalk::align
