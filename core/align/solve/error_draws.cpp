// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/sparse_solve.h"
#include "pairs/pair_geometry.h"
#include "solve/pair_normal.h"
#include "solve/refinement.h"
#include "solve/solution_report.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/fixed_random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace spherewalk::align {

namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Draws = Eigen::MatrixXd;

constexpr std::array<int, 3> kNoColumns = {-1, -1, -1};

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
            const UpPrior up = upPrior(prior);
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

// The normal matrix of the matches and of the priors.
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

Draws normalDraws(Eigen::Index rows, FixedRandom& random) {
    Draws draws(rows, kBootstrapDraws);
    for (Eigen::Index column = 0; column < kBootstrapDraws; ++column) {
        for (Eigen::Index row = 0; row < rows; ++row) {
            draws(row, column) = random.sumNormal();
        }
    }
    return draws;
}

// Random errors of every photo's tilt and position, as far as the model does not solve them.
ErrorDraws unsolved(const Unknowns& unknowns, std::span<const PhotoPrior> priors, Model model) {
    const auto count = static_cast<Eigen::Index>(unknowns.photo.size());
    ErrorDraws made{Draws::Zero(3 * count, kBootstrapDraws), Draws::Zero(3 * count, kBootstrapDraws)};
    FixedRandom random(0x5EED0003);
    for (Eigen::Index i = 0; i < count; ++i) {
        const PhotoPrior& prior =
            priors[static_cast<std::size_t>(unknowns.photo[static_cast<std::size_t>(i)])];
        if (!solvesTilt(model)) {
            made.turn.middleRows(3 * i, 2) = upPrior(prior).sigmaRad * normalDraws(2, random);
        }
        if (!solvesPosition(model)) {
            made.position.middleRows(3 * i, 3) = offsetSigmasM(prior).asDiagonal() * normalDraws(3, random);
        }
    }
    return made;
}

// The scores of a pair's matches, and how they change with the pair's nine numbers.
struct PairScores {
    Matrix9d matrix = Matrix9d::Zero();
    Eigen::Matrix<double, 9, Eigen::Dynamic> scores;
    std::vector<int> track;
};

// The derivative of a score by its residual: less than 1 for a residual that the norm bounds. Matches of what
// is near, or of blurred photos, miss by more, and hold their photos less than their number says. What would
// be negative counts as 0, so that the normal matrix stays definite.
double scoreSlope(double residual, double width) {
    const double ratio = residual * residual / (width * width);
    return std::max(0.0, (1 - 3 * ratio) / ((1 + ratio) * (1 + ratio) * (1 + ratio)));
}

PairScores scoresOf(const UsedPair& pair, std::span<const PhotoState> states,
                    const RefinementOptions& options) {
    PairScores made;
    made.scores.resize(9, static_cast<Eigen::Index>(2 * pair.matches.size()));
    Eigen::Index count = 0;
    forEachRow(pair, states, [&](const UsedMatch& match, const MatchRow& row) {
        const double residual = row.residual / options.scale;
        const Bounded robust = bounded(residual, options.width);
        made.scores.col(count++) = (robust.value * robust.slope / options.scale) * row.by;
        const double slope = scoreSlope(residual, options.width) / (options.scale * options.scale);
        made.matrix += slope * row.by * row.by.transpose();
        made.track.push_back(match.track);
    });
    made.scores.conservativeResize(9, count);
    return made;
}

// One sign for each row and draw, equal within a track.
Draws signs(const std::vector<int>& track) {
    Draws made(static_cast<Eigen::Index>(track.size()), kBootstrapDraws);
    for (std::size_t row = 0; row < track.size(); ++row) {
        FixedRandom random(0x51604ULL + static_cast<std::uint64_t>(track[row]) * 0x9E3779B97F4A7C15ULL);
        std::uint64_t bits = 0;
        for (int column = 0; column < kBootstrapDraws; ++column) {
            if (column % 64 == 0) {
                bits = random.next();
            }
            made(static_cast<Eigen::Index>(row), column) = (bits >> (column % 64)) & 1 ? 1 : -1;
        }
    }
    return made;
}

// The ratio of the offsets found to their priors' deviations along each axis; 1 where there are not enough of
// them to tell.
Eigen::Vector3d offsetFactors(const Unknowns& unknowns, std::span<const PhotoPrior> priors, Model model) {
    const auto photos = static_cast<double>(unknowns.photo.size());
    const auto rails = static_cast<double>(unknowns.placement.size());
    // Common errors of the priors take up freedom: place, scale and heading; height and tilt; the rails.
    const Eigen::Vector3d freedom(photos - 2 - 1.5 * rails, photos - 2 - 1.5 * rails, photos - 3);
    if (!solvesPosition(model)) {
        return Eigen::Vector3d::Ones();
    }
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const Eigen::Map<const Eigen::Vector3d> offset(unknowns.offset[i].data());
        const Eigen::Vector3d sigmas = offsetSigmasM(priors[static_cast<std::size_t>(unknowns.photo[i])]);
        squares += offset.cwiseQuotient(sigmas).cwiseAbs2();
    }
    Eigen::Vector3d factors = Eigen::Vector3d::Ones();
    for (int axis = 0; axis < 3; ++axis) {
        if (freedom[axis] >= 5) {
            factors[axis] = std::clamp(std::sqrt(squares[axis] / freedom[axis]), 0.2, 3.0);
        }
    }
    return factors;
}

void addPriors(std::span<const PriorRow> rows, const Eigen::Vector3d& factors, Draws& right) {
    FixedRandom random(0x5EED0004);
    for (const PriorRow& row : rows) {
        const double factor = row.offsetAxis ? factors[static_cast<Eigen::Index>(*row.offsetAxis)] : 1;
        const Draws error = factor * normalDraws(1, random);
        for (std::size_t i = 0; i < row.column.size(); ++i) {
            right.row(row.column[i]) += row.by[i] * error;
        }
    }
}

struct Equations {
    Eigen::SparseMatrix<double> matrix;
    Draws right;
};

Equations equations(const Columns& columns, const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                    std::span<const UsedPair> pairs, const RefinementOptions& options,
                    const ErrorDraws& errors, const std::stop_token& stop) {
    const std::vector<PhotoState> states = unknowns.states();
    Draws right = Draws::Zero(columns.count(), kBootstrapDraws);
    std::vector<Matrix9d> matrices;
    for (const UsedPair& pair : pairs) {
        throwIfStopped(stop);
        const PairScores scores = scoresOf(pair, states, options);
        const Eigen::Matrix<double, 9, Eigen::Dynamic> sums = scores.scores * signs(scores.track);
        Eigen::Matrix<double, 9, Eigen::Dynamic> moved(9, kBootstrapDraws);
        moved.topRows<3>() = errors.turn.middleRows<3>(3 * pair.a);
        moved.middleRows<3>(3) = errors.turn.middleRows<3>(3 * pair.b);
        moved.bottomRows<3>() =
            errors.position.middleRows<3>(3 * pair.b) - errors.position.middleRows<3>(3 * pair.a);
        const PairColumns at = pairColumns(columns, unknowns, pair);
        const Draws scattered = at.chain * (sums + scores.matrix * moved);
        for (std::size_t row = 0; row < at.column.size(); ++row) {
            right.row(at.column[row]) += scattered.row(static_cast<Eigen::Index>(row));
        }
        matrices.push_back(scores.matrix);
    }
    const std::vector<PriorRow> rows = priorRows(columns, unknowns, priors, options);
    addPriors(rows, offsetFactors(unknowns, priors, options.model), right);
    return {normalMatrix(columns, unknowns, pairs, matrices, rows), std::move(right)};
}

} // namespace

ErrorDraws errorDraws(const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                      std::span<const UsedPair> pairs, const RefinementOptions& options,
                      const std::stop_token& stop) {
    const Columns columns(unknowns, options.model);
    const ErrorDraws errors = unsolved(unknowns, priors, options.model);
    const Equations system = equations(columns, unknowns, priors, pairs, options, errors, stop);
    throwIfStopped(stop);
    const std::optional<Eigen::MatrixXd> solution = solvedSparse(system.matrix, system.right);
    if (!solution) {
        throw Error(ErrorKind::Internal,
                    "The uncertainty of the alignment could not be computed. Please report it.");
    }
    const Draws& solved = *solution;
    const auto count = unknowns.photo.size();
    ErrorDraws made{errors.turn, errors.position};
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<Eigen::Index>(3 * i) + axis;
            if (const int column = columns.turn(i)[static_cast<std::size_t>(axis)]; column >= 0) {
                made.turn.row(row) = solved.row(column);
            }
            if (const int column = columns.offset(i)[static_cast<std::size_t>(axis)]; column >= 0) {
                made.position.row(row) = solved.row(column);
            }
        }
        if (unknowns.rail[i] >= 0 && solvesPlacement(options.model)) {
            const std::array<int, 3> at = columns.placement(static_cast<std::size_t>(unknowns.rail[i]));
            made.position.middleRows<3>(static_cast<Eigen::Index>(3 * i)) +=
                unknowns.positionByPlacement(i) * solved.middleRows<3>(at[0]);
        }
    }
    return made;
}

} // namespace spherewalk::align
