// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/fitting_matches.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

using Eigen::Vector3d;

namespace {

constexpr double kOnePlaceM = 0.01;
constexpr double kMostSigmas = 4;
/// What positions solved to a few millimetres leave.
constexpr Degrees kLeastTolerance{0.1};

/// The signed angle of the bearings' mean plane: how far b lies out of the plane of the baseline and a.
double outOfPlane(const Vector3d& baseline, const Vector3d& a, const Vector3d& b) {
    const Vector3d normal = baseline.cross(Vector3d(a + b));
    const double length = normal.norm();
    // Along the baseline any plane fits.
    return length < 1e-9 ? 0 : baseline.dot(a.cross(b)) / length;
}

bool fits(const Vector3d& baselineM, const Vector3d& a, const Vector3d& b, double toleranceRad) {
    if (baselineM.norm() < kOnePlaceM) {
        return angleBetween(a, b).value() < toleranceRad;
    }
    if (std::abs(outOfPlane(baselineM.normalized(), a, b)) > toleranceRad) {
        return false;
    }
    // In front of both: seen from b, the thing has moved away from the direction in which b lies.
    const Vector3d turn = a.cross(b);
    return turn.norm() < toleranceRad ||
           (baselineM.cross(b).dot(turn) > 0 && baselineM.cross(a).dot(turn) > 0);
}

} // namespace

std::vector<std::vector<bool>> fittingMatches(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                              std::span<const PhotoPair> pairs) {
    std::vector<std::vector<bool>> result;
    result.reserve(pairs.size());
    for (const PhotoPair& pair : pairs) {
        std::vector<bool>& list = result.emplace_back(pair.matches.size(), false);
        const auto& poseA = roomFromPhoto[static_cast<std::size_t>(pair.a)];
        const auto& poseB = roomFromPhoto[static_cast<std::size_t>(pair.b)];
        if (!poseA || !poseB) {
            continue;
        }
        const Vector3d baselineM = poseB->translation - poseA->translation;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Correspondence& match = pair.matches[i];
            const double tolerance =
                std::max(Radians(kLeastTolerance).value(), kMostSigmas * std::sqrt(2.0) * match.sigmaRad);
            list[i] = fits(baselineM, poseA->rotation * match.inA, poseB->rotation * match.inB, tolerance);
        }
    }
    return result;
}

} // namespace spherewalk::align
