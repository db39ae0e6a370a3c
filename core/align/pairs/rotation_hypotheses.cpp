// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_fit.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/base/fixed_random.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <span>

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

namespace {

constexpr int kLevelDraws = 600;      // One right match in six is enough: three right ones are drawn twice.
constexpr int kLevelScored = 200;     // Number of matches that score a hypothesis.
constexpr int kYaws = 18;             // Between two of these the volume of three planes has one root at most.
constexpr std::size_t kLevelKept = 3; // Number of hypotheses that are handed on.
constexpr double kWithin = 0.037;     // Planes are as wrong as levels: 2 degrees.
constexpr double kLeastCosine = 0.8;
constexpr double kLevelDistinctRad = 0.15;
constexpr double kStillRad = 0.01; // Lesser parallax tells nothing about what lies in front.

using Three = std::array<std::size_t, 3>;

/// The normals of the planes in which three matches moved, for one yaw of b against a.
std::array<Eigen::Vector3d, 3> planes(const Bearings& level, const Three& drawn, double yawRad) {
    const Eigen::Matrix3d turned = yawRotation(Radians(yawRad)).toRotationMatrix();
    std::array<Eigen::Vector3d, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) {
        normals[i] = (turned * level.inB[drawn[i]]).cross(level.inA[drawn[i]]);
    }
    return normals;
}

/// Zero where the three planes share a line, which is the baseline.
double volume(const Bearings& level, const Three& drawn, double yawRad) {
    const auto normals = planes(level, drawn, yawRad);
    return normals[0].cross(normals[1]).dot(normals[2]);
}

/// A root between two yaws whose volumes have opposite signs.
double rootBetween(const Bearings& level, const Three& drawn, double lowRad, double highRad) {
    const bool isNegative = volume(level, drawn, lowRad) < 0;
    for (int round = 0; round < 8; ++round) {
        const double middle = (lowRad + highRad) / 2;
        ((volume(level, drawn, middle) < 0) == isNegative ? lowRad : highRad) = middle;
    }
    return (lowRad + highRad) / 2;
}

/// The line that the planes share, the best of three.
Eigen::Vector3d lineOf(const std::array<Eigen::Vector3d, 3>& normals) {
    Eigen::Vector3d line = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d one = normals[i].cross(normals[(i + 1) % 3]);
        line = one.squaredNorm() > line.squaredNorm() ? one : line;
    }
    return line;
}

/// The share of the matches looked at that lie in a plane with the baseline and in front, the nearer the
/// more.
double score(const Bearings& level, std::span<const int> looked, const Eigen::Matrix3d& aFromB,
             const Eigen::Vector3d& baseline) {
    double ahead = 0;
    double behind = 0;
    for (const int at : looked) {
        const auto i = static_cast<std::size_t>(at);
        const Eigen::Vector3d& inA = level.inA[i];
        const Eigen::Vector3d turnedB = aFromB * level.inB[i];
        if (inA.dot(turnedB) < kLeastCosine) {
            continue;
        }
        const EpipolarResidual residual = epipolarResidual(inA, turnedB, baseline, kWithin);
        const double agreement = 1 - residual.value * residual.value;
        if (agreement > 0) {
            const double parallax = parallaxOf(inA, turnedB, baseline);
            ahead += parallax > -kStillRad ? agreement : 0;
            behind += parallax < kStillRad ? agreement : 0;
        }
    }
    return std::max(ahead, behind) / static_cast<double>(looked.size());
}

void tryThree(const Bearings& level, std::span<const int> looked, const Three& drawn,
              std::vector<RotationHypothesis>& found) {
    constexpr double kStepRad = 2 * std::numbers::pi / kYaws;
    double before = volume(level, drawn, 0);
    for (int step = 1; step <= kYaws; ++step) {
        const double here = volume(level, drawn, step * kStepRad);
        if (before * here < 0) {
            const double yawRad = rootBetween(level, drawn, (step - 1) * kStepRad, step * kStepRad);
            const Eigen::Vector3d line = lineOf(planes(level, drawn, yawRad));
            if (line.norm() > 1e-6) {
                const Eigen::Matrix3d aFromB = yawRotation(Radians(yawRad)).toRotationMatrix();
                found.push_back({aFromB, score(level, looked, aFromB, line.normalized())});
            }
        }
        before = here;
    }
}

std::vector<RotationHypothesis> bestOf(std::vector<RotationHypothesis> found) {
    std::ranges::stable_sort(found, std::greater<>(), &RotationHypothesis::score);
    std::vector<RotationHypothesis> kept;
    for (const RotationHypothesis& one : found) {
        const bool isNew = std::ranges::none_of(kept, [&](const RotationHypothesis& other) {
            return Eigen::AngleAxisd(one.aFromB * other.aFromB.transpose()).angle() < kLevelDistinctRad;
        });
        if (isNew && kept.size() < kLevelKept) {
            kept.push_back(one);
        }
    }
    return kept;
}

} // namespace

std::vector<RotationHypothesis> levelHypotheses(const Bearings& bearings, const Eigen::Quaterniond& levelA,
                                                const Eigen::Quaterniond& levelB) {
    if (bearings.count() < 6) {
        return {};
    }
    Bearings level = bearings;
    for (Eigen::Vector3d& bearing : level.inA) {
        bearing = levelA * bearing;
    }
    for (Eigen::Vector3d& bearing : level.inB) {
        bearing = levelB * bearing;
    }
    FixedRandom random(0x5EED0003);
    std::vector<int> looked = random.permutation(bearings.count());
    looked.resize(std::min<std::size_t>(looked.size(), kLevelScored));
    std::vector<RotationHypothesis> found;
    const auto count = static_cast<std::size_t>(bearings.count());
    for (int draw = 0; draw < kLevelDraws; ++draw) {
        const Three drawn = {random.below(count), random.below(count), random.below(count)};
        if (drawn[0] != drawn[1] && drawn[0] != drawn[2] && drawn[1] != drawn[2]) {
            tryThree(level, looked, drawn, found);
        }
    }
    std::vector<RotationHypothesis> best = bestOf(std::move(found));
    for (RotationHypothesis& one : best) {
        one.aFromB = (levelA.inverse() * Eigen::Quaterniond(one.aFromB) * levelB).toRotationMatrix();
    }
    return best;
}

} // namespace spherewalk::align
