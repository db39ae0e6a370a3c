// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/pair_normal.h"

#include "pairs/pair_geometry.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

// judge() wants matches farther from the baseline (kMarginSine), so that none comes and goes as photos turn.
constexpr double kNoPlane = 0.02;

// The rows of a turn: both components of the distance in the tangent plane of a's bearing.
int turnRows(const UsedPair& pair, const UsedMatch& match, const PhotoState& a, const PhotoState& b,
             MatchRow rows[2]) {
    const Eigen::Vector3d inRoomB = b.roomFromPhoto * match.inB;
    // The tangent frame turns with the photo, so that the rows are smooth.
    const Eigen::Matrix<double, 3, 2> tangent = a.roomFromPhoto.toRotationMatrix() * tangentBasis(match.inA);
    const double scale =
        1 / std::sqrt(2 * match.sigmaRad * match.sigmaRad + pair.toleranceRad * pair.toleranceRad);
    for (int i = 0; i < 2; ++i) {
        const Eigen::Vector3d axis = tangent.col(i);
        rows[i].residual = scale * axis.dot(inRoomB);
        rows[i].by.setZero();
        rows[i].by.head<3>() = scale * axis.cross(inRoomB);
        rows[i].by.segment<3>(3) = scale * inRoomB.cross(axis);
    }
    return 2;
}

struct PairFrame {
    Eigen::Matrix3d roomFromA;
    Eigen::Matrix3d roomFromB;
    Eigen::Vector3d baselineM;
    Eigen::Vector3d aheadOfAM; ///< From the place of a to its front lens.
    Eigen::Vector3d aheadOfBM;
};

PairFrame pairFrameOf(const PhotoState& a, const PhotoState& b) {
    PairFrame frame{a.roomFromPhoto.toRotationMatrix(), b.roomFromPhoto.toRotationMatrix(),
                    b.positionM - a.positionM, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    frame.aheadOfAM = a.lenses.aheadM * frame.roomFromA.col(0);
    frame.aheadOfBM = b.lenses.aheadM * frame.roomFromB.col(0);
    return frame;
}

int planeRow(const UsedMatch& match, const PairFrame& frame, MatchRow& row) {
    const Eigen::Vector3d inRoomA = frame.roomFromA * match.inA;
    const Eigen::Vector3d inRoomB = frame.roomFromB * match.inB;
    const Eigen::Vector3d lensOfAM = softSide(match.inA) * frame.aheadOfAM;
    const Eigen::Vector3d lensOfBM = softSide(match.inB) * frame.aheadOfBM;
    Eigen::Vector3d direction = frame.baselineM + lensOfBM - lensOfAM;
    const double apartM = std::max(direction.norm(), 1e-6);
    direction /= apartM;
    const EpipolarResidual residual = epipolarResidual(inRoomA, inRoomB, direction, match.sigmaRad);
    if (std::min(residual.sineA, residual.sineB) < kNoPlane) {
        return 0;
    }
    const Eigen::Vector3d byBaseline =
        (residual.byBaseline - direction * direction.dot(residual.byBaseline)) / apartM;
    row.residual = residual.value;
    row.by.head<3>() = inRoomA.cross(residual.byA) - lensOfAM.cross(byBaseline);
    row.by.segment<3>(3) = inRoomB.cross(residual.byB) + lensOfBM.cross(byBaseline);
    row.by.tail<3>() = byBaseline;
    return 1;
}

} // namespace

double softSide(const Eigen::Vector3d& inPhoto) {
    constexpr double kFadeSine = 0.05; // three degrees to either side of the seam
    return std::clamp(inPhoto.x() / kFadeSine, -1.0, 1.0);
}

int matchRows(const UsedPair& pair, const UsedMatch& match, const PhotoState& a, const PhotoState& b,
              MatchRow rows[2]) {
    return pair.isTurn ? turnRows(pair, match, a, b, rows) : planeRow(match, pairFrameOf(a, b), rows[0]);
}

Bounded bounded(double residual, double width) {
    const double ratio = residual / width;
    const double root = 1 / std::sqrt(1 + ratio * ratio);
    return {residual * root, root * root * root};
}

PairNormal pairNormal(const UsedPair& pair, const PhotoState& a, const PhotoState& b, double scale,
                      double width) {
    const PairFrame frame = pairFrameOf(a, b);
    PairNormal normal = PairNormal::Zero();
    MatchRow rows[2];
    Eigen::Matrix<double, 10, 1> column;
    for (const UsedMatch& match : pair.matches) {
        const int count = pair.isTurn ? turnRows(pair, match, a, b, rows) : planeRow(match, frame, rows[0]);
        for (int i = 0; i < count; ++i) {
            const Bounded robust = bounded(rows[i].residual / scale, width);
            column.head<9>() = (robust.slope / scale) * rows[i].by;
            column[9] = robust.value;
            normal.selfadjointView<Eigen::Lower>().rankUpdate(column);
        }
    }
    return normal.selfadjointView<Eigen::Lower>();
}

double pairCost(const UsedPair& pair, const PhotoState& a, const PhotoState& b, double scale, double width) {
    const PairFrame frame = pairFrameOf(a, b);
    double sum = 0;
    MatchRow rows[2];
    for (const UsedMatch& match : pair.matches) {
        const int count = pair.isTurn ? turnRows(pair, match, a, b, rows) : planeRow(match, frame, rows[0]);
        for (int i = 0; i < count; ++i) {
            const double value = bounded(rows[i].residual / scale, width).value;
            sum += value * value;
        }
    }
    return sum;
}

} // namespace spherewalk::align
