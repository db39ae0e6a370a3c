// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/position_evidence.h"

#include "spherewalk/base/statistics.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

constexpr double kWrongShare = 0.1;       ///< Share of the directions that is expected to say nothing.
constexpr double kTails = 3;              ///< Degrees of freedom of the directions' Student distribution.
constexpr double kLeastSigmaRad = 0.01;   ///< No pair knows its direction better.
constexpr double kRotationRad = 0.004;    ///< Error that the averaged rotations add.
constexpr double kLeastPositionM = 0.003; ///< Nobody lays a camera down better.
constexpr double kLargestResidualRad = 0.03;
constexpr double kContradictedSigmas = 5;
constexpr double kParallaxNoiseRad = 0.003;
constexpr double kParallaxShare =
    0.5; ///< Neighbours share their scene, so their parallaxes are not independent.

bool isKnown(const PairEstimate& estimate) {
    return estimate.baselineInA && estimate.baselineInA->allFinite() && estimate.baselineInA->norm() > 0.5 &&
           estimate.baselineSigmaRad > 0 && std::isfinite(estimate.baselineSigmaRad);
}

} // namespace

std::vector<Baseline> baselines(std::span<const PairEstimate> estimates, const Component& component) {
    std::vector<Baseline> all;
    for (const GraphEdge& edge : component.edges) {
        if (edge.residualRad > kLargestResidualRad) {
            continue;
        }
        const PairEstimate& estimate = estimates[static_cast<std::size_t>(edge.pair)];
        Baseline baseline{estimate.a, estimate.b, isKnown(estimate)};
        if (baseline.hasDirection) {
            const auto a = std::ranges::lower_bound(component.photos, estimate.a) - component.photos.begin();
            baseline.inComponent = component.componentFromPhoto[static_cast<std::size_t>(a)] *
                                   estimate.baselineInA->normalized();
            baseline.sigmaRad = std::max(estimate.baselineSigmaRad, kLeastSigmaRad);
        }
        baseline.parallaxRad = std::isfinite(estimate.parallaxRad) ? std::max(0., estimate.parallaxRad) : 0;
        all.push_back(baseline);
    }
    return all;
}

PositionEvidence::PositionEvidence(std::vector<Baseline> baselines, std::vector<Eigen::Vector3d> positionsM,
                                   std::vector<double> positionSigmasM)
    : m_baselines(std::move(baselines)),
      m_positionsM(std::move(positionsM)),
      m_positionSigmasM(std::move(positionSigmasM)),
      m_of(m_positionsM.size()),
      m_logLikelihoods(m_baselines.size()),
      m_isCounted(m_baselines.size(), false) {
    for (double& sigmaM : m_positionSigmasM) {
        sigmaM = std::isfinite(sigmaM) ? std::max(sigmaM, kLeastPositionM) : kLeastPositionM;
    }
    for (int i = 0; const Baseline& baseline : m_baselines) {
        m_of[static_cast<std::size_t>(baseline.a)].push_back(i);
        m_of[static_cast<std::size_t>(baseline.b)].push_back(i);
        ++i;
    }
    measureParallax();
    turn(m_roomFromComponent);
}

/// Measures the median of parallax over distance, and how far the pairs lie from it.
void PositionEvidence::measureParallax() {
    std::vector<double> logs;
    for (const Baseline& baseline : m_baselines) {
        const double distanceM = (m_positionsM[static_cast<std::size_t>(baseline.b)] -
                                  m_positionsM[static_cast<std::size_t>(baseline.a)])
                                     .norm();
        if (distanceM > 0.01 && baseline.parallaxRad > kParallaxNoiseRad) {
            logs.push_back(std::log(baseline.parallaxRad / distanceM));
        }
    }
    if (logs.empty()) {
        return;
    }
    const double middle = median(logs);
    m_parallaxPerM = std::exp(middle);
    for (double& log : logs) {
        log = std::abs(log - middle);
    }
    m_parallaxSpread = std::clamp(1.5 * median(logs), 0.25, 1.);
}

void PositionEvidence::turn(const Eigen::Quaterniond& roomFromComponent) {
    m_roomFromComponent = roomFromComponent;
    std::ranges::transform(m_baselines, m_logLikelihoods.begin(),
                           [this](const Baseline& baseline) { return logLikelihood(baseline); });
}

void PositionEvidence::apply(std::span<const Move> moves) {
    for (const Move& move : moves) {
        m_positionsM[static_cast<std::size_t>(move.photo)] = move.positionM;
    }
    turn(m_roomFromComponent);
}

double PositionEvidence::gain(std::span<const Move> moves) {
    std::vector<Eigen::Vector3d> before;
    before.reserve(moves.size());
    for (const Move& move : moves) {
        Eigen::Vector3d& positionM = m_positionsM[static_cast<std::size_t>(move.photo)];
        before.push_back(positionM);
        positionM = move.positionM;
    }
    double gained = 0;
    for (const Move& move : moves) {
        for (const int i : of(move.photo)) {
            const auto index = static_cast<std::size_t>(i);
            if (!m_isCounted[index]) {
                m_isCounted[index] = true;
                gained += logLikelihood(m_baselines[index]) - m_logLikelihoods[index];
            }
        }
    }
    for (std::size_t i = moves.size(); i-- > 0;) {
        m_positionsM[static_cast<std::size_t>(moves[i].photo)] = before[i];
        for (const int baseline : of(moves[i].photo)) {
            m_isCounted[static_cast<std::size_t>(baseline)] = false;
        }
    }
    return gained;
}

double PositionEvidence::score() const {
    double sum = 0;
    for (const double logLikelihood : m_logLikelihoods) {
        sum += logLikelihood;
    }
    return sum;
}

PositionEvidence::Count PositionEvidence::count(int photo) const {
    Count count;
    for (const int i : of(photo)) {
        const Baseline& baseline = m_baselines[static_cast<std::size_t>(i)];
        count.directions += baseline.hasDirection ? 1 : 0;
        count.contradicted += misfit(baseline) > kContradictedSigmas ? 1 : 0;
    }
    return count;
}

/// Standard deviation of the angle between a baseline and the line between positions at this distance.
double PositionEvidence::sigmaRad(const Baseline& baseline, double distanceM) const {
    const double acrossM = std::hypot(m_positionSigmasM[static_cast<std::size_t>(baseline.a)],
                                      m_positionSigmasM[static_cast<std::size_t>(baseline.b)]) /
                           std::max(distanceM, 1e-9);
    return std::sqrt(baseline.sigmaRad * baseline.sigmaRad + kRotationRad * kRotationRad + acrossM * acrossM);
}

double PositionEvidence::misfit(const Baseline& baseline) const {
    const Eigen::Vector3d inRoom = m_positionsM[static_cast<std::size_t>(baseline.b)] -
                                   m_positionsM[static_cast<std::size_t>(baseline.a)];
    const double distanceM = inRoom.norm();
    if (!baseline.hasDirection || distanceM == 0) {
        return 0;
    }
    const double chord = (m_roomFromComponent * baseline.inComponent - inRoom / distanceM).norm();
    return chord / sigmaRad(baseline, distanceM);
}

double PositionEvidence::logLikelihood(const Baseline& baseline) const {
    const Eigen::Vector3d inRoom = m_positionsM[static_cast<std::size_t>(baseline.b)] -
                                   m_positionsM[static_cast<std::size_t>(baseline.a)];
    const double distanceM = inRoom.norm();
    double sum = 0;
    if (baseline.hasDirection && distanceM > 0) {
        // Relative to a direction that says nothing: positive where the positions explain the baseline.
        const double sigma = sigmaRad(baseline, distanceM);
        const double squared =
            (m_roomFromComponent * baseline.inComponent - inRoom / distanceM).squaredNorm();
        const double density = 2 / std::min(sigma * sigma, 2.) *
                               std::pow(1 + squared / (kTails * sigma * sigma), -(kTails + 2) / 2);
        sum += std::log(kWrongShare + (1 - kWrongShare) * density);
    }
    if (m_parallaxPerM > 0) {
        const double off = std::log((baseline.parallaxRad + kParallaxNoiseRad) /
                                    (m_parallaxPerM * distanceM + kParallaxNoiseRad)) /
                           m_parallaxSpread;
        sum += kParallaxShare * std::log((kWrongShare + std::exp(-off * off / 2)) / (1 + kWrongShare));
    }
    return sum;
}

} // namespace spherewalk::align
