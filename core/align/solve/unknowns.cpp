// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/unknowns.h"

#include "pairs/pair_geometry.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace spherewalk::align {

namespace {

// Cameras make photos upright. A photo that states no tilt is taken for upright, with this uncertainty.
constexpr double kUnsaidTiltRad = 0.17;

Eigen::Vector3d vectorOf(const Unknowns::Block& block) {
    return {block[0], block[1], block[2]};
}

} // namespace

PhotoState Unknowns::state(std::size_t i) const {
    PhotoState state{spherewalk::turn(vectorOf(turn[i])) * reference[i], plannedM[i] + vectorOf(offset[i]),
                     lenses};
    if (rail[i] >= 0) {
        const auto on = static_cast<std::size_t>(rail[i]);
        const Eigen::Vector3d fromCentre = plannedM[i] - railCentreM[on];
        const Block& moved = placement[on];
        state.positionM +=
            yawRotation(Radians(moved[2])) * fromCentre - fromCentre + Eigen::Vector3d(moved[0], moved[1], 0);
    }
    return state;
}

std::vector<PhotoState> Unknowns::states() const {
    std::vector<PhotoState> all;
    all.reserve(photo.size());
    for (std::size_t i = 0; i < photo.size(); ++i) {
        all.push_back(state(i));
    }
    return all;
}

Eigen::Matrix3d Unknowns::positionByPlacement(std::size_t i) const {
    Eigen::Matrix3d by = Eigen::Matrix3d::Zero();
    if (rail[i] >= 0) {
        const auto on = static_cast<std::size_t>(rail[i]);
        const Eigen::Vector3d turned =
            yawRotation(Radians(placement[on][2])) * (plannedM[i] - railCentreM[on]);
        by(0, 0) = 1;
        by(1, 1) = 1;
        by.col(2) = Eigen::Vector3d::UnitZ().cross(turned);
    }
    return by;
}

void Unknowns::rebase() {
    for (std::size_t i = 0; i < photo.size(); ++i) {
        reference[i] = (spherewalk::turn(vectorOf(turn[i])) * reference[i]).normalized();
        turn[i] = {};
    }
}

Unknowns unknowns(std::span<const int> photos, std::span<const PhotoPrior> priors,
                  std::span<const Eigen::Quaterniond> roomFromPhoto) {
    Unknowns made;
    made.photo.assign(photos.begin(), photos.end());
    made.reference.assign(roomFromPhoto.begin(), roomFromPhoto.end());
    const Eigen::Vector3d origin = priors[static_cast<std::size_t>(photos.front())].positionM;
    std::map<int, int> railOf;
    std::vector<int> stops;
    for (const int photo : photos) {
        const PhotoPrior& prior = priors[static_cast<std::size_t>(photo)];
        made.plannedM.push_back(prior.positionM - origin);
        if (prior.placement < 0) {
            made.rail.push_back(-1);
            continue;
        }
        const auto [entry, isNew] = railOf.try_emplace(prior.placement, static_cast<int>(railOf.size()));
        made.rail.push_back(entry->second);
        if (isNew) {
            made.railCentreM.push_back(Eigen::Vector3d::Zero());
            stops.push_back(0);
        }
        made.railCentreM[static_cast<std::size_t>(entry->second)] += made.plannedM.back();
        ++stops[static_cast<std::size_t>(entry->second)];
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
        made.railCentreM[i] /= stops[i];
    }
    made.turn.assign(photos.size(), {});
    made.offset.assign(photos.size(), {});
    made.placement.assign(stops.size(), {});
    return made;
}

void level(Unknowns& unknowns, std::span<const PhotoPrior> priors) {
    unknowns.rebase();
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const PhotoPrior& prior = priors[static_cast<std::size_t>(unknowns.photo[i])];
        const Eigen::Quaterniond levelFromPhoto = align::levelFromPhoto(prior);
        // The turn about z that is nearest to a rotation has a quaternion with the same w and z.
        const Eigen::Quaterniond roomFromLevel = unknowns.reference[i] * levelFromPhoto.conjugate();
        const double heading = 2 * std::atan2(roomFromLevel.z(), roomFromLevel.w());
        unknowns.reference[i] = yawRotation(Radians(heading)) * levelFromPhoto;
    }
}

Eigen::Vector3d offsetSigmasM(const PhotoPrior& prior) {
    // Even a sure prior must leave room for rounding.
    return Eigen::Vector3d(prior.positionSigmaM, prior.positionSigmaM, prior.heightSigmaM).cwiseMax(1e-5);
}

Eigen::Vector3d offsetFreedom(const Unknowns& unknowns) {
    const auto photos = static_cast<double>(unknowns.photo.size());
    const auto rails = static_cast<double>(unknowns.placement.size());
    return {photos - 2 - 1.5 * rails, photos - 2 - 1.5 * rails, photos - 3};
}

PriorScatter priorScatter(const Unknowns& unknowns, std::span<const PhotoPrior> priors) {
    constexpr double kMedianOfNormal = 0.6745; // of an absolute value, in standard deviations
    std::vector<double> along;
    std::vector<double> height;
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const Eigen::Vector3d sigmas = offsetSigmasM(priors[static_cast<std::size_t>(unknowns.photo[i])]);
        const Eigen::Vector3d off = Eigen::Map<const Eigen::Vector3d>(unknowns.offset[i].data());
        const Eigen::Vector3d over = off.cwiseQuotient(sigmas).cwiseAbs();
        along.insert(along.end(), {over.x(), over.y()});
        height.push_back(over.z());
    }
    const auto photos = static_cast<double>(unknowns.photo.size());
    const auto scatter = [photos](std::vector<double> offsets, double freedom) {
        return freedom > 0 ? median(std::move(offsets)) / kMedianOfNormal * std::sqrt(photos / freedom) : 1;
    };
    const Eigen::Vector3d freedom = offsetFreedom(unknowns);
    return {scatter(std::move(along), freedom.x()), scatter(std::move(height), freedom.z())};
}

double waySigmaM(const PhotoPrior& a, const PhotoPrior& b) {
    return std::hypot(a.positionSigmaM, b.positionSigmaM);
}

double tagMisfit(const Unknowns& unknowns, std::span<const PhotoPrior> priors) {
    constexpr double kMost = 3;
    double sum = 0;
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const Eigen::Vector3d sigmas = offsetSigmasM(priors[static_cast<std::size_t>(unknowns.photo[i])]);
        const double off = std::hypot(unknowns.offset[i][0] / sigmas.x(), unknowns.offset[i][1] / sigmas.y());
        sum += std::min(off, kMost) * std::min(off, kMost);
    }
    return std::sqrt(sum / static_cast<double>(unknowns.photo.size()));
}

double commonLeanScatter(const Unknowns& unknowns, std::span<const PhotoPrior> priors) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weights = 0;
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const Vertical up = knownUp(priors[static_cast<std::size_t>(unknowns.photo[i])]);
        const double weight = 1 / (up.sigmaRad * up.sigmaRad);
        sum += weight * leanOf(unknowns.state(i).roomFromPhoto * up.upInPhoto).vectorRad;
        weights += weight;
    }
    const double variance = static_cast<double>(unknowns.photo.size()) / weights + 1 / weights;
    return (sum / weights).norm() / std::sqrt(variance);
}

Vertical statedUp(const PhotoPrior& prior) {
    if (!prior.levelFromPhoto) {
        return {Eigen::Vector3d::UnitZ(), kUnsaidTiltRad};
    }
    return {prior.levelFromPhoto->normalized().conjugate() * Eigen::Vector3d::UnitZ(),
            std::max(prior.tiltSigma.value(), 1e-5)};
}

namespace {

bool believesItsEdges(const PhotoPrior& prior) {
    constexpr double kContradiction = 5; // standard deviations of what is stated
    const Vertical stated = statedUp(prior);
    return prior.seenVertical &&
           (!prior.levelFromPhoto || angleBetween(prior.seenVertical->upInPhoto, stated.upInPhoto).value() <=
                                         kContradiction * stated.sigmaRad);
}

} // namespace

Vertical knownUp(const PhotoPrior& prior) {
    constexpr double kBuiltRad = 1.7e-3; // Walls and doors stand upright to about 0.1 degrees.
    if (!believesItsEdges(prior)) {
        return statedUp(prior);
    }
    return {prior.seenVertical->upInPhoto, std::hypot(prior.seenVertical->sigmaRad, kBuiltRad)};
}

bool saysUp(const PhotoPrior& prior) {
    return prior.levelFromPhoto || believesItsEdges(prior);
}

Eigen::Quaterniond levelFromPhoto(const PhotoPrior& prior) {
    const Eigen::Quaterniond stated =
        prior.levelFromPhoto.value_or(Eigen::Quaterniond::Identity()).normalized();
    return (uprightFrom(stated * knownUp(prior).upInPhoto) * stated).normalized();
}

Lean leanOf(const Eigen::Vector3d& up) {
    // Below this sine the direction of the lean is taken for known, and its derivative for finite.
    constexpr double kLeastLeanSine = 1e-4;
    const double sine = up.head<2>().norm();
    const double angle = std::atan2(sine, up.z());
    Lean lean;
    if (sine < kLeastLeanSine && up.z() > 0) { // The angle is its own sine here.
        lean.vectorRad = up.head<2>();
        lean.byTurn = -skew(up).topRows<2>();
        return lean;
    }
    const Eigen::Vector2d towards =
        sine > 1e-12 ? Eigen::Vector2d(up.head<2>() / sine) : Eigen::Vector2d::UnitX();
    const Eigen::Vector2d across(-towards.y(), towards.x());
    const double bounded = std::max(sine, kLeastLeanSine);
    lean.vectorRad = angle * towards;
    // A turn about `across` leans farther; one about z or `towards` leans another way.
    lean.byTurn.leftCols<2>() =
        towards * across.transpose() - across * towards.transpose() * (angle * up.z() / bounded);
    lean.byTurn.col(2) = angle * across;
    return lean;
}

} // namespace spherewalk::align
