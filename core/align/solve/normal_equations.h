// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solve/refinement.h"

#include <Eigen/SparseCore>

#include <array>
#include <optional>
#include <vector>

namespace spherewalk::align {

/// The place of each unknown in the vector that a model solves; -1 if the model does not solve it. Each has
/// three numbers; the model Yaw solves only the third of a turn.
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

/// Turns a derivative by a pair's nine numbers (PairNormal's order) into one by the model's columns.
struct PairColumns {
    std::vector<int> column;                        ///< Of each row of the chain.
    Eigen::Matrix<double, Eigen::Dynamic, 9> chain; ///< The nine numbers by the columns, transposed.
};

/// One row that a prior adds: its columns, and the derivative by each, in standard deviations.
struct PriorRow {
    std::vector<int> column;
    std::vector<double> by;                ///< One a column.
    std::optional<std::size_t> offsetAxis; ///< Set if it holds a photo to its stop.
};

PairColumns pairColumns(const Columns& columns, const Unknowns& unknowns, const UsedPair& pair);

std::vector<PriorRow> priorRows(const Columns& columns, const Unknowns& unknowns,
                                std::span<const PhotoPrior> priors, const RefinementOptions& options);

/// What the matches of each pair know of its nine numbers, as least squares count them: pairNormal() without
/// its last row and column.
std::vector<Eigen::Matrix<double, 9, 9>> matchMatrices(std::span<const UsedPair> pairs,
                                                       std::span<const PhotoState> states,
                                                       const RefinementOptions& options);

/// The normal matrix of the matches and of the priors. pairMatrices: one a pair, by its nine numbers.
Eigen::SparseMatrix<double> normalMatrix(const Columns& columns, const Unknowns& unknowns,
                                         std::span<const UsedPair> pairs,
                                         std::span<const Eigen::Matrix<double, 9, 9>> pairMatrices,
                                         std::span<const PriorRow> priors);

/// Moves the unknowns by a step of the equations. Shape: as many numbers as there are columns.
void move(const Columns& columns, const Eigen::VectorXd& step, Unknowns& unknowns);

} // namespace spherewalk::align
