// SPDX-License-Identifier: Apache-2.0
#include "layers/shown_errors.h"

#include "spherewalk/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// resources/docs/trust.md explains these numbers.
/// How exactly a depth's matching finds places in pictures, in pixels of the depth.
constexpr double kMatchedPx = 0.02;
/// Photos that stand closer together than this are not matched.
constexpr double kLeastBaselineM = 0.05;
/// The part of the mean disagreement with other photos' depths that a depth is off.
constexpr double kDisagreementShare = 0.34;
/// What one photo's disagreement counts at most, in 1/m: it may see something else there.
constexpr double kMostDisagreement = 0.3;
/// A depth that no other photo was asked about disagrees by this share.
constexpr double kUnaskedShare = 0.05;
/// The part of the spread of 1 / distance close by that a depth is off: slopes and edges are blurred.
constexpr double kSpreadShare = 0.03;
constexpr double kMostSpread = 0.6;
/// What a depth that is not sure is off, as a share.
constexpr double kUnsureShare = 0.15;
/// What a filled pixel is off, as a part of what the first photo contradicts, in 1/m.
constexpr double kFilledShare = 0.5;
constexpr double kMostContradiction = 1;
/// Distances that differ by less are of one thing.
constexpr double kSameShare = 0.06;
/// What lies farther beyond the room's walls is a mirror image, or is seen through a window.
constexpr double kBeyondM = 0.12;
/// A pixel is unsure if it may be off by more than this.
constexpr double kUnsurePx = 2;
constexpr double kUnsureSpreadShare = 0.2;
constexpr double kUnsureDisagreement = 0.03;

/// How many pixels a thing in this pixel moves for each radian that it moves in the direction. direction: a
/// unit vector across the ray.
double pixelsPerRadian(const CameraModel& camera, const Vector2d& pixel, const Vector3d& ray,
                       const Vector3d& direction) {
    constexpr double kStep = 1e-5; // radians: lenses are smooth at this scale, and ten digits are left
    const auto ahead = camera.project(ray + kStep * direction);
    const auto behind = camera.project(ray - kStep * direction);
    if (!ahead && !behind) { // the lens's field is a single point
        return std::max(camera.intrinsics().fx, camera.intrinsics().fy);
    }
    const double steps = ahead && behind ? 2 : 1;
    return (ahead.value_or(pixel) - behind.value_or(pixel)).norm() / (steps * kStep);
}

bool isBeyond(const RoomShape& room, const Vector3d& pInRoom) {
    return pInRoom.z() < room.floorM - kBeyondM || pInRoom.z() > room.ceilingM + kBeyondM ||
           (!contains(room.outline, pInRoom.head<2>()) &&
            distanceToEdge(room.outline, pInRoom.head<2>()) > kBeyondM);
}

} // namespace

/// The thing in a view of photos' depths: the first photo whose depth agrees shows it.
ShownErrors::Thing ShownErrors::ofDepths(const Vector3d& direction, double modelInverseM) const {
    const std::vector<PhotoEvidence>& photos = m_evidence.photos;
    Thing thing;
    thing.inverseM = modelInverseM;
    thing.fromCamera = direction / modelInverseM;
    thing.isFilled = thing.isDoubtful = true;
    for (std::size_t i = 0; i < m_evidence.shown; ++i) {
        if (!photos[i].depth) {
            continue;
        }
        const Vector3d place = inPhoto(i, direction, modelInverseM);
        const KnownDepth depth = photos[i].depth->at(place);
        const double ownM = modelInverseM / place.norm();
        const bool isSame = std::abs(depth.inverseM - ownM) < kSameShare * ownM;
        if (isSame || i == 0) {
            thing.source = i;
            thing.isFilled = !isSame;
            thing.isDoubtful = !isSame || !depth.isSure || !depth.isAmongSure ||
                               depth.spreadM > kUnsureSpreadShare * modelInverseM;
            thing.residualM =
                kSpreadShare * std::min(depth.spreadM, kMostSpread) +
                (depth.isSure ? 0 : kUnsureShare * modelInverseM) +
                (isSame ? 0 : kFilledShare * std::min(std::abs(depth.inverseM - ownM), kMostContradiction));
        }
        if (isSame) {
            break;
        }
    }
    return thing;
}

/// The thing in a view of a scene model that is not the photos' depths.
ShownErrors::Thing ShownErrors::ofFirst(const Vector3d& direction, double modelInverseM) const {
    const PhotoEvidence& photo = m_evidence.photos.front();
    const Vector3d towards = inPhoto(0, direction, modelInverseM).normalized();
    const KnownDepth depth = photo.depth->at(towards);
    Thing thing;
    thing.fromCamera = photo.roomFromPhoto.rotation * towards / depth.inverseM - m_offsets.front();
    thing.inverseM = 1 / std::max(thing.fromCamera.norm(), 1e-3);
    thing.residualM = kSpreadShare * std::min(depth.spreadM, kMostSpread) +
                      (depth.isSure ? 0 : kUnsureShare * thing.inverseM);
    thing.isDoubtful =
        !depth.isSure || !depth.isAmongSure || depth.spreadM > kUnsureSpreadShare * thing.inverseM;
    return thing;
}

/// Asks the other photos' depths what they know of the thing.
void ShownErrors::askOthers(Thing& thing) const {
    double sum = 0;
    double apartM = 0;
    int asked = 0;
    for (std::size_t i = 0; i < m_evidence.photos.size(); ++i) {
        if (i == thing.source || !m_evidence.photos[i].depth) {
            continue;
        }
        const Vector3d place = inPhoto(i, thing.fromCamera, 1);
        const double disagreement =
            std::abs(m_evidence.photos[i].depth->at(place).inverseM - 1 / place.norm());
        thing.isDoubtful = thing.isDoubtful || disagreement > kUnsureDisagreement;
        sum += std::min(disagreement, kMostDisagreement);
        apartM += (m_offsets[i] - m_offsets[thing.source]).norm();
        ++asked;
    }
    const double matchedM = asked > 0 ? kMatchedPx * m_evidence.photos[thing.source].depth->pixelRad() /
                                            std::max(apartM / asked, kLeastBaselineM)
                                      : 0;
    thing.residualM += 0.5 * DepthMap::kStepPerM + matchedM +
                       kDisagreementShare * (asked > 0 ? sum / asked : kUnaskedShare * thing.inverseM);
    if (m_evidence.room) {
        thing.isDoubtful = thing.isDoubtful ||
                           isBeyond(*m_evidence.room, m_view.roomFromCamera.translation + thing.fromCamera);
    }
}

ShownErrors::Thing ShownErrors::shown(const Vector3d& direction, double modelInverseM) const {
    if (m_evidence.photos.front().depth) {
        Thing thing =
            m_evidence.showsDepths ? ofDepths(direction, modelInverseM) : ofFirst(direction, modelInverseM);
        askOthers(thing);
        return thing;
    }
    Thing thing;
    thing.inverseM = modelInverseM > 0 ? modelInverseM : 1 / m_view.sphereRadiusM;
    thing.fromCamera = direction / thing.inverseM;
    thing.residualM = m_evidence.priorShare * thing.inverseM;
    thing.isDoubtful = true;
    return thing;
}

ShownError ShownErrors::at(int x, int y, const Vector3d& ray) const {
    const double model = modelInverseM(x, y, ray);
    const Thing thing = shown(m_view.roomFromCamera.rotation * ray, model);
    const PhotoEvidence& source = m_evidence.photos[thing.source];
    const Vector3d offset = m_view.roomFromCamera.rotation.conjugate() * m_offsets[thing.source];
    const Vector3d across = offset - offset.dot(ray) * ray;
    const double acrossM = across.norm();
    const Vector3d unit = acrossM > 0 ? Vector3d(across / acrossM) : ray.unitOrthogonal();
    const double perRadian = pixelsPerRadian(m_camera, Vector2d(x, y), ray, unit);
    const double inverseError =
        m_evidence.showsDepths ? thing.residualM : std::hypot(model - thing.inverseM, thing.residualM);
    ShownError error;
    error.px = perRadian * std::hypot(acrossM * inverseError, source.rotationSigmaRad,
                                      source.positionSigmaM * thing.inverseM);
    error.isFilled = thing.isFilled;
    error.isUnsure =
        error.px > kUnsurePx || (thing.isDoubtful && perRadian * acrossM * thing.inverseM > kUnsurePx);
    if (!m_evidence.isKnown || std::isnan(error.px)) { // NaN: a camera at 10^300 m
        error.px = std::numeric_limits<double>::infinity();
        error.isUnsure = true;
    }
    return error;
}

} // namespace spherewalk::render
