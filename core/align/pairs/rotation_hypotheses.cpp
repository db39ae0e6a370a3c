// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_fit.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/base/fixed_random.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spherewalk::align {

namespace {

constexpr int kDrawnPairs = 1200;
constexpr int kScored = 256;         // Number of matches that score a hypothesis.
constexpr std::size_t kRefined = 16; // Number of hypotheses that are refined.
constexpr std::size_t kKept = 4;
constexpr double kParallaxRad = 0.26; // Parallax of 0.5 m at 2 m.
constexpr double kDistinctRad = 0.21;
const double kWidestChord = 1 - std::cos(kParallaxRad);

// How far a match agrees: 1 is wholly, 0 is beyond the tolerance.
double agreement(const Eigen::Vector3d& inA, const Eigen::Vector3d& turnedB) {
    return std::max(0.0, 1 - (1 - inA.dot(turnedB)) / kWidestChord);
}

// The frame of two directions, which treats both alike.
Eigen::Matrix3d frameOfTwo(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    Eigen::Matrix3d frame;
    frame.col(0) = (u + v).normalized();
    frame.col(1) = (u - v).normalized();
    frame.col(2) = frame.col(0).cross(frame.col(1));
    return frame;
}

std::optional<Eigen::Matrix3d> rotationOfTwo(const Bearings& bearings, std::size_t i, std::size_t j,
                                             double leastAngle) {
    const double angleA = std::acos(std::clamp(bearings.inA[i].dot(bearings.inA[j]), -1.0, 1.0));
    const double angleB = std::acos(std::clamp(bearings.inB[i].dot(bearings.inB[j]), -1.0, 1.0));
    if (std::min(angleA, angleB) < leastAngle || std::max(angleA, angleB) > M_PI - 0.3 ||
        std::abs(angleA - angleB) > std::min(kParallaxRad, angleA)) {
        return std::nullopt;
    }
    return frameOfTwo(bearings.inA[i], bearings.inA[j]) *
           frameOfTwo(bearings.inB[i], bearings.inB[j]).transpose();
}

double score(const Bearings& bearings, const std::vector<int>& looked, const Eigen::Matrix3d& aFromB) {
    double sum = 0;
    for (const int at : looked) {
        const auto i = static_cast<std::size_t>(at);
        sum += agreement(bearings.inA[i], aFromB * bearings.inB[i]);
    }
    return sum / static_cast<double>(looked.size());
}

// The rotation of least squares over the matches that agree, found in a few rounds.
RotationHypothesis refined(const Bearings& bearings, const std::vector<int>& looked, Eigen::Matrix3d aFromB) {
    for (int round = 0; round < 5; ++round) {
        Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
        for (const int at : looked) {
            const auto i = static_cast<std::size_t>(at);
            moment += agreement(bearings.inA[i], aFromB * bearings.inB[i]) * bearings.inA[i] *
                      bearings.inB[i].transpose();
        }
        aFromB = bestRotation(moment);
    }
    return {aFromB, score(bearings, looked, aFromB)};
}

void drawHypotheses(const Bearings& bearings, const std::vector<int>& looked, double leastAngle,
                    FixedRandom& random, std::vector<RotationHypothesis>& found) {
    const auto count = static_cast<std::size_t>(bearings.count());
    for (int draw = 0; draw < kDrawnPairs; ++draw) {
        const std::size_t i = random.below(count);
        const std::size_t j = random.below(count);
        if (i == j) {
            continue;
        }
        if (const auto aFromB = rotationOfTwo(bearings, i, j, leastAngle)) {
            found.push_back({*aFromB, score(bearings, looked, *aFromB)});
        }
    }
}

bool scoresMore(const RotationHypothesis& one, const RotationHypothesis& other) {
    return one.score > other.score;
}

double angleOf(const Eigen::Matrix3d& rotation) {
    return std::acos(std::clamp((rotation.trace() - 1) / 2, -1.0, 1.0));
}

std::vector<RotationHypothesis> distinct(const std::vector<RotationHypothesis>& sorted) {
    std::vector<RotationHypothesis> kept;
    for (const RotationHypothesis& one : sorted) {
        const bool isNew = std::ranges::none_of(kept, [&](const RotationHypothesis& other) {
            return angleOf(one.aFromB * other.aFromB.transpose()) < kDistinctRad;
        });
        if (isNew && kept.size() < kKept) {
            kept.push_back(one);
        }
    }
    return kept;
}

} // namespace

std::vector<RotationHypothesis> rotationHypotheses(const Bearings& bearings) {
    if (bearings.count() < 2) {
        return {};
    }
    FixedRandom random(0x5EED0001);
    std::vector<int> looked = random.permutation(bearings.count());
    looked.resize(std::min<std::size_t>(looked.size(), kScored));
    std::vector<RotationHypothesis> found;
    drawHypotheses(bearings, looked, 0.3, random, found);
    if (found.size() < kRefined) { // Perhaps all lie in one direction; the verdict must be able to say so.
        drawHypotheses(bearings, looked, 0.02, random, found);
    }
    std::ranges::stable_sort(found, scoresMore);
    // They must differ before and after: refinement brings neighbours together and would leave one peak
    // alone.
    std::vector<RotationHypothesis> candidates(
        found.begin(), found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), kRefined)));
    for (const RotationHypothesis& other : distinct(found)) {
        candidates.push_back(other);
    }
    for (RotationHypothesis& candidate : candidates) {
        candidate = refined(bearings, looked, candidate.aFromB);
    }
    std::ranges::stable_sort(candidates, scoresMore);
    return distinct(candidates);
}

} // namespace spherewalk::align
