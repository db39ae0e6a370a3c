// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_fit.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

std::string_view name(PairVerdict verdict) {
    constexpr EnumNames<PairVerdict, 4> kNames{{{PairVerdict::Constraint, "constraint"},
                                                {PairVerdict::TooFew, "too_few"},
                                                {PairVerdict::TooNarrow, "too_narrow"},
                                                {PairVerdict::NoAgreement, "no_agreement"}}};
    return nameOf(kNames, verdict);
}

namespace {

constexpr double kLeastSpread = 0.02;     // A cone of about 11 degrees around its axis.
constexpr double kLargestSigmaRad = 0.03; // A less certain rotation is not worth having.
constexpr int kLeastMeasurable = 10;
constexpr double kRival = 0.7; // With this share of the best one's inliers a rival is as good.
// Probability that a chance match within the gate lies in one plane with a given baseline.
constexpr double kChance = 0.04;

Bearings usable(const PhotoPair& pair, const PairOptions& options) {
    Bearings bearings;
    bearings.leastSine = options.leastSine;
    for (std::size_t i = 0; i < pair.matches.size(); ++i) {
        if (const std::optional<UnitMatch> match = unitMatch(pair.matches[i])) {
            bearings.inA.push_back(match->inA);
            bearings.inB.push_back(match->inB);
            bearings.sigmaRad.push_back(match->sigmaRad);
            bearings.match.push_back(static_cast<int>(i));
        }
    }
    return bearings;
}

double spreadOf(const Bearings& bearings, const EpipolarFit& fit) {
    Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < bearings.inA.size(); ++i) {
        if (fit.isInlier[i]) {
            mean += Eigen::Matrix3d::Identity() - bearings.inA[i] * bearings.inA[i].transpose();
        }
    }
    mean /= std::max(1, fit.inliers);
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(mean, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

// Whether so many agree only because so many were asked.
bool isChance(const EpipolarFit& fit) {
    const double expected = kChance * std::max(fit.scale, 1.0) * fit.gated;
    return fit.inliers < 8 + expected + 4 * std::sqrt(expected);
}

// A mirror image shares its epipolar planes with the picture, but half of it lies behind. The smaller the
// agreeing part, the easier it is found among a mirror image's matches, and the more it must prove.
double leastForwardShare(const EpipolarFit& fit) {
    const double share = static_cast<double>(fit.inliers) / static_cast<double>(fit.isInlier.size());
    return std::clamp(0.9 - 0.6 * (share - 0.2), 0.75, 0.9);
}

bool isMirrored(const EpipolarFit& fit) {
    return fit.hasBaseline && fit.measurable >= kLeastMeasurable && fit.forwardShare < leastForwardShare(fit);
}

PairVerdict verdictOf(const EpipolarFit& fit, int rivalInliers, const PairEstimate& estimate,
                      const PairOptions& options) {
    if (fit.inliers < options.leastInliers) {
        return PairVerdict::TooFew;
    }
    if (estimate.inlierShare < options.leastShare || isChance(fit) || isMirrored(fit)) {
        return PairVerdict::NoAgreement;
    }
    const double variance =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(fit.rotationCovariance, Eigen::EigenvaluesOnly)
            .eigenvalues()[2];
    if (estimate.spread < kLeastSpread || !(variance < kLargestSigmaRad * kLargestSigmaRad)) {
        return PairVerdict::TooNarrow;
    }
    return rivalInliers > kRival * fit.inliers ? PairVerdict::NoAgreement : PairVerdict::Constraint;
}

constexpr double kClearShare = 0.6; // Where so many agree, nothing better is hidden.
constexpr double kSameMinimumRad = 0.05;
constexpr double kAnotherAnswerRad = 0.21;

/// The best fit of several starts, and how many matches a rival has that explains them otherwise.
class Fits {
  public:
    explicit Fits(const Bearings& bearings) : m_bearings(bearings) {}

    /// rivalRad: fits that are nearer to each other are no rivals.
    void start(const Eigen::Matrix3d& aFromB, double rivalRad) {
        EpipolarFit fit = refineEpipolar(m_bearings, aFromB);
        if (isMirrored(fit) && m_best.inliers > 0 && !isMirrored(m_best)) {
            return;
        }
        const bool isBetter =
            fit.inliers > m_best.inliers || (isMirrored(m_best) && !isMirrored(fit) && !isChance(fit));
        // Two starts may end in one minimum, which is no rival.
        const bool isSame = Eigen::AngleAxisd(fit.aFromB * m_best.aFromB.transpose()).angle() < rivalRad;
        EpipolarFit& other = isBetter ? m_best : fit;
        if (!isSame && !isMirrored(other)) {
            m_rivalInliers = std::max(m_rivalInliers, other.inliers);
        }
        if (isBetter) {
            m_best = std::move(fit);
        }
    }

    const EpipolarFit& best() const { return m_best; }

    int rivalInliers() const { return m_rivalInliers; }

  private:
    const Bearings& m_bearings;
    EpipolarFit m_best;
    int m_rivalInliers = 0;
};

Fits fitsOf(const Bearings& bearings, const Eigen::Quaterniond& levelA, const Eigen::Quaterniond& levelB) {
    Fits fits(bearings);
    double firstScore = 0;
    for (const RotationHypothesis& hypothesis : rotationHypotheses(bearings)) {
        firstScore = std::max(firstScore, hypothesis.score);
        if (hypothesis.score < 0.4 * firstScore) {
            break; // The hypotheses that follow have less.
        }
        fits.start(hypothesis.aFromB, kSameMinimumRad);
    }
    if (fits.best().inliers < kClearShare * bearings.count()) {
        for (const RotationHypothesis& hypothesis : levelHypotheses(bearings, levelA, levelB)) {
            fits.start(hypothesis.aFromB, kAnotherAnswerRad);
        }
    }
    return fits;
}

/// The turn that makes this photo level, as far as that is known.
Eigen::Quaterniond levelOf(int photo, const PairOptions& options) {
    const auto i = static_cast<std::size_t>(photo);
    return i < options.levelFromPhoto.size() ? options.levelFromPhoto[i] : Eigen::Quaterniond::Identity();
}

} // namespace

PairEstimate estimatePair(const PhotoPair& pair, const PairOptions& options) {
    PairEstimate estimate;
    estimate.a = pair.a;
    estimate.b = pair.b;
    estimate.isInlier.assign(pair.matches.size(), false);
    const Bearings bearings = usable(pair, options);
    if (bearings.count() < std::max(options.leastInliers, 6)) {
        return estimate;
    }
    const Fits fits = fitsOf(bearings, levelOf(pair.a, options), levelOf(pair.b, options));
    const EpipolarFit& fit = fits.best();
    if (fit.isInlier.empty()) {
        return estimate;
    }
    for (std::size_t i = 0; i < fit.isInlier.size(); ++i) {
        estimate.isInlier[static_cast<std::size_t>(bearings.match[i])] = fit.isInlier[i];
    }
    estimate.inliers = fit.inliers;
    estimate.inlierShare = static_cast<double>(fit.inliers) / bearings.count();
    estimate.spread = spreadOf(bearings, fit);
    estimate.aFromB = Eigen::Quaterniond(fit.aFromB).normalized();
    estimate.rotationCovariance = fit.rotationCovariance;
    estimate.parallaxRad = fit.parallaxRad;
    if (fit.hasBaseline && fit.measurable >= kLeastMeasurable) {
        estimate.baselineInA = fit.baselineInA;
        estimate.baselineSigmaRad = fit.baselineSigmaRad;
        estimate.forwardShare = fit.forwardShare;
    }
    estimate.verdict = verdictOf(fit, fits.rivalInliers(), estimate, options);
    return estimate;
}

std::vector<PairEstimate> estimatePairs(std::span<const PhotoPair> pairs, const PairOptions& options) {
    std::vector<PairEstimate> estimates(pairs.size());
    parallelFor(static_cast<int>(pairs.size()), 4, options.threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const auto at = static_cast<std::size_t>(i);
            estimates[at] = estimatePair(pairs[at], options);
        }
    });
    return estimates;
}

} // namespace spherewalk::align
