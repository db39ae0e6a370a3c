// SPDX-License-Identifier: Apache-2.0
#include "layers/shown_errors.h"

#include "sphere/lattice_simd.h"

#include "spherewalk/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

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
constexpr double kDisagreementShare = 0.28;
/// What one photo's disagreement counts at most, in 1/m: it may see something else there.
constexpr double kMostDisagreement = 0.3;
/// A depth that no other photo was asked about disagrees by this share.
constexpr double kUnaskedShare = 0.05;
/// The part of the spread of 1 / distance close by that a depth is off: slopes and edges are blurred.
constexpr double kSpreadShare = 0.025;
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

/// Whether a point lies inside of an outline. Points on an edge may count as either.
bool isInside(const Polygon& outline, const Vector2d& point) {
    bool isInside = false;
    Vector2d a = outline.back() - point;
    for (const Vector2d& corner : outline) {
        const Vector2d b = corner - point;
        if ((a.y() > 0) != (b.y() > 0)) {
            isInside ^= (b.y() > a.y()) == (a.x() * b.y() > a.y() * b.x());
        }
        a = b;
    }
    return isInside;
}

bool isBeyond(const RoomShape& room, const Vector3d& pInRoom) {
    return pInRoom.z() < room.floorM - kBeyondM || pInRoom.z() > room.ceilingM + kBeyondM ||
           (!isInside(room.outline, pInRoom.head<2>()) &&
            distanceToEdge(room.outline, pInRoom.head<2>()) > kBeyondM);
}

} // namespace

void look(const DepthEvidence& depth, const Eigen::Matrix3d& photoFrom, const Directions& directions,
          std::span<KnownDepth> known) {
    std::vector<double> u(known.size() + Directions::kMore);
    std::vector<double> v(u.size());
    simd::photoCoordinates(LatticeFrame(photoFrom, depth.size()),
                           {directions.component(0), directions.component(1), directions.component(2)},
                           static_cast<int>(known.size()), {u.data(), v.data(), nullptr, nullptr});
    for (std::size_t i = 0; i < known.size(); ++i) {
        known[i] = depth.at(u[i], v[i]);
    }
}

ShownErrors::ShownErrors(const SceneRays& scene, const ViewGeometry& view, const ViewEvidence& evidence)
    : m_camera(view.rays.camera()),
      m_scene(scene),
      m_view(view),
      m_evidence(evidence),
      m_roomFromCamera(view.roomFromCamera.rotation.toRotationMatrix()) {
    for (const PhotoEvidence& photo : evidence.photos) {
        m_offsets.push_back(view.roomFromCamera.translation - photo.roomFromPhoto.translation);
        m_offsetsInCamera.push_back(m_roomFromCamera.transpose() * m_offsets.back());
        m_photoFromRoom.push_back(photo.roomFromPhoto.rotation.conjugate().toRotationMatrix());
    }
}

ShownErrors::Modelled ShownErrors::modelled(const ViewPixel& pixel) const {
    Modelled model{m_roomFromCamera * pixel.ray, 0};
    if (m_evidence.inverseM) {
        model.inverseM = m_evidence.inverseM(pixel.x, pixel.y, pixel.ray);
    } else if (const double distance = m_scene.distanceM(pixel.ray); std::isfinite(distance)) {
        model.inverseM = 1 / distance;
    }
    return model;
}

/// Whether the photo's depth agrees with the model, so that the photo shows the thing. What is known of the
/// thing is then told. It is told of the first photo in any case.
bool ShownErrors::isShownBy(std::size_t photo, const Modelled& model, const Vector3d& place,
                            const KnownDepth& depth, Thing& thing) const {
    const double ownM = model.inverseM / place.norm();
    const bool isSame = std::abs(depth.inverseM - ownM) < kSameShare * ownM;
    if (isSame || photo == 0) {
        thing.source = photo;
        thing.isFilled = !isSame;
        thing.isDoubtful = !isSame || !depth.isSure || !depth.isAmongSure ||
                           depth.spreadM > kUnsureSpreadShare * model.inverseM;
        thing.residualM =
            kSpreadShare * std::min(depth.spreadM, kMostSpread) +
            (depth.isSure ? 0 : kUnsureShare * model.inverseM) +
            (isSame ? 0 : kFilledShare * std::min(std::abs(depth.inverseM - ownM), kMostContradiction));
    }
    return isSame;
}

/// The things in a view of photos' depths: the first photo whose depth agrees shows a thing.
std::vector<ShownErrors::Thing> ShownErrors::ofDepths(std::span<const Modelled> models) const {
    std::vector<Thing> things(models.size());
    std::vector<std::size_t> open; // no photo shows these yet
    for (std::size_t k = 0; k < models.size(); ++k) {
        things[k].inverseM = models[k].inverseM;
        things[k].fromCamera = models[k].direction / models[k].inverseM;
        things[k].isFilled = things[k].isDoubtful = true;
        open.push_back(k);
    }
    Directions places(models.size());
    std::vector<KnownDepth> depths(models.size());
    for (std::size_t i = 0; i < m_evidence.shown && !open.empty(); ++i) {
        const std::shared_ptr<const DepthEvidence>& depth = m_evidence.photos[i].depth;
        if (!depth) {
            continue;
        }
        const auto place = [&](std::size_t k) {
            return fromPhoto(i, models[k].direction, models[k].inverseM);
        };
        for (std::size_t j = 0; j < open.size(); ++j) {
            places.set(j, place(open[j]));
        }
        look(*depth, m_photoFromRoom[i], places, std::span(depths).first(open.size()));
        std::size_t left = 0;
        for (std::size_t j = 0; j < open.size(); ++j) {
            const std::size_t k = open[j];
            if (!isShownBy(i, models[k], place(k), depths[j], things[k])) {
                open[left++] = k;
            }
        }
        open.resize(left);
    }
    return things;
}

/// The things in a view of a scene model that is not the photos' depths.
std::vector<ShownErrors::Thing> ShownErrors::ofFirst(std::span<const Modelled> models) const {
    Directions places(models.size());
    for (std::size_t k = 0; k < models.size(); ++k) {
        places.set(k, fromPhoto(0, models[k].direction, models[k].inverseM));
    }
    std::vector<KnownDepth> depths(models.size());
    look(*m_evidence.photos.front().depth, m_photoFromRoom.front(), places, depths);
    std::vector<Thing> things(models.size());
    for (std::size_t k = 0; k < models.size(); ++k) {
        const KnownDepth& depth = depths[k];
        Thing& thing = things[k];
        thing.fromCamera =
            fromPhoto(0, models[k].direction, models[k].inverseM).normalized() / depth.inverseM -
            m_offsets.front();
        thing.inverseM = 1 / std::max(thing.fromCamera.norm(), 1e-3);
        thing.residualM = kSpreadShare * std::min(depth.spreadM, kMostSpread) +
                          (depth.isSure ? 0 : kUnsureShare * thing.inverseM);
        thing.isDoubtful =
            !depth.isSure || !depth.isAmongSure || depth.spreadM > kUnsureSpreadShare * thing.inverseM;
    }
    return things;
}

/// The thing in a view of photos without depths.
ShownErrors::Thing ShownErrors::ofPrior(const Modelled& model) const {
    Thing thing;
    thing.inverseM = model.inverseM > 0 ? model.inverseM : 1 / m_view.sphereRadiusM;
    thing.fromCamera = model.direction / thing.inverseM;
    thing.residualM = m_evidence.priorShare * thing.inverseM;
    thing.isDoubtful = true;
    return thing;
}

/// Asks the other photos' depths what they know of the things.
void ShownErrors::askOthers(std::span<Thing> things) const {
    std::vector<Answers> answers(things.size());
    Directions places(things.size());
    std::vector<KnownDepth> depths(things.size());
    std::vector<std::size_t> asked;
    for (std::size_t i = 0; i < m_evidence.photos.size(); ++i) {
        const std::shared_ptr<const DepthEvidence>& depth = m_evidence.photos[i].depth;
        asked.clear();
        for (std::size_t k = 0; k < things.size() && depth; ++k) {
            if (i != things[k].source) {
                places.set(asked.size(), fromPhoto(i, things[k].fromCamera, 1));
                asked.push_back(k);
            }
        }
        if (asked.empty()) {
            continue;
        }
        look(*depth, m_photoFromRoom[i], places, std::span(depths).first(asked.size()));
        for (std::size_t j = 0; j < asked.size(); ++j) {
            Thing& thing = things[asked[j]];
            Answers& answer = answers[asked[j]];
            const double disagreement =
                std::abs(depths[j].inverseM - 1 / fromPhoto(i, thing.fromCamera, 1).norm());
            thing.isDoubtful = thing.isDoubtful || disagreement > kUnsureDisagreement;
            answer.sum += std::min(disagreement, kMostDisagreement);
            answer.apartM += (m_offsets[i] - m_offsets[thing.source]).norm();
            ++answer.asked;
        }
    }
    for (std::size_t k = 0; k < things.size(); ++k) {
        judge(answers[k], things[k]);
    }
}

void ShownErrors::judge(const Answers& answers, Thing& thing) const {
    const auto& [sum, apartM, asked] = answers;
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

std::vector<ShownErrors::Thing> ShownErrors::shown(std::span<const Modelled> models) const {
    std::vector<Thing> things;
    if (m_evidence.photos.front().depth) {
        things = m_evidence.showsDepths ? ofDepths(models) : ofFirst(models);
        askOthers(things);
        return things;
    }
    std::transform(models.begin(), models.end(), std::back_inserter(things),
                   [&](const Modelled& model) { return ofPrior(model); });
    return things;
}

ShownError ShownErrors::error(const ViewPixel& pixel, double modelInverseM, const Thing& thing) const {
    const PhotoEvidence& source = m_evidence.photos[thing.source];
    const Vector3d& offset = m_offsetsInCamera[thing.source];
    const Vector3d across = offset - offset.dot(pixel.ray) * pixel.ray;
    const double acrossM = across.norm();
    const Vector3d unit = acrossM > 0 ? Vector3d(across / acrossM) : pixel.ray.unitOrthogonal();
    const double perRadian = pixelsPerRadian(m_camera, Vector2d(pixel.x, pixel.y), pixel.ray, unit);
    const double inverseError = m_evidence.showsDepths
                                    ? thing.residualM
                                    : std::hypot(modelInverseM - thing.inverseM, thing.residualM);
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

std::vector<ShownError> ShownErrors::of(std::span<const ViewPixel> pixels) const {
    std::vector<Modelled> models;
    models.reserve(pixels.size());
    for (const ViewPixel& pixel : pixels) {
        models.push_back(modelled(pixel));
    }
    const std::vector<Thing> things = shown(models);
    std::vector<ShownError> errors;
    errors.reserve(pixels.size());
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        errors.push_back(error(pixels[k], models[k].inverseM, things[k]));
    }
    return errors;
}

} // namespace spherewalk::render
