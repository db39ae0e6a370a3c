// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_heading.h"

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::align {

namespace {

constexpr int kBins = 180;
constexpr int kReach = 3;          ///< bins to either side that a vote spreads over
constexpr int kApart = 5;          ///< bins that two peaks lie apart, at least
constexpr double kPeakShare = 0.4; ///< of the highest
constexpr std::size_t kMostPeaks = 3;
constexpr double kLevelSigmaRad = 0.01;
constexpr int kRefinements = 4;

Eigen::Vector3d between(const PositionEvidence& evidence, const Baseline& baseline) {
    const std::vector<Eigen::Vector3d>& positionsM = evidence.positionsM();
    return positionsM[static_cast<std::size_t>(baseline.b)] -
           positionsM[static_cast<std::size_t>(baseline.a)];
}

bool tellsHeading(const Eigen::Vector3d& direction) {
    return direction.head<2>().norm() > 0.3 * direction.norm() && direction.norm() > 0.02;
}

int wrappedBin(int bin) {
    return (bin % kBins + kBins) % kBins;
}

using Votes = std::array<double, kBins>;

Votes headingVotes(const PositionEvidence& evidence, const Eigen::Quaterniond& upright) {
    Votes votes = {};
    for (const Baseline& baseline : evidence.baselines()) {
        const Eigen::Vector3d inRoom = between(evidence, baseline);
        const Eigen::Vector3d seen = upright * baseline.inPart;
        if (!baseline.hasDirection || !tellsHeading(inRoom) || !tellsHeading(seen)) {
            continue;
        }
        const double turn = std::atan2(inRoom.y(), inRoom.x()) - std::atan2(seen.y(), seen.x());
        const int bin = static_cast<int>(std::floor(turn / (2 * EIGEN_PI) * kBins));
        for (int off = -kReach; off <= kReach; ++off) {
            votes[static_cast<std::size_t>(wrappedBin(bin + off))] += 1. / (1 + std::abs(off));
        }
    }
    return votes;
}

bool isPeak(const Votes& votes, int bin) {
    for (int off = -kApart; off <= kApart; ++off) {
        const double other = votes[static_cast<std::size_t>(wrappedBin(bin + off))];
        const double own = votes[static_cast<std::size_t>(bin)];
        if (other > own || (other == own && off < 0)) {
            return false;
        }
    }
    return true;
}

/// The rotation that brings the weighted directions together best (Wahba's problem).
Eigen::Quaterniond bestRotation(const Eigen::Matrix3d& roomTimesPart) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(roomTimesPart, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1);
    return Eigen::Quaterniond(
        Eigen::Matrix3d(svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose()));
}

} // namespace

Eigen::Vector3d upInPart(std::span<const PhotoPrior> photos, const RoughRotations& rotations, int part) {
    std::vector<Eigen::Vector3d> ups;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (rotations.part[i] == part) {
            const Eigen::Quaterniond level =
                photos[i].levelFromPhoto.value_or(Eigen::Quaterniond::Identity());
            ups.emplace_back(rotations.partFromPhoto[i] * (level.conjugate() * Eigen::Vector3d::UnitZ()));
            sum += ups.back().allFinite() ? ups.back() : Eigen::Vector3d::Zero();
        }
    }
    for (int round = 0; round < 10; ++round) { // Weiszfeld's: the median direction
        const Eigen::Vector3d mean = sum.stableNormalized();
        sum.setZero();
        for (const Eigen::Vector3d& up : ups) {
            if (up.allFinite()) {
                sum += up / std::max(0.005, (up - mean).norm());
            }
        }
    }
    return sum.norm() > 0 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::UnitZ();
}

std::vector<Eigen::Quaterniond> likelyHeadings(const PositionEvidence& evidence, const Eigen::Vector3d& up) {
    const Eigen::Quaterniond upright = Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ());
    const Votes votes = headingVotes(evidence, upright);
    const double highest = *std::ranges::max_element(votes);
    std::vector<int> peaks;
    for (int bin = 0; bin < kBins; ++bin) {
        if (highest > 0 && votes[static_cast<std::size_t>(bin)] >= kPeakShare * highest &&
            isPeak(votes, bin)) {
            peaks.push_back(bin);
        }
    }
    std::ranges::stable_sort(peaks, std::greater(),
                             [&](int bin) { return votes[static_cast<std::size_t>(bin)]; });
    peaks.resize(std::min(peaks.size(), kMostPeaks));
    std::vector<Eigen::Quaterniond> headings;
    headings.reserve(peaks.size());
    for (const int bin : peaks) {
        headings.push_back(yawRotation(Radians((bin + 0.5) * 2 * EIGEN_PI / kBins)) * upright);
    }
    return headings;
}

Eigen::Quaterniond refinedHeading(const PositionEvidence& evidence, const Eigen::Vector3d& up) {
    PositionEvidence turned = evidence;
    for (int round = 0; round < kRefinements; ++round) {
        // That the photos are level holds the turn about the stations' common line.
        Eigen::Matrix3d roomTimesPart =
            Eigen::Vector3d::UnitZ() * up.transpose() / (kLevelSigmaRad * kLevelSigmaRad);
        for (const Baseline& baseline : turned.baselines()) {
            const Eigen::Vector3d inRoom = between(turned, baseline);
            const double ratio = turned.misfit(baseline);
            if (baseline.hasDirection && inRoom.norm() > 0.02) {
                const double loss = 1 + ratio * ratio / 9;
                const double weight = 1 / (baseline.sigmaRad * baseline.sigmaRad * loss * loss);
                roomTimesPart += weight * inRoom.normalized() * baseline.inPart.transpose();
            }
        }
        turned.turn(bestRotation(roomTimesPart));
    }
    return turned.roomFromPart();
}

} // namespace spherewalk::align
