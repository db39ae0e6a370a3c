// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/normal_equations.h"

#include <algorithm>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr std::array<int, 3> kNoColumns = {-1, -1, -1};

} // namespace

std::array<int, 3> Columns::next() {
    m_count += 3;
    return {m_count - 3, m_count - 2, m_count - 1};
}

Columns::Columns(const Unknowns& unknowns, Model model) {
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        m_turn.push_back(solvesTilt(model) ? next() : std::array<int, 3>{-1, -1, m_count++});
        m_offset.push_back(solvesPosition(model) ? next() : kNoColumns);
    }
    for (std::size_t i = 0; i < unknowns.placement.size(); ++i) {
        m_placement.push_back(solvesPlacement(model) ? next() : kNoColumns);
    }
}

PairColumns pairColumns(const Columns& columns, const Unknowns& unknowns, const UsedPair& pair) {
    PairColumns made;
    std::vector<Eigen::Matrix<double, 9, 1>> rows;
    const auto add = [&](const std::array<int, 3>& at, int from, const Eigen::Matrix3d& by) {
        for (int i = 0; i < 3; ++i) {
            const int column = at[static_cast<std::size_t>(i)];
            if (column < 0) {
                continue;
            }
            auto found = std::ranges::find(made.column, column);
            if (found == made.column.end()) {
                made.column.push_back(column);
                rows.emplace_back(Eigen::Matrix<double, 9, 1>::Zero());
                found = made.column.end() - 1;
            }
            rows[static_cast<std::size_t>(found - made.column.begin())].segment<3>(from) += by.col(i);
        }
    };
    const auto a = static_cast<std::size_t>(pair.a);
    const auto b = static_cast<std::size_t>(pair.b);
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    add(columns.turn(a), 0, one);
    add(columns.turn(b), 3, one);
    add(columns.offset(a), 6, -one);
    add(columns.offset(b), 6, one);
    if (unknowns.rail[a] >= 0) {
        add(columns.placement(static_cast<std::size_t>(unknowns.rail[a])), 6,
            -unknowns.positionByPlacement(a));
    }
    if (unknowns.rail[b] >= 0) {
        add(columns.placement(static_cast<std::size_t>(unknowns.rail[b])), 6,
            unknowns.positionByPlacement(b));
    }
    made.chain.resize(static_cast<Eigen::Index>(rows.size()), 9);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        made.chain.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
    }
    return made;
}

std::vector<PriorRow> priorRows(const Columns& columns, const Unknowns& unknowns,
                                std::span<const PhotoPrior> priors, const RefinementOptions& options) {
    std::vector<PriorRow> rows;
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const PhotoPrior& prior = priors[static_cast<std::size_t>(unknowns.photo[i])];
        const std::array<int, 3> turned = columns.turn(i);
        if (turned[0] >= 0) {
            const Vertical up = knownUp(prior);
            const Eigen::Matrix<double, 2, 3> by =
                leanOf(unknowns.reference[i] * up.upInPhoto).byTurn / up.sigmaRad;
            for (int axis = 0; axis < 2; ++axis) {
                rows.push_back({{turned.begin(), turned.end()}, {by(axis, 0), by(axis, 1), by(axis, 2)}, {}});
            }
        }
        const Eigen::Vector3d offsetSigmas = offsetSigmasM(prior);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int column = columns.offset(i)[axis];
            if (column >= 0) {
                rows.push_back({{column}, {1 / offsetSigmas[static_cast<Eigen::Index>(axis)]}, axis});
            }
        }
    }
    const std::array<double, 3> sigmas = {options.placementSigmaM, options.placementSigmaM,
                                          options.placementSigmaRad};
    for (std::size_t rail = 0; rail < unknowns.placement.size(); ++rail) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (columns.placement(rail)[i] >= 0) {
                rows.push_back(
                    {{columns.placement(rail)[i]}, {1 / std::max(sigmas[i], kLeastPlacementSigma)}, {}});
            }
        }
    }
    return rows;
}

std::vector<Eigen::Matrix<double, 9, 9>> matchMatrices(std::span<const UsedPair> pairs,
                                                       std::span<const PhotoState> states,
                                                       const RefinementOptions& options) {
    std::vector<Eigen::Matrix<double, 9, 9>> made;
    for (const UsedPair& pair : pairs) {
        const PairNormal normal =
            pairNormal(pair, states[static_cast<std::size_t>(pair.a)],
                       states[static_cast<std::size_t>(pair.b)], options.scale, options.width);
        made.emplace_back(normal.topLeftCorner<9, 9>());
    }
    return made;
}

Eigen::SparseMatrix<double> normalMatrix(const Columns& columns, const Unknowns& unknowns,
                                         std::span<const UsedPair> pairs,
                                         std::span<const Eigen::Matrix<double, 9, 9>> pairMatrices,
                                         std::span<const PriorRow> priors) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PairColumns at = pairColumns(columns, unknowns, pairs[i]);
        const Eigen::MatrixXd block = at.chain * pairMatrices[i] * at.chain.transpose();
        for (std::size_t row = 0; row < at.column.size(); ++row) {
            for (std::size_t column = 0; column < at.column.size(); ++column) {
                entries.emplace_back(
                    at.column[row], at.column[column],
                    block(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
            }
        }
    }
    for (const PriorRow& prior : priors) {
        for (std::size_t i = 0; i < prior.column.size(); ++i) {
            for (std::size_t j = 0; j < prior.column.size(); ++j) {
                entries.emplace_back(prior.column[i], prior.column[j], prior.by[i] * prior.by[j]);
            }
        }
    }
    for (int i = 0; i < columns.count(); ++i) {
        entries.emplace_back(i, i, 1e-9); // What nothing holds shall not stop the rest.
    }
    Eigen::SparseMatrix<double> matrix(columns.count(), columns.count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

void move(const Columns& columns, const Eigen::VectorXd& step, Unknowns& unknowns) {
    const auto add = [&](const std::array<int, 3>& at, Unknowns::Block& block) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            block[axis] += at[axis] < 0 ? 0 : step[at[axis]];
        }
    };
    unknowns.rebase(); // Turns add up about the room's axes where they are zero.
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        add(columns.turn(i), unknowns.turn[i]);
        add(columns.offset(i), unknowns.offset[i]);
    }
    for (std::size_t rail = 0; rail < unknowns.placement.size(); ++rail) {
        add(columns.placement(rail), unknowns.placement[rail]);
    }
    unknowns.rebase();
}

} // namespace spherewalk::align
