// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_orientation.h"

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

constexpr double kLeastApartM = 0.01;
constexpr double kAgreeingRad = 0.26;
constexpr int kBins = 360;

// The direction that the fewest contradict: the medoid, then a mean that bounds every one's influence.
Eigen::Vector3d robustMean(const std::vector<Eigen::Vector3d>& directions) {
    Eigen::Vector3d mean = directions.front();
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
    for (int round = 0; round < 10; ++round) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& one : directions) {
            sum += one / std::max((one - mean).norm(), 2e-3);
        }
        mean = sum.normalized();
    }
    return mean;
}

Eigen::Quaterniond uprightFromRoot(const Component& component, std::span<const PhotoPrior> photos) {
    std::vector<Eigen::Vector3d> said;
    std::vector<Eigen::Vector3d> assumed;
    for (std::size_t i = 0; i < component.photos.size(); ++i) {
        const PhotoPrior& prior = photos[static_cast<std::size_t>(component.photos[i])];
        const Eigen::Quaterniond photoFromLevel =
            prior.levelFromPhoto ? prior.levelFromPhoto->conjugate() : Eigen::Quaterniond::Identity();
        const Eigen::Vector3d up = component.rootFromPhoto[i] * (photoFromLevel * Eigen::Vector3d::UnitZ());
        (prior.levelFromPhoto ? said : assumed).push_back(up);
    }
    return Eigen::Quaterniond::FromTwoVectors(robustMean(said.empty() ? assumed : said),
                                              Eigen::Vector3d::UnitZ());
}

// What one baseline says of the heading.
struct Vote {
    double heading = 0;
    double sigma = 0;
    double weight = 0;
};

std::vector<Vote> votes(const Component& component, std::span<const PhotoPrior> photos,
                        std::span<const PairEstimate> estimates, const Eigen::Quaterniond& uprightFromRoot) {
    std::map<int, std::size_t> indexOf;
    for (std::size_t i = 0; i < component.photos.size(); ++i) {
        indexOf[component.photos[i]] = i;
    }
    std::vector<Vote> all;
    for (const GraphEdge& edge : component.edges) {
        const PairEstimate& estimate = estimates[static_cast<std::size_t>(edge.pair)];
        const PhotoPrior& a = photos[static_cast<std::size_t>(edge.a)];
        const PhotoPrior& b = photos[static_cast<std::size_t>(edge.b)];
        const Eigen::Vector3d planned = b.positionM - a.positionM;
        const double apart = planned.head<2>().norm();
        if (!estimate.baselineInA || apart < kLeastApartM) {
            continue;
        }
        const Eigen::Vector3d seen =
            uprightFromRoot * component.rootFromPhoto[indexOf[edge.a]] * *estimate.baselineInA;
        const double level = seen.head<2>().norm();
        if (level < 0.2) {
            continue;
        }
        const double bySeeing = estimate.baselineSigmaRad / level;
        const double byPlan = std::hypot(a.positionSigmaM, b.positionSigmaM) / apart;
        const double sigma = std::max(std::hypot(bySeeing, byPlan), 0.002);
        const double heading = std::atan2(planned.y(), planned.x()) - std::atan2(seen.y(), seen.x());
        all.push_back({wrapped(Radians(heading)).value(), sigma, 1 / (sigma * sigma + 1e-3)});
    }
    return all;
}

// Headings by votes, the strongest first, each the top of its own hill.
std::vector<double> hills(const std::vector<Vote>& all) {
    std::array<double, kBins> height{};
    for (int bin = 0; bin < kBins; ++bin) {
        const double at = (bin + 0.5) * 2 * std::numbers::pi / kBins - std::numbers::pi;
        for (const Vote& vote : all) {
            const double width = std::max(vote.sigma, 0.05);
            const double ratio = wrapped(Radians(at - vote.heading)).value() / width;
            height[static_cast<std::size_t>(bin)] += vote.weight * std::exp(-ratio * ratio / 2);
        }
    }
    std::vector<std::pair<double, double>> tops;
    for (int bin = 0; bin < kBins; ++bin) {
        bool isTop = true;
        for (int near = -15; near <= 15; ++near) {
            const double other = height[static_cast<std::size_t>((bin + near + kBins) % kBins)];
            const double own = height[static_cast<std::size_t>(bin)];
            isTop = isTop && (near < 0 ? own > other : own >= other);
        }
        if (isTop) {
            tops.emplace_back(-height[static_cast<std::size_t>(bin)],
                              (bin + 0.5) * 2 * std::numbers::pi / kBins - std::numbers::pi);
        }
    }
    std::ranges::sort(tops);
    std::vector<double> headings;
    for (const auto& [height0, heading] : tops) {
        headings.push_back(heading);
    }
    return headings;
}

double refinedHeading(const std::vector<Vote>& all, double heading) {
    for (int round = 0; round < 10; ++round) {
        double sum = 0;
        double weights = 0;
        for (const Vote& vote : all) {
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

} // namespace

RoomOrientation roomOrientation(const Component& component, std::span<const PhotoPrior> photos,
                                std::span<const PairEstimate> estimates, int rank) {
    RoomOrientation orientation;
    const Eigen::Quaterniond upright = uprightFromRoot(component, photos);
    const std::vector<Vote> all = votes(component, photos, estimates, upright);
    const std::vector<double> headings = hills(all);
    if (all.empty() || headings.empty()) {
        orientation.roomFromRoot = upright;
        return orientation;
    }
    const std::size_t chosen = std::min(headings.size() - 1, static_cast<std::size_t>(rank));
    const double heading = refinedHeading(all, headings[chosen]);
    double agreeing = 0;
    double weights = 0;
    for (const Vote& vote : all) {
        weights += vote.weight;
        const double away = std::abs(wrapped(Radians(vote.heading - heading)).value());
        agreeing += away < std::max(kAgreeingRad, 3 * vote.sigma) ? vote.weight : 0;
    }
    orientation.hasHeading = true;
    orientation.agreeingShare = agreeing / weights;
    orientation.roomFromRoot = yawRotation(Radians(heading)) * upright;
    return orientation;
}

} // namespace spherewalk::align
