// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace spherewalk::align {

namespace {

constexpr double kLeastBaselineM = 0.01;
constexpr double kAgreeingRad = 0.26;
constexpr int kHeadingBins = 360;
constexpr std::size_t kMostOrientations = 3;

// The direction that most others lie near: the medoid, then a mean that bounds the influence of each.
Eigen::Vector3d robustMean(const std::vector<Eigen::Vector3d>& directions) {
    Eigen::Vector3d mean = directions.empty() ? Eigen::Vector3d::UnitZ() : directions.front();
    double least = -1;
    for (const Eigen::Vector3d& one : directions) {
        double sum = 0;
        for (const Eigen::Vector3d& other : directions) {
            sum += (one - other).norm();
        }
        if (least < 0 || sum < least) {
            least = sum;
            mean = one;
        }
    }
    for (int round = 0; round < 10 && !directions.empty(); ++round) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& one : directions) {
            sum += one / std::max((one - mean).norm(), 2e-3);
        }
        mean = sum.normalized();
    }
    return mean;
}

Eigen::Quaterniond uprightFromComponent(const Component& component, std::span<const PhotoPrior> photos) {
    std::vector<Eigen::Vector3d> said;
    std::vector<Eigen::Vector3d> assumed;
    for (std::size_t i = 0; i < component.photos.size(); ++i) {
        const PhotoPrior& prior = photos[static_cast<std::size_t>(component.photos[i])];
        const Eigen::Vector3d up = component.componentFromPhoto[i] * knownUp(prior).upInPhoto;
        if (up.allFinite()) {
            (saysUp(prior) ? said : assumed).push_back(up);
        }
    }
    return uprightFrom(robustMean(said.empty() ? assumed : said));
}

// What one baseline says of the heading.
struct HeadingVote {
    double heading = 0;
    double sigma = 0;
    double weight = 0;
    double apartM = 0; ///< How long the baseline is by its positions.
};

std::vector<HeadingVote> headingVotes(const Component& component, std::span<const PhotoPrior> photos,
                                      std::span<const PairEstimate> estimates,
                                      const Eigen::Quaterniond& upright) {
    std::map<int, std::size_t> indexOf;
    for (std::size_t i = 0; i < component.photos.size(); ++i) {
        indexOf[component.photos[i]] = i;
    }
    std::vector<HeadingVote> all;
    for (const GraphEdge& edge : component.edges) {
        const PairEstimate& estimate = estimates[static_cast<std::size_t>(edge.pair)];
        const PhotoPrior& a = photos[static_cast<std::size_t>(edge.a)];
        const PhotoPrior& b = photos[static_cast<std::size_t>(edge.b)];
        const Eigen::Vector3d planned = b.positionM - a.positionM;
        const double apart = planned.head<2>().norm();
        if (!estimate.baselineInA || !estimate.baselineInA->allFinite() || !std::isfinite(apart) ||
            apart < kLeastBaselineM) {
            continue;
        }
        const Eigen::Vector3d seen =
            upright * component.componentFromPhoto[indexOf[edge.a]] * *estimate.baselineInA;
        const double level = seen.head<2>().norm();
        if (!(level >= 0.2)) { // NaN fails too.
            continue;
        }
        const double bySeeing = estimate.baselineSigmaRad / level;
        const double byPlan = std::hypot(a.positionSigmaM, b.positionSigmaM) / apart;
        const double sigma = std::max(std::hypot(bySeeing, byPlan), 0.002);
        if (!std::isfinite(sigma)) {
            continue;
        }
        const double heading = std::atan2(planned.y(), planned.x()) - std::atan2(seen.y(), seen.x());
        all.push_back({wrapped(Radians(heading)).value(), sigma, 1 / (sigma * sigma + 1e-3), apart});
    }
    return all;
}

// Headings with the most votes around them, the strongest first, each the top of its own hill.
std::vector<double> likelyHeadings(const std::vector<HeadingVote>& all) {
    std::array<double, kHeadingBins> height{};
    for (int bin = 0; bin < kHeadingBins; ++bin) {
        const double at = (bin + 0.5) * 2 * std::numbers::pi / kHeadingBins - std::numbers::pi;
        for (const HeadingVote& vote : all) {
            const double width = std::max(vote.sigma, 0.05);
            const double ratio = wrapped(Radians(at - vote.heading)).value() / width;
            height[static_cast<std::size_t>(bin)] += vote.weight * std::exp(-ratio * ratio / 2);
        }
    }
    std::vector<std::pair<double, double>> tops;
    for (int bin = 0; bin < kHeadingBins; ++bin) {
        bool isTop = true;
        for (int near = -15; near <= 15; ++near) {
            const double other = height[static_cast<std::size_t>((bin + near + kHeadingBins) % kHeadingBins)];
            const double own = height[static_cast<std::size_t>(bin)];
            isTop = isTop && (near < 0 ? own > other : own >= other);
        }
        if (isTop) {
            tops.emplace_back(-height[static_cast<std::size_t>(bin)],
                              (bin + 0.5) * 2 * std::numbers::pi / kHeadingBins - std::numbers::pi);
        }
    }
    std::ranges::sort(tops);
    std::vector<double> headings;
    for (const auto& [height0, heading] : tops) {
        headings.push_back(heading);
    }
    return headings;
}

double refinedHeading(const std::vector<HeadingVote>& all, double heading) {
    for (int round = 0; round < 10; ++round) {
        double sum = 0;
        double weights = 0;
        for (const HeadingVote& vote : all) {
            const double away = wrapped(Radians(vote.heading - heading)).value();
            const double ratio = away / std::max(3 * vote.sigma, 0.03);
            const double root = 1 / (1 + ratio * ratio);
            sum += vote.weight * root * root * away;
            weights += vote.weight * root * root;
        }
        heading += weights > 0 ? sum / weights : 0;
    }
    return heading;
}

double agreeingShare(const std::vector<HeadingVote>& all, double heading) {
    double agreeing = 0;
    double weights = 0;
    for (const HeadingVote& vote : all) {
        weights += vote.weight;
        const double away = std::abs(wrapped(Radians(vote.heading - heading)).value());
        agreeing += away < std::max(kAgreeingRad, 3 * vote.sigma) ? vote.weight : 0;
    }
    return agreeing / weights;
}

/// By the median, since some votes say nothing.
double positionErrorM(const std::vector<HeadingVote>& all, double heading) {
    std::vector<double> errorsM;
    for (const HeadingVote& vote : all) {
        const double away = std::abs(wrapped(Radians(vote.heading - heading)).value());
        const double across = std::sin(std::min(away, std::numbers::pi / 2)) * vote.apartM;
        errorsM.push_back(across / std::numbers::sqrt2); // of both positions
    }
    constexpr double kPerMedian = 1.4826;
    return kPerMedian * median(std::move(errorsM));
}

} // namespace

std::vector<RoomOrientation> orientations(const Component& component, std::span<const PhotoPrior> photos,
                                          std::span<const PairEstimate> estimates) {
    const Eigen::Quaterniond upright = uprightFromComponent(component, photos);
    const std::vector<HeadingVote> all = headingVotes(component, photos, estimates, upright);
    std::vector<double> headings = likelyHeadings(all);
    if (headings.empty()) {
        return {{upright, false, 0, 0}};
    }
    headings.resize(std::min(headings.size(), kMostOrientations));
    std::vector<RoomOrientation> made;
    for (const double likely : headings) {
        const double heading = refinedHeading(all, likely);
        made.push_back({yawRotation(Radians(heading)) * upright, true, agreeingShare(all, heading),
                        positionErrorM(all, heading)});
    }
    return made;
}

namespace {

/// Whether enough matches agree, and the way between the photos is that of their tags, as one way in a
/// hundred is by chance. roomFromA: by the other photos.
bool agreesWithTags(const PairEstimate& pair, const Eigen::Quaterniond& roomFromA,
                    std::span<const PhotoPrior> photos) {
    constexpr int kInliers = 20;
    constexpr double kShare = 0.7;
    constexpr double kOffRad = 0.17;
    if (!pair.baselineInA || pair.inliers < kInliers || pair.inlierShare < kShare) {
        return false;
    }
    const Eigen::Vector3d way = photos[static_cast<std::size_t>(pair.b)].positionM -
                                photos[static_cast<std::size_t>(pair.a)].positionM;
    return way.norm() > 0 && angleBetween(roomFromA * *pair.baselineInA, way).value() < kOffRad;
}

} // namespace

std::vector<bool> confirmedByTags(const PoseGraph& graph, std::span<const PhotoPrior> photos,
                                  std::span<const PairEstimate> estimates) {
    constexpr double kSureShare = 0.7;
    if (graph.components.empty()) {
        return {};
    }
    const Component& largest = graph.components.front();
    const RoomOrientation lies = orientations(largest, photos, estimates).front();
    if (!lies.hasHeading || lies.agreeingShare < kSureShare) {
        return {};
    }
    std::vector<int> placeOf(photos.size(), -1);
    for (std::size_t i = 0; i < largest.photos.size(); ++i) {
        placeOf[static_cast<std::size_t>(largest.photos[i])] = static_cast<int>(i);
    }
    std::vector<bool> confirmed(photos.size(), false);
    for (const int at : graph.contradicted) {
        const PairEstimate& pair = estimates[static_cast<std::size_t>(at)];
        const int a = placeOf[static_cast<std::size_t>(pair.a)];
        const int b = placeOf[static_cast<std::size_t>(pair.b)];
        if ((a < 0) == (b < 0)) {
            continue;
        }
        const Eigen::Quaterniond componentFromA =
            a >= 0 ? largest.componentFromPhoto[static_cast<std::size_t>(a)]
                   : largest.componentFromPhoto[static_cast<std::size_t>(b)] * pair.aFromB.conjugate();
        if (agreesWithTags(pair, lies.roomFromComponent * componentFromA, photos)) {
            confirmed[static_cast<std::size_t>(a >= 0 ? pair.b : pair.a)] = true;
        }
    }
    return confirmed;
}

} // namespace spherewalk::align
