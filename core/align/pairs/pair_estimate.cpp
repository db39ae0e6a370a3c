// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_fit.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

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
    bearings.reach = options.reach;
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

/// The way to a neighbour in both photos, as unit vectors.
struct Edge {
    Eigen::Vector3d inA;
    Eigen::Vector3d inB;
};

std::vector<Edge> edgesFrom(const Bearings& bearings, std::span<const std::size_t> inliers, std::size_t from,
                            std::size_t most) {
    constexpr double kLeastRad = 0.02; // Descriptors of one thing lie nearer.
    constexpr double kReachRad = 0.5;
    std::vector<std::pair<double, std::size_t>> near;
    for (const std::size_t other : inliers) {
        const double inA = (bearings.inA[other] - bearings.inA[from]).norm();
        const double inB = (bearings.inB[other] - bearings.inB[from]).norm();
        if (std::min(inA, inB) > kLeastRad && inA < kReachRad && inB < 2 * kReachRad) {
            near.emplace_back(inA, other);
        }
    }
    const std::size_t count = std::min(near.size(), most);
    std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < count; ++i) {
        edges.push_back({(bearings.inA[near[i].second] - bearings.inA[from]).normalized(),
                         (bearings.inB[near[i].second] - bearings.inB[from]).normalized()});
    }
    return edges;
}

// The share of neighbouring inliers, three by three, whose order around is the same in both photos, and their
// number. A camera that moves hardly changes it; chance changes half of it, and a mirror all.
std::pair<double, int> keptOrder(const Bearings& bearings, const EpipolarFit& fit) {
    constexpr std::size_t kAsked = 200; // Number of inliers whose neighbours are looked at.
    constexpr std::size_t kNeighbours = 8;
    constexpr double kLeastSineBetween = 0.3; // Three that lie in a line have no order.
    std::vector<std::size_t> inliers;
    for (std::size_t i = 0; i < fit.isInlier.size(); ++i) {
        if (fit.isInlier[i]) {
            inliers.push_back(i);
        }
    }
    int kept = 0;
    int asked = 0;
    for (std::size_t at = 0; at < inliers.size(); at += 1 + inliers.size() / kAsked) {
        const std::vector<Edge> edges = edgesFrom(bearings, inliers, inliers[at], kNeighbours);
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = i + 1; j < edges.size(); ++j) {
                const double inA = bearings.inA[inliers[at]].dot(edges[i].inA.cross(edges[j].inA));
                const double inB = bearings.inB[inliers[at]].dot(edges[i].inB.cross(edges[j].inB));
                if (std::min(std::abs(inA), std::abs(inB)) > kLeastSineBetween) {
                    ++asked;
                    kept += inA * inB > 0 ? 1 : 0;
                }
            }
        }
    }
    return {asked > 0 ? static_cast<double>(kept) / asked : 0, asked};
}

bool keepsNoOrder(const Bearings& bearings, const EpipolarFit& fit) {
    constexpr double kLeastKept = 0.9; // Real photos mostly keep 0.98 and more.
    constexpr int kLeastAsked = 20;
    const auto [share, asked] = keptOrder(bearings, fit);
    return asked >= kLeastAsked && share < kLeastKept;
}

constexpr double kClearShare = 0.6; // Where so many agree, nothing better is hidden.
constexpr double kSameMinimumRad = 0.05;
constexpr double kAnotherAnswerRad = 0.21;

/// A fit, and how far another one is turned against it at least that is no part of the same minimum.
struct Candidate {
    EpipolarFit fit;
    double distinctRad = kSameMinimumRad;
};

struct Choice {
    EpipolarFit fit;
    int rivalInliers = 0; ///< Of another fit that is as likely, before the matches are counted.
};

/// Which way is up in this photo, as far as that is known.
Vertical upOf(int photo, const PairOptions& options) {
    constexpr double kUnknownRad = std::numbers::pi;
    const auto i = static_cast<std::size_t>(photo);
    return i < options.ups.size() ? options.ups[i] : Vertical{Eigen::Vector3d::UnitZ(), kUnknownRad};
}

/// Whether the rotation brings what is up in both photos together.
bool keepsUp(const EpipolarFit& fit, const Vertical& upA, const Vertical& upB) {
    constexpr double kSigmas = 4;
    constexpr double kFewMatchesRad = 0.05; // What a fit of few matches leans by.
    const double leanRad = angleBetween(upA.upInPhoto, fit.aFromB * upB.upInPhoto).value();
    return leanRad < kSigmas * std::hypot(upA.sigmaRad, upB.sigmaRad) + kFewMatchesRad;
}

std::vector<Candidate> candidates(const Bearings& bearings, const Vertical& upA, const Vertical& upB) {
    std::vector<Candidate> found;
    double firstScore = 0;
    int most = 0;
    for (const RotationHypothesis& hypothesis : rotationHypotheses(bearings)) {
        firstScore = std::max(firstScore, hypothesis.score);
        if (hypothesis.score < 0.4 * firstScore) {
            break; // The hypotheses that follow have less.
        }
        found.push_back({refineEpipolar(bearings, hypothesis.aFromB), kSameMinimumRad});
        most = std::max(most, found.back().fit.inliers);
    }
    if (most < kClearShare * bearings.count()) {
        for (const RotationHypothesis& hypothesis :
             levelHypotheses(bearings, uprightFrom(upA.upInPhoto), uprightFrom(upB.upInPhoto))) {
            found.push_back({refineEpipolar(bearings, hypothesis.aFromB), kAnotherAnswerRad});
        }
    }
    return found;
}

/// The fit with most inliers. One that shows no mirror image goes before, and so does one that keeps what is
/// up where it is, if it has nearly as many.
Choice chosen(std::vector<Candidate> found, const Vertical& upA, const Vertical& upB) {
    const bool hasReal = std::ranges::any_of(
        found, [](const Candidate& one) { return !isMirrored(one.fit) && !isChance(one.fit); });
    if (hasReal) {
        std::erase_if(found, [](const Candidate& one) { return isMirrored(one.fit); });
    }
    const auto inliers = [](const Candidate& one) { return one.fit.inliers; };
    if (found.empty()) {
        return {};
    }
    const int most = std::ranges::max_element(found, {}, inliers)->fit.inliers;
    const auto keeps = [&](const Candidate& one) { return keepsUp(one.fit, upA, upB); };
    if (std::ranges::any_of(
            found, [&](const Candidate& one) { return keeps(one) && one.fit.inliers > kRival * most; })) {
        std::erase_if(found, [&](const Candidate& one) { return !keeps(one); });
    }
    const Candidate best = *std::ranges::max_element(found, {}, inliers);
    Choice choice{best.fit, 0};
    for (const Candidate& other : found) {
        const double apartRad = Eigen::AngleAxisd(other.fit.aFromB * best.fit.aFromB.transpose()).angle();
        if (apartRad >= std::max(other.distinctRad, best.distinctRad) && !isMirrored(other.fit)) {
            choice.rivalInliers = std::max(choice.rivalInliers, other.fit.inliers);
        }
    }
    return choice;
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
    const Vertical upA = upOf(pair.a, options);
    const Vertical upB = upOf(pair.b, options);
    const auto [fit, rivalInliers] = chosen(candidates(bearings, upA, upB), upA, upB);
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
    estimate.verdict = verdictOf(fit, rivalInliers, estimate, options);
    if (estimate.verdict == PairVerdict::Constraint && keepsNoOrder(bearings, fit)) {
        estimate.verdict = PairVerdict::NoAgreement;
    }
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
