// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_geometry.h"
#include "solve/match_selection.h"

#include "spherewalk/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kLargestNoise = 8;

/// How far the inliers of a pair miss their planes, as a variance over what they state.
struct PairVariance {
    std::size_t a;
    std::size_t b;
    double variance;
};

double scaleOf(const PhotoPair& pair, const PairEstimate& estimate) {
    std::vector<double> residuals;
    for (std::size_t i = 0; i < pair.matches.size(); ++i) {
        const std::optional<UnitMatch> match =
            estimate.isInlier[i] ? unitMatch(pair.matches[i]) : std::nullopt;
        if (!match) {
            continue;
        }
        const EpipolarResidual residual = epipolarResidual(match->inA, estimate.aFromB * match->inB,
                                                           *estimate.baselineInA, match->sigmaRad);
        if (std::min(residual.sineA, residual.sineB) > kLeastSine) {
            residuals.push_back(residual.value);
        }
    }
    return agreeingScale(std::move(residuals), kLargestNoise);
}

std::vector<PairVariance> pairVariances(std::span<const PhotoPair> pairs,
                                        std::span<const PairEstimate> estimates) {
    std::vector<PairVariance> variances;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        // What a turn alone misses is parallax as well.
        if (estimates[i].verdict == PairVerdict::Constraint && estimates[i].baselineInA) {
            const double scale = scaleOf(pairs[i], estimates[i]);
            variances.push_back(
                {static_cast<std::size_t>(pairs[i].a), static_cast<std::size_t>(pairs[i].b), scale * scale});
        }
    }
    return variances;
}

} // namespace

std::vector<double> photoNoise(std::size_t photos, std::span<const PhotoPair> pairs,
                               std::span<const PairEstimate> estimates) {
    constexpr int kRounds = 20;
    constexpr double kLeastShare = 0.25; // Of the usual variance.
    const std::vector<PairVariance> variances = pairVariances(pairs, estimates);
    if (variances.empty()) {
        return std::vector<double>(photos, 1);
    }
    std::vector<double> all;
    for (const PairVariance& pair : variances) {
        all.push_back(pair.variance);
    }
    const double usual = median(std::move(all));
    std::vector<double> variance(photos, usual);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<std::vector<double>> said(photos);
        for (const PairVariance& pair : variances) {
            said[pair.a].push_back(2 * pair.variance - variance[pair.b]);
            said[pair.b].push_back(2 * pair.variance - variance[pair.a]);
        }
        for (std::size_t i = 0; i < photos; ++i) {
            const double own = said[i].empty() ? usual : median(std::move(said[i]));
            variance[i] = (variance[i] + std::max(own, kLeastShare * usual)) / 2;
        }
    }
    std::vector<double> noise;
    for (const double one : variance) {
        noise.push_back(std::sqrt(std::max(1.0, one / usual)));
    }
    return noise;
}

} // namespace spherewalk::align
