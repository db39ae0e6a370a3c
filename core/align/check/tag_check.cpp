// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/tag_check.h"

#include "check/position_evidence.h"
#include "graph/pose_graph.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace spherewalk::align {

namespace {

constexpr std::size_t kLeastPhotos = 6;
constexpr double kLeastApartM = 0.05;
constexpr double kMirroredShare = 0.75; ///< Of the baselines, by the mirrored tags.
constexpr double kMirroredMargin = 0.2; ///< Less than that share agree with the tags as they are.

/// A baseline along the floor, as seen and as tagged.
struct FloorWay {
    Eigen::Vector2d seen;
    Eigen::Vector2d tagged;
    double sigmaRad = 0;
};

std::vector<FloorWay> floorWays(std::span<const PhotoPrior> photos, const std::vector<Baseline>& baselines,
                                const Eigen::Quaterniond& roomFromComponent) {
    std::vector<FloorWay> ways;
    for (const Baseline& baseline : baselines) {
        const PhotoPrior& a = photos[static_cast<std::size_t>(baseline.a)];
        const PhotoPrior& b = photos[static_cast<std::size_t>(baseline.b)];
        const Eigen::Vector2d tagged = (b.positionM - a.positionM).head<2>();
        const Eigen::Vector2d seen = (roomFromComponent * baseline.inComponent).head<2>();
        if (baseline.hasDirection && tagged.allFinite() && tagged.norm() > kLeastApartM &&
            seen.norm() > 0.5) {
            ways.push_back({seen.normalized(), tagged,
                            std::hypot(baseline.sigmaRad,
                                       std::hypot(a.positionSigmaM, b.positionSigmaM) / tagged.norm())});
        }
    }
    return ways;
}

/// The turn and the stretch of y, as its logarithm, with which tagged ways point as the seen ones do.
struct Stretch {
    double turn = 0;
    double logY = 0;
    double cost = 0;
    double variance = 0; ///< Of logY.
};

double angleOff(const FloorWay& way, double turn, const Eigen::Vector2d& stretched) {
    return wrapped(Radians(std::atan2(way.seen.y(), way.seen.x()) - std::atan2(stretched.y(), stretched.x()) -
                           turn))
        .value();
}

/// Robust least squares from a start. width: beyond it, in standard deviations, a way hardly counts.
Stretch fitted(const std::vector<FloorWay>& ways, double logY, std::size_t photos) {
    constexpr double kWidth = 3;
    Stretch fit{0, logY, 0, 0};
    for (int round = 0; round < 20; ++round) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() * 1e-6;
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        double squares = 0;
        double weights = 0;
        fit.cost = 0;
        for (const FloorWay& way : ways) {
            const Eigen::Vector2d stretched(way.tagged.x(), std::exp(fit.logY) * way.tagged.y());
            const double off = angleOff(way, fit.turn, stretched) / way.sigmaRad;
            const double root = 1 / (1 + off * off / (kWidth * kWidth));
            const Eigen::Vector2d by =
                Eigen::Vector2d(1, stretched.x() * stretched.y() / stretched.squaredNorm()) / way.sigmaRad;
            normal += root * root * by * by.transpose();
            right += root * root * off * by;
            squares += root * root * off * off;
            weights += root * root;
            fit.cost += 1 - root;
        }
        const Eigen::Vector2d step = normal.inverse() * right;
        fit.turn += step[0];
        fit.logY += step[1];
        // The photos' errors are what is independent, not those of their baselines.
        const double perPhoto = static_cast<double>(ways.size()) / static_cast<double>(photos);
        fit.variance = normal.inverse()(1, 1) * std::max(1., squares / std::max(weights, 1.)) * perPhoto;
    }
    return fit;
}

std::vector<PhotoPrior> mirrored(std::span<const PhotoPrior> photos) {
    std::vector<PhotoPrior> made(photos.begin(), photos.end());
    for (PhotoPrior& photo : made) {
        photo.positionM.y() *= -1;
    }
    return made;
}

} // namespace

TagFrame tagFrame(std::span<const PhotoPrior> photos, std::span<const PairEstimate> estimates) {
    TagFrame frame;
    const PoseGraph graph = poseGraph(static_cast<int>(photos.size()), estimates, 1);
    if (graph.components.empty() || graph.components.front().photos.size() < kLeastPhotos) {
        return frame;
    }
    const Component& component = graph.components.front();
    const RoomOrientation asTagged = orientations(component, photos, estimates).front();
    const RoomOrientation turned = orientations(component, mirrored(photos), estimates).front();
    frame.isMirrored = turned.hasHeading && turned.agreeingShare > kMirroredShare &&
                       asTagged.agreeingShare < turned.agreeingShare - kMirroredMargin;
    if (frame.isMirrored || !asTagged.hasHeading) {
        return frame;
    }
    const std::vector<FloorWay> ways =
        floorWays(photos, baselines(estimates, component), asTagged.roomFromComponent);
    if (ways.size() < kLeastPhotos) {
        return frame;
    }
    std::array<Stretch, 3> fits;
    std::ranges::transform(std::array{-0.25, 0., 0.25}, fits.begin(),
                           [&](double start) { return fitted(ways, start, component.photos.size()); });
    const Stretch best = *std::ranges::min_element(fits, {}, &Stretch::cost);
    constexpr double kUnknownSigma = 0.05;
    const double sigma = std::sqrt(best.variance);
    if (sigma < kUnknownSigma) {
        const double value = std::exp(-best.logY); // The tags are longer where the photos see less.
        frame.yOverX = Scale{value, value * sigma};
    }
    return frame;
}

namespace {

using FloorPlaces = std::span<const Eigen::Vector2d>;

/// The affine map from solved places to tags that fits best, both about their weighted middles.
struct TagFit {
    Eigen::Matrix2d tagsFromSolved;
    Eigen::Matrix2d covariance; ///< Of each row, for a variance of 1.
    Eigen::Vector2d middleOfTags;
    Eigen::Vector2d middle;

    double offM(const Eigen::Vector2d& tag, const Eigen::Vector2d& place) const {
        return (tag - middleOfTags - tagsFromSolved * (place - middle)).norm();
    }
};

TagFit fittedTags(FloorPlaces tagged, FloorPlaces solved, std::span<const double> weights) {
    constexpr double kTinyM2 = 1e-12; // photos on one line
    TagFit fit{Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Identity() * kTinyM2, Eigen::Vector2d::Zero(),
               Eigen::Vector2d::Zero()};
    double sum = 0;
    for (std::size_t i = 0; i < tagged.size();
         ++i) { // from the first one, so that large coordinates keep digits
        fit.middleOfTags += weights[i] * (tagged[i] - tagged[0]);
        fit.middle += weights[i] * (solved[i] - solved[0]);
        sum += weights[i];
    }
    fit.middleOfTags = tagged[0] + fit.middleOfTags / sum;
    fit.middle = solved[0] + fit.middle / sum;
    Eigen::Matrix2d normal = fit.covariance;
    for (std::size_t i = 0; i < tagged.size(); ++i) {
        const Eigen::Vector2d from = solved[i] - fit.middle;
        normal += weights[i] * from * from.transpose();
        fit.tagsFromSolved += weights[i] * (tagged[i] - fit.middleOfTags) * from.transpose();
    }
    fit.covariance = normal.inverse();
    fit.tagsFromSolved = fit.tagsFromSolved * fit.covariance;
    return fit;
}

} // namespace

std::optional<Scale> yOverX(std::span<const Eigen::Vector2d> tagged,
                            std::span<const Eigen::Vector2d> solved) {
    constexpr double kLeastScatterM = 1e-4;  // tags are not better
    constexpr double kMedianLength = 1.1774; // of a vector of two normal numbers
    constexpr double kUnknownSigma = 0.05;
    if (tagged.size() < kLeastPhotos) {
        return std::nullopt;
    }
    std::vector<double> weights(tagged.size(), 1);
    TagFit fit = fittedTags(tagged, solved, weights);
    double scatterM = 0;
    for (int round = 0; round < 20; ++round) {
        std::vector<double> offM;
        for (std::size_t i = 0; i < tagged.size(); ++i) {
            offM.push_back(fit.offM(tagged[i], solved[i]));
        }
        scatterM = std::max(median(offM) / kMedianLength, kLeastScatterM);
        for (std::size_t i = 0; i < tagged.size(); ++i) {
            const double ratio = offM[i] / (3 * scatterM);
            weights[i] = 1 / ((1 + ratio * ratio) * (1 + ratio * ratio));
        }
        fit = fittedTags(tagged, solved, weights);
    }
    // The rows are the axes of the tags, each with its own scale. What is worst known counts for both.
    const Eigen::Vector2d lengths = fit.tagsFromSolved.rowwise().norm();
    const double variance =
        scatterM * scatterM * fit.covariance.operatorNorm() * lengths.cwiseAbs2().cwiseInverse().sum();
    const double value = lengths.y() / lengths.x();
    const double sigma = value * std::sqrt(variance);
    return sigma < kUnknownSigma ? std::optional(Scale{value, sigma}) : std::nullopt; // NaN is unknown, too
}

namespace {

constexpr double kLeastParallaxRad = 0.02;
constexpr double kLeastDownSine = 0.3;
constexpr double kFloorBand = 0.02; ///< Half the width of a floor, in heights of the lens.
constexpr std::size_t kLeastOnFloor = 40;
constexpr double kFloorShare = 0.35; ///< Of the most points in one band: tables have more than a bare floor.

/// How far a thing lies below both lenses, in heights of the lens; nothing if the rays tell too little.
std::optional<double> depthBelow(const Rigid3& a, const Rigid3& b, const Correspondence& match) {
    const Eigen::Vector3d fromA = a.rotation * match.inA;
    const Eigen::Vector3d fromB = b.rotation * match.inB;
    const double across = fromA.cross(fromB).squaredNorm();
    if (across < kLeastParallaxRad * kLeastParallaxRad || fromA.z() > -kLeastDownSine) {
        return std::nullopt;
    }
    const Eigen::Vector3d apartM = b.translation - a.translation;
    const double alongM = apartM.cross(fromB).dot(fromA.cross(fromB)) / across;
    const double downM = -alongM * fromA.z();
    return alongM > 0 && a.translation.z() > 0 ? std::optional(downM / a.translation.z()) : std::nullopt;
}

} // namespace

std::optional<Scale> scaleByFloor(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                  std::span<const PhotoPair> pairs,
                                  std::span<const std::vector<bool>> isInlier) {
    std::vector<double> below;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto& a = roomFromPhoto[static_cast<std::size_t>(pairs[i].a)];
        const auto& b = roomFromPhoto[static_cast<std::size_t>(pairs[i].b)];
        for (std::size_t j = 0; a && b && j < pairs[i].matches.size(); ++j) {
            const auto depth = isInlier[i][j] ? depthBelow(*a, *b, pairs[i].matches[j]) : std::nullopt;
            if (depth && *depth > 0.5 && *depth < 2) {
                below.push_back(*depth);
            }
        }
    }
    std::ranges::sort(below);
    const auto around = [&](double depth) {
        return std::pair(std::ranges::lower_bound(below, depth * (1 - kFloorBand)),
                         std::ranges::upper_bound(below, depth * (1 + kFloorBand)));
    };
    std::vector<std::size_t> counts;
    for (const double depth : below) {
        const auto [first, last] = around(depth);
        counts.push_back(static_cast<std::size_t>(last - first));
    }
    const std::size_t most = counts.empty() ? 0 : std::ranges::max(counts);
    const auto enough =
        std::max(kLeastOnFloor, static_cast<std::size_t>(kFloorShare * static_cast<double>(most)));
    // The floor is the lowest band that many things lie in, at its fullest.
    std::size_t floor = below.size();
    for (std::size_t i = below.size(); i-- > 0;) {
        if (counts[i] >= enough &&
            (floor == below.size() ||
             (below[i] > below[floor] * (1 - 2 * kFloorBand) && counts[i] > counts[floor]))) {
            floor = i;
        }
    }
    if (floor == below.size()) {
        return std::nullopt;
    }
    const auto [first, last] = around(below[floor]);
    const std::vector<double> onFloor(first, last);
    // Matches of one thing in many pairs, and a floor that is not flat, leave a share of its width.
    constexpr double kFlatness = 0.01;
    return Scale{median(onFloor), kFlatness * below[floor]};
}

namespace {

/// The direction in which a photo of the pair has the other, in its own frame; empty if the pair does not
/// tell.
std::optional<Eigen::Vector3d> directionFrom(int photo, const PairEstimate& pair) {
    if (pair.verdict != PairVerdict::Constraint || !pair.baselineInA || !pair.baselineInA->allFinite()) {
        return std::nullopt;
    }
    return photo == pair.a ? *pair.baselineInA
                           : Eigen::Vector3d(pair.aFromB.conjugate() * -*pair.baselineInA);
}

/// Whether most third photos lie in other directions from one photo of the pair than from the other. The
/// pair's own matches are then of things that look alike, as doors do.
bool areApartByOthers(const PairEstimate& pair, std::span<const PairEstimate> estimates) {
    constexpr Radians kClearlyApart = Degrees(8);
    std::map<int, Eigen::Vector3d> fromA;
    for (const PairEstimate& other : estimates) {
        if (const auto direction = directionFrom(pair.a, other);
            direction && (other.a == pair.a || other.b == pair.a)) {
            fromA[other.a == pair.a ? other.b : other.a] = *direction;
        }
    }
    int apart = 0;
    int together = 0;
    for (const PairEstimate& other : estimates) {
        const auto seenFromA = fromA.find(other.a == pair.b ? other.b : other.a);
        const auto direction = directionFrom(pair.b, other);
        if ((other.a == pair.b || other.b == pair.b) && direction && seenFromA != fromA.end()) {
            ++(angleBetween(seenFromA->second, pair.aFromB * *direction) > kClearlyApart ? apart : together);
        }
    }
    return apart > together;
}

} // namespace

std::vector<OnePlace> photosAtOnePlace(std::span<const PhotoPrior> photos,
                                       std::span<const PairEstimate> estimates) {
    constexpr std::size_t kLeastPairs = 4;
    constexpr double kNoParallaxShare = 0.12;
    constexpr double kLeastAgreeing = 0.5;
    std::vector<double> perMetre;
    const auto apartM = [&](const PairEstimate& pair) {
        return (photos[static_cast<std::size_t>(pair.b)].positionM -
                photos[static_cast<std::size_t>(pair.a)].positionM)
            .norm();
    };
    const auto counts = [&](const PairEstimate& pair) {
        return pair.verdict == PairVerdict::Constraint && std::isfinite(pair.parallaxRad) &&
               apartM(pair) > kLeastApartM;
    };
    for (const PairEstimate& pair : estimates) {
        if (counts(pair)) {
            perMetre.push_back(pair.parallaxRad / apartM(pair));
        }
    }
    if (perMetre.size() < kLeastPairs) {
        return {};
    }
    const double usual = median(perMetre);
    std::vector<OnePlace> found;
    for (const PairEstimate& pair : estimates) {
        if (counts(pair) && pair.inlierShare > kLeastAgreeing &&
            pair.parallaxRad < kNoParallaxShare * usual * apartM(pair) &&
            !areApartByOthers(pair, estimates)) {
            found.push_back({pair.a, pair.b, apartM(pair)});
        }
    }
    return found;
}

} // namespace spherewalk::align
