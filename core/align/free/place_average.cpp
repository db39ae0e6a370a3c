// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"
#include "graph/pose_graph.h"
#include "pairs/disjoint_sets.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kLeastDepthParallaxRad = 0.01;
constexpr double kLeastDepthSigmas = 6; ///< A depth is then known to a sixth.
constexpr std::size_t kLeastShared = 5; ///< Things that two legs share.
constexpr double kLeastLogSigma = 0.01;
constexpr double kLeastDirectionRad = 0.01;
constexpr double kOnePlaceSigma = 0.2; ///< In usual legs: so far apart may photos be without parallax.
constexpr int kAverageRounds = 25;

/// A thing's distance from a photo in lengths of the leg.
struct LegDepth {
    int feature = 0;
    std::size_t leg = 0;
    double logDepth = 0;
};

struct Depths {
    double fromA = 0;
    double fromB = 0;
};

/// Where the rays meet, in lengths of the baseline; nothing if they meet nowhere in front, or too flatly.
std::optional<Depths> depthsOf(const PairEstimate& estimate, const UnitMatch& match) {
    const Eigen::Vector3d fromB = estimate.aFromB * match.inB;
    const Eigen::Vector3d normal = match.inA.cross(fromB);
    const double square = normal.squaredNorm();
    const double least = std::max(kLeastDepthParallaxRad, kLeastDepthSigmas * match.sigmaRad);
    if (square < least * least) {
        return std::nullopt;
    }
    const Depths depths{estimate.baselineInA->cross(fromB).dot(normal) / square,
                        estimate.baselineInA->cross(match.inA).dot(normal) / square};
    return depths.fromA > 0 && depths.fromB > 0 ? std::optional(depths) : std::nullopt;
}

/// Two legs' lengths against each other: log(first) - log(second).
struct LengthRatio {
    std::size_t first = 0;
    std::size_t second = 0;
    double log = 0;
    double sigma = 0;
};

void addRatios(std::vector<LegDepth> depths, std::vector<LengthRatio>& ratios) {
    std::ranges::stable_sort(depths, {}, &LegDepth::feature);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> shared;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        for (std::size_t j = i + 1; j < depths.size() && depths[j].feature == depths[i].feature; ++j) {
            const LegDepth& one = depths[i].leg < depths[j].leg ? depths[i] : depths[j];
            const LegDepth& other = depths[i].leg < depths[j].leg ? depths[j] : depths[i];
            if (one.leg != other.leg) {
                shared[{one.leg, other.leg}].push_back(other.logDepth - one.logDepth);
            }
        }
    }
    for (auto& [legs, logs] : shared) {
        if (logs.size() >= kLeastShared) {
            const auto count = static_cast<double>(logs.size());
            const auto middle = medianAndSpread(std::move(logs));
            ratios.push_back({legs.first, legs.second, middle.median,
                              std::max(kLeastLogSigma, 1.25 * middle.sigma / std::sqrt(count))});
        }
    }
}

double cauchyWeight(double residual, double width) {
    const double ratio = residual / width;
    return 1 / (1 + ratio * ratio);
}

/// The logarithms of all lengths, and which of them hang together with most others.
struct Lengths {
    Eigen::VectorXd logs;
    std::vector<bool> isKnown;
};

Lengths lengthsFrom(const std::vector<LengthRatio>& ratios, std::size_t count) {
    DisjointSets sets(count);
    for (const LengthRatio& ratio : ratios) {
        sets.join(static_cast<int>(ratio.first), static_cast<int>(ratio.second));
    }
    std::vector<int> members(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        ++members[static_cast<std::size_t>(sets.of(static_cast<int>(i)))];
    }
    const auto largest = static_cast<int>(std::ranges::max_element(members) - members.begin());
    Lengths lengths{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count)), std::vector<bool>(count, false)};
    for (std::size_t i = 0; i < count; ++i) {
        lengths.isKnown[i] = sets.of(static_cast<int>(i)) == largest;
    }
    for (int round = 0; round < kAverageRounds; ++round) {
        const double width = round < 5 ? 10 : 3;
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(lengths.logs.size(), 1);
        for (Eigen::Index i = 0; i < lengths.logs.size(); ++i) {
            entries.emplace_back(i, i, 1e-6);
        }
        for (const LengthRatio& ratio : ratios) {
            const auto i = static_cast<Eigen::Index>(ratio.first);
            const auto j = static_cast<Eigen::Index>(ratio.second);
            const double off = (lengths.logs[i] - lengths.logs[j] - ratio.log) / ratio.sigma;
            const double weight = cauchyWeight(round == 0 ? 0 : off, width) / (ratio.sigma * ratio.sigma);
            entries.emplace_back(i, i, weight);
            entries.emplace_back(j, j, weight);
            entries.emplace_back(i, j, -weight);
            entries.emplace_back(j, i, -weight);
            right(i, 0) += weight * ratio.log;
            right(j, 0) -= weight * ratio.log;
        }
        Eigen::SparseMatrix<double> matrix(lengths.logs.size(), lengths.logs.size());
        matrix.setFromTriplets(entries.begin(), entries.end());
        if (const auto solved = solvedSparse(matrix, right); solved && solved->allFinite()) {
            lengths.logs = solved->col(0);
        }
    }
    return lengths;
}

/// Gives the legs their lengths, in units of the usual one.
void measure(const std::vector<LengthRatio>& ratios, std::vector<Leg>& all) {
    if (all.empty()) {
        return;
    }
    const Lengths lengths = lengthsFrom(ratios, all.size());
    std::vector<double> known;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (lengths.isKnown[i]) {
            known.push_back(lengths.logs[static_cast<Eigen::Index>(i)]);
        }
    }
    const double usual = median(std::move(known));
    constexpr double kLengthSigma = 0.05;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (lengths.isKnown[i]) {
            all[i].length = std::exp(lengths.logs[static_cast<Eigen::Index>(i)] - usual);
            all[i].lengthSigma = kLengthSigma;
        }
    }
}

std::size_t placeOf(const Component& component, int photo) {
    return static_cast<std::size_t>(std::ranges::lower_bound(component.photos, photo) -
                                    component.photos.begin());
}

} // namespace

std::vector<Leg> legs(const Component& component, std::span<const PhotoPair> pairs,
                      std::span<const PairEstimate> estimates) {
    std::vector<Leg> all;
    std::vector<Leg> still;
    std::vector<std::vector<LegDepth>> depths(component.photos.size());
    for (const GraphEdge& edge : component.edges) {
        const auto at = static_cast<std::size_t>(edge.pair);
        const PairEstimate& estimate = estimates[at];
        Leg leg;
        leg.a = static_cast<int>(placeOf(component, estimate.a));
        leg.b = static_cast<int>(placeOf(component, estimate.b));
        if (!estimate.baselineInA) {
            leg.length = 0;
            still.push_back(leg);
            continue;
        }
        leg.direction = component.componentFromPhoto[static_cast<std::size_t>(leg.a)] *
                        estimate.baselineInA->normalized();
        leg.sigmaRad = std::max(estimate.baselineSigmaRad, kLeastDirectionRad);
        for (std::size_t i = 0; i < pairs[at].matches.size(); ++i) {
            const Correspondence& raw = pairs[at].matches[i];
            const auto match = estimate.isInlier[i] ? unitMatch(raw) : std::nullopt;
            const auto depth = match ? depthsOf(estimate, *match) : std::nullopt;
            if (depth && raw.featureA >= 0 && raw.featureB >= 0) {
                depths[static_cast<std::size_t>(leg.a)].push_back(
                    {raw.featureA, all.size(), std::log(depth->fromA)});
                depths[static_cast<std::size_t>(leg.b)].push_back(
                    {raw.featureB, all.size(), std::log(depth->fromB)});
            }
        }
        all.push_back(leg);
    }
    std::vector<LengthRatio> ratios;
    for (std::vector<LegDepth>& ofPhoto : depths) {
        addRatios(std::move(ofPhoto), ratios);
    }
    measure(ratios, all);
    all.insert(all.end(), still.begin(), still.end());
    return all;
}

namespace {

/// Adds weight * (I or a projection) for a difference of two places.
class PlaceEquations {
  public:
    explicit PlaceEquations(Eigen::Index photos) : m_right(Eigen::MatrixXd::Zero(3 * photos, 1)) {
        for (Eigen::Index i = 0; i < 3 * photos; ++i) {
            m_entries.emplace_back(i, i, i < 3 ? 1e6 : 1e-9); // The first photo is the origin.
        }
    }

    void add(const Leg& leg, const Eigen::Matrix3d& weight, const Eigen::Vector3d& apart) {
        const auto a = static_cast<Eigen::Index>(3 * leg.a);
        const auto b = static_cast<Eigen::Index>(3 * leg.b);
        for (Eigen::Index i = 0; i < 3; ++i) {
            for (Eigen::Index j = 0; j < 3; ++j) {
                m_entries.emplace_back(a + i, a + j, weight(i, j));
                m_entries.emplace_back(b + i, b + j, weight(i, j));
                m_entries.emplace_back(a + i, b + j, -weight(i, j));
                m_entries.emplace_back(b + i, a + j, -weight(i, j));
            }
        }
        m_right.block<3, 1>(b, 0) += weight * apart;
        m_right.block<3, 1>(a, 0) -= weight * apart;
    }

    std::optional<Eigen::MatrixXd> solved() const {
        Eigen::SparseMatrix<double> matrix(m_right.rows(), m_right.rows());
        matrix.setFromTriplets(m_entries.begin(), m_entries.end());
        return solvedSparse(matrix, m_right);
    }

  private:
    std::vector<Eigen::Triplet<double>> m_entries;
    Eigen::MatrixXd m_right;
};

/// The inverse covariance of a leg that has a length.
Eigen::Matrix3d information(const Leg& leg) {
    if (*leg.length == 0) {
        return Eigen::Matrix3d::Identity() / (kOnePlaceSigma * kOnePlaceSigma);
    }
    const double across = std::max(*leg.length, 0.05) * leg.sigmaRad;
    const double along = std::max(*leg.length, 0.05) * leg.lengthSigma;
    const Eigen::Matrix3d axis = leg.direction * leg.direction.transpose();
    return axis / (along * along) + (Eigen::Matrix3d::Identity() - axis) / (across * across);
}

} // namespace

std::vector<std::optional<Eigen::Vector3d>> averagedPlaces(std::span<const Leg> legs, int photos) {
    std::vector<Leg> used;
    DisjointSets sets(static_cast<std::size_t>(photos));
    for (const Leg& leg : legs) {
        if (leg.length) {
            used.push_back(leg);
            sets.join(leg.a, leg.b);
        }
    }
    Eigen::MatrixXd places = Eigen::MatrixXd::Zero(3 * photos, 1);
    for (int round = 0; round < kAverageRounds; ++round) {
        PlaceEquations equations(photos);
        const double width = round < 8 ? 10 : 4;
        for (const Leg& leg : used) {
            const Eigen::Vector3d apart = *leg.length * leg.direction;
            const Eigen::Vector3d off =
                places.block<3, 1>(3 * leg.b, 0) - places.block<3, 1>(3 * leg.a, 0) - apart;
            const Eigen::Matrix3d weight = information(leg);
            const double sigmas = std::sqrt(off.dot(weight * off));
            equations.add(leg, (round == 0 ? 1 : cauchyWeight(sigmas, width)) * weight, apart);
        }
        if (auto solved = equations.solved(); solved && solved->allFinite()) {
            places = std::move(*solved);
        }
    }
    std::map<int, int> members;
    for (int i = 0; i < photos; ++i) {
        ++members[sets.of(i)];
    }
    const int largest =
        std::ranges::max_element(members, {}, [](const auto& set) { return set.second; })->first;
    std::vector<std::optional<Eigen::Vector3d>> placed(static_cast<std::size_t>(photos));
    for (int i = 0; i < photos; ++i) {
        if (sets.of(i) == largest && members.at(largest) > 1) {
            placed[static_cast<std::size_t>(i)] = places.block<3, 1>(3 * i, 0);
        }
    }
    return placed;
}

} // namespace spherewalk::align
