// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair_block.h"

#include "so3.h"

#include "spherewalk/base/parallel.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::align {

namespace {

// A matrix whose product with itself, transposed, is this semidefinite one.
PairNormal rootOf(const PairNormal& normal) {
    const Eigen::LDLT<PairNormal> factor(normal);
    const Eigen::Matrix<double, 10, 1> roots = factor.vectorD().cwiseMax(0).cwiseSqrt();
    PairNormal root = factor.transpositionsP() * PairNormal::Identity();
    root = (factor.matrixU() * root).eval();
    root = (roots.asDiagonal() * root).eval();
    return root;
}

} // namespace

PairEvaluation::PairEvaluation(const Unknowns& unknowns, std::span<const UsedPair> pairs, double scale,
                               double width, int threads, std::stop_token stop)
    : m_unknowns(unknowns),
      m_pairs(pairs),
      m_scale(scale),
      m_width(width),
      m_threads(threads),
      m_stop(std::move(stop)),
      m_normals(pairs.size()),
      m_costs(pairs.size()) {
}

void PairEvaluation::PrepareForEvaluation(bool withDerivatives, bool isNewPoint) {
    if (!isNewPoint && !withDerivatives) {
        return;
    }
    const std::vector<PhotoState> states = m_unknowns.states();
    parallelFor(static_cast<int>(m_pairs.size()), 16, m_threads, [&](int begin, int end) {
        for (int at = begin; at < end && !m_stop.stop_requested(); ++at) {
            const auto i = static_cast<std::size_t>(at);
            const UsedPair& pair = m_pairs[i];
            const PhotoState& a = states[static_cast<std::size_t>(pair.a)];
            const PhotoState& b = states[static_cast<std::size_t>(pair.b)];
            if (withDerivatives) {
                m_normals[i] = pairNormal(pair, a, b, m_scale, m_width);
                m_costs[i] = m_normals[i](9, 9);
            } else {
                m_costs[i] = pairCost(pair, a, b, m_scale, m_width);
            }
        }
    });
}

PairBlock::PairBlock(const PairEvaluation& evaluation, std::size_t index, const UsedPair& pair, Model model)
    : m_evaluation(evaluation),
      m_index(index),
      m_a(static_cast<std::size_t>(pair.a)),
      m_b(static_cast<std::size_t>(pair.b)) {
    set_num_residuals(10);
    using Kind = Moved::Kind;
    m_moved = {{Kind::Turn, true, false}, {Kind::Turn, false, true}};
    const std::vector<int>& rail = evaluation.unknowns().rail;
    if (solvesPlacement(model)) {
        if (rail[m_a] >= 0) {
            m_moved.push_back({Kind::Placement, true, rail[m_a] == rail[m_b]});
        }
        if (rail[m_b] >= 0 && rail[m_a] != rail[m_b]) {
            m_moved.push_back({Kind::Placement, false, true});
        }
    }
    if (solvesPosition(model)) {
        m_moved.push_back({Kind::Offset, true, false});
        m_moved.push_back({Kind::Offset, false, true});
    }
    mutable_parameter_block_sizes()->assign(m_moved.size(), 3);
}

std::vector<double*> PairBlock::parameters(Unknowns& unknowns, const UsedPair& pair, Model model) {
    const auto a = static_cast<std::size_t>(pair.a);
    const auto b = static_cast<std::size_t>(pair.b);
    std::vector<double*> blocks = {unknowns.turn[a].data(), unknowns.turn[b].data()};
    if (solvesPlacement(model)) {
        for (const int rail : {unknowns.rail[a], unknowns.rail[b]}) {
            double* block = rail < 0 ? nullptr : unknowns.placement[static_cast<std::size_t>(rail)].data();
            if (block != nullptr && std::ranges::find(blocks, block) == blocks.end()) {
                blocks.push_back(block);
            }
        }
    }
    if (solvesPosition(model)) {
        blocks.push_back(unknowns.offset[a].data());
        blocks.push_back(unknowns.offset[b].data());
    }
    return blocks;
}

PairBlock::Rows PairBlock::rowsBy(const Moved& moved, const double* parameter, const PairNormal& root) const {
    if (moved.kind == Moved::Kind::Turn) {
        const Eigen::Matrix3d inner = leftJacobian(Eigen::Map<const Eigen::Vector3d>(parameter));
        return root.middleCols<3>(moved.isA ? 0 : 3) * inner;
    }
    Eigen::Matrix3d baselineBy = Eigen::Matrix3d::Zero();
    if (moved.kind == Moved::Kind::Offset) {
        baselineBy = Eigen::Matrix3d::Identity() * (moved.isB ? 1 : -1);
    } else {
        if (moved.isB) {
            baselineBy += m_evaluation.unknowns().positionByPlacement(m_b);
        }
        if (moved.isA) {
            baselineBy -= m_evaluation.unknowns().positionByPlacement(m_a);
        }
    }
    return root.middleCols<3>(6) * baselineBy;
}

bool PairBlock::Evaluate(const double* const* parameters, double* residuals, double** jacobians) const {
    if (m_evaluation.isStopped()) {
        return false;
    }
    Eigen::Map<Eigen::Matrix<double, 10, 1>> value(residuals);
    if (jacobians == nullptr) {
        value.setZero();
        value[0] = std::sqrt(m_evaluation.cost(m_index));
        return true;
    }
    const PairNormal root = rootOf(m_evaluation.normal(m_index));
    value = root.col(9);
    for (std::size_t i = 0; i < m_moved.size(); ++i) {
        if (jacobians[i] != nullptr) {
            Eigen::Map<Rows> rows(jacobians[i]);
            rows = rowsBy(m_moved[i], parameters[i], root);
        }
    }
    return true;
}

} // namespace spherewalk::align
