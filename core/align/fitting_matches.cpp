// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/fitting_matches.h"

#include "epipolar_residual.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

using Eigen::Vector3d;

namespace {

constexpr double kOnePlaceM = 0.01;
constexpr double kMostSigmas = 4;
/// What positions solved to a millimetre leave.
constexpr Degrees kPositionsSigma{0.02};

bool fits(const Vector3d& baselineM, const Vector3d& a, const Vector3d& b, double sigmaRad) {
    if (baselineM.norm() < kOnePlaceM) {
        return angleBetween(a, b).value() < kMostSigmas * sigmaRad;
    }
    const Vector3d direction = baselineM.normalized();
    // Along the baseline any plane fits.
    const EpipolarResidual residual = epipolarResidual(a, b, direction, sigmaRad);
    if (std::min(residual.sineA, residual.sineB) < kLeastSine) {
        return angleBetween(a, b).value() < kLeastSine;
    }
    return std::abs(residual.value) < kMostSigmas && parallaxOf(a, b, direction) > -kMostSigmas * sigmaRad;
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
            const double sigmaRad = std::hypot(match.sigmaRad, Radians(kPositionsSigma).value());
            list[i] = fits(baselineM, poseA->rotation * match.inA, poseB->rotation * match.inB, sigmaRad);
        }
    }
    return result;
}

} // namespace spherewalk::align
