// SPDX-License-Identifier: Apache-2.0
#include "dataset/evidence.h"
#include "layers/view_geometry.h"
#include "sphere/exact_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// One worker does so many rows in turn: neighbouring rows share their rays.
constexpr int kTrustRows = 8;

// resources/docs/trust.md explains these numbers.
/// How far 1 / distance spreads in rooms, as a share, where nothing was measured.
constexpr double kPriorShare = 0.3;
/// How exactly a depth's matching finds places in pictures, in pixels of the depth.
constexpr double kMatchedPx = 0.02;
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
/// The view's own error is the median of so many pixels.
constexpr int kColumns = 16;
constexpr int kRows = 12;

[[noreturn]] void refuseTrust(const std::string& what) {
    throw Error(ErrorKind::InvalidInput, text("The trust of the view's pixels cannot be told: ", what, "."));
}

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

/// How far a pixel's thing may be displaced.
struct ShownError {
    double px = 0;
    bool isFilled = false;
    bool isUnsure = false;
};

unsigned bits(const ShownError& error) {
    return (error.isFilled ? static_cast<unsigned>(PixelFlag::Filled) : 0U) |
           (error.isUnsure ? static_cast<unsigned>(PixelFlag::Unsure) : 0U);
}

/// The errors of a view's pixels. Frames: rays are unit vectors of the camera's optical frame. Owner: all
/// that it is made from must outlive it.
class ShownErrors {
  public:
    ShownErrors(const SceneRays& scene, const ViewGeometry& view, const TrustOptions& options)
        : m_camera(view.rays.camera()), m_scene(scene), m_view(view), m_options(options) {
        if (options.evidence != nullptr) {
            for (const PhotoEvidence& photo : options.evidence->photos) {
                m_offsets.push_back(view.roomFromCamera.translation - photo.roomFromPhoto.translation);
            }
        }
    }

    ShownError at(int x, int y, const Vector3d& ray) const {
        return m_options.evidence != nullptr ? known(x, y, ray) : ShownError{assumedPx(x, y, ray)};
    }

  private:
    /// What is known of the thing that a pixel shows.
    struct Thing {
        std::size_t source = 0; ///< The photo that shows it.
        double inverseM = 0;    ///< 1 / its distance from the camera.
        double residualM = 0;   ///< The error of that.
        Vector3d fromCamera;    ///< Frames: room.
        bool isFilled = false;
        bool isDoubtful = false;
    };

    double modelInverseM(int x, int y, const Vector3d& ray) const {
        if (m_options.evidence->inverseM) {
            return m_options.evidence->inverseM(x, y, ray);
        }
        const double distance = m_scene.distanceM(ray);
        return std::isfinite(distance) ? 1 / distance : 0;
    }

    /// The place, in a photo's frame and times any factor, of what lies there from the camera.
    Vector3d inPhoto(std::size_t photo, const Vector3d& direction, double inverseM) const {
        return m_options.evidence->photos[photo].roomFromPhoto.rotation.conjugate() *
               (direction + inverseM * m_offsets[photo]);
    }

    double assumedPx(int x, int y, const Vector3d& ray) const;
    ShownError known(int x, int y, const Vector3d& ray) const;
    Thing shown(const Vector3d& direction, double modelInverseM) const;
    Thing ofDepths(const Vector3d& direction, double modelInverseM) const;
    Thing ofFirst(const Vector3d& direction, double modelInverseM) const;
    void askOthers(Thing& thing) const;

    const CameraModel& m_camera;
    const SceneRays& m_scene;
    const ViewGeometry& m_view;
    const TrustOptions& m_options;
    std::vector<Vector3d> m_offsets; ///< The camera minus each photo. Frames: room.
};

/// The displacement if all that is known is the scene model.
double ShownErrors::assumedPx(int x, int y, const Vector3d& ray) const {
    const Vector3d& offset = m_scene.offsetInCamera();
    const Vector3d across = offset - offset.dot(ray) * ray;
    const double acrossM = across.norm();
    if (!(acrossM > 0)) {
        return 0;
    }
    const double modelM = m_scene.distanceM(ray);
    const double distanceM = std::isfinite(modelM) ? modelM : m_view.sphereRadiusM;
    return pixelsPerRadian(m_camera, Vector2d(x, y), ray, across / acrossM) * acrossM *
           m_options.distanceResidual / distanceM;
}

/// The thing in a view of photos' depths: the first photo whose depth agrees shows it.
ShownErrors::Thing ShownErrors::ofDepths(const Vector3d& direction, double modelInverseM) const {
    const std::vector<PhotoEvidence>& photos = m_options.evidence->photos;
    Thing thing;
    thing.inverseM = modelInverseM;
    thing.fromCamera = direction / modelInverseM;
    thing.isFilled = thing.isDoubtful = true;
    for (std::size_t i = 0; i < m_options.evidence->shown; ++i) {
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
    const PhotoEvidence& photo = m_options.evidence->photos.front();
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
    const ViewEvidence& evidence = *m_options.evidence;
    double sum = 0;
    double apartM = 0;
    int asked = 0;
    for (std::size_t i = 0; i < evidence.photos.size(); ++i) {
        if (i == thing.source || !evidence.photos[i].depth) {
            continue;
        }
        const Vector3d place = inPhoto(i, thing.fromCamera, 1);
        const double disagreement = std::abs(evidence.photos[i].depth->at(place).inverseM - 1 / place.norm());
        thing.isDoubtful = thing.isDoubtful || disagreement > kUnsureDisagreement;
        sum += std::min(disagreement, kMostDisagreement);
        apartM += (m_offsets[i] - m_offsets[thing.source]).norm();
        ++asked;
    }
    const double matchedM =
        asked > 0 ? kMatchedPx * evidence.photos[thing.source].depth->pixelRad() * asked / apartM : 0;
    thing.residualM += 0.5 * DepthMap::kStepPerM + matchedM +
                       kDisagreementShare * (asked > 0 ? sum / asked : kUnaskedShare * thing.inverseM);
    if (evidence.room) {
        thing.isDoubtful = thing.isDoubtful ||
                           isBeyond(*evidence.room, m_view.roomFromCamera.translation + thing.fromCamera);
    }
}

ShownErrors::Thing ShownErrors::shown(const Vector3d& direction, double modelInverseM) const {
    const ViewEvidence& evidence = *m_options.evidence;
    if (evidence.photos.front().depth) {
        Thing thing =
            evidence.showsDepths ? ofDepths(direction, modelInverseM) : ofFirst(direction, modelInverseM);
        askOthers(thing);
        return thing;
    }
    Thing thing;
    thing.inverseM = modelInverseM > 0 ? modelInverseM : 1 / m_view.sphereRadiusM;
    thing.fromCamera = direction / thing.inverseM;
    thing.residualM = kPriorShare * thing.inverseM;
    thing.isDoubtful = true;
    return thing;
}

ShownError ShownErrors::known(int x, int y, const Vector3d& ray) const {
    const ViewEvidence& evidence = *m_options.evidence;
    const double model = modelInverseM(x, y, ray);
    const Thing thing = shown(m_view.roomFromCamera.rotation * ray, model);
    const PhotoEvidence& source = evidence.photos[thing.source];
    const Vector3d offset = m_view.roomFromCamera.rotation.conjugate() * m_offsets[thing.source];
    const Vector3d across = offset - offset.dot(ray) * ray;
    const double acrossM = across.norm();
    const Vector3d unit = acrossM > 0 ? Vector3d(across / acrossM) : ray.unitOrthogonal();
    const double perRadian = pixelsPerRadian(m_camera, Vector2d(x, y), ray, unit);
    const double inverseError = evidence.showsDepths ? evidence.residualShare * thing.residualM
                                                     : std::hypot(model - thing.inverseM, thing.residualM);
    ShownError error;
    error.px = perRadian * std::hypot(acrossM * inverseError, source.rotationSigmaRad,
                                      source.positionSigmaM * thing.inverseM);
    error.isFilled = thing.isFilled;
    error.isUnsure =
        error.px > kUnsurePx || (thing.isDoubtful && perRadian * acrossM * thing.inverseM > kUnsurePx);
    if (!evidence.isKnown || std::isnan(error.px)) { // NaN: a camera at 10^300 m
        error.px = std::numeric_limits<double>::infinity();
        error.isUnsure = true;
    }
    return error;
}

class TrustRows {
  public:
    TrustRows(const ViewGeometry& view, const TrustOptions& options)
        : m_rays(view.rays),
          m_scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM),
          m_options(options),
          m_errors(m_scene, view, options),
          m_photoPixel(2 * std::numbers::pi / view.photo.width),
          m_sinPole(std::sin(std::min(Radians(options.poleRadius).value(), std::numbers::pi / 2))),
          m_sinStitching(
              std::sin(std::min(Radians(options.stitchingHalfWidth).value(), std::numbers::pi / 2))) {}

    /// Computes the rows [begin, end).
    void compute(int begin, int end, PixelTrust& trust) const;

  private:
    struct Seen {
        Vector3d ray;     ///< Frame: optical. It is zero where the lens sees nothing.
        Vector3d inPhoto; ///< A unit vector of the photo's frame.
    };

    using Row = std::vector<Seen>;

    Row seen(int y) const;
    double footprint(const Row& row, const Row& other, std::size_t x) const;
    double blurPx(double footprint) const;
    std::uint8_t flags(const Vector3d& inPhoto, double footprint, bool isBlurred) const;
    void computeRow(int y, const Row& row, const Row& other, PixelTrust& trust) const;

    const PixelRays& m_rays;
    SceneRays m_scene;
    const TrustOptions& m_options;
    ShownErrors m_errors;
    double m_photoPixel; ///< Radians that a pixel of the photo spans at the equator.
    double m_sinPole;
    double m_sinStitching;
};

TrustRows::Row TrustRows::seen(int y) const {
    Row row(static_cast<std::size_t>(m_rays.camera().width()));
    for (int x = 0; x < m_rays.camera().width(); ++x) {
        const Vector3d ray = m_rays.ray(x, y);
        row[static_cast<std::size_t>(x)] = {ray, m_scene.directionInPhoto(ray)};
    }
    return row;
}

/// The angle in the photo between the pixel and its neighbours, along the axis of the view that has more.
double TrustRows::footprint(const Row& row, const Row& other, std::size_t x) const {
    double most = 0;
    const auto measure = [&](const Seen& neighbour) {
        if (!neighbour.ray.isZero(0)) {
            most = std::max(most, (neighbour.inPhoto - row[x].inPhoto).squaredNorm());
        }
    };
    if (row.size() > 1) {
        measure(x + 1 < row.size() ? row[x + 1] : row[x - 1]);
    }
    if (!other.empty()) {
        measure(other[x]);
    }
    const CameraIntrinsics& k = m_rays.camera().intrinsics();
    return most > 0 ? std::sqrt(most) : 1 / std::min(k.fx, k.fy);
}

double TrustRows::blurPx(double footprint) const {
    const double full = m_photoPixel / footprint; // view pixels that one pixel of the photo spans
    return 0.5 * std::max(0.0, m_options.coarseness * full - std::max(1.0, full));
}

std::uint8_t TrustRows::flags(const Vector3d& inPhoto, double footprint, bool isBlurred) const {
    const double level = inPhoto.head<2>().norm();
    const double seamReach = 0.5 * (footprint + level * m_photoPixel); // of bilinear samples in the pixel
    unsigned result = 0;
    const auto set = [&](bool holds, PixelFlag flag) { result |= holds ? static_cast<unsigned>(flag) : 0U; };
    set(level < m_sinPole, PixelFlag::Pole);
    set(std::abs(inPhoto.x()) < m_sinStitching, PixelFlag::Stitching);
    set(inPhoto.x() <= 0 && std::abs(inPhoto.y()) <= seamReach, PixelFlag::Seam);
    set(isBlurred, PixelFlag::Coarse);
    return static_cast<std::uint8_t>(result);
}

void TrustRows::computeRow(int y, const Row& row, const Row& other, PixelTrust& trust) const {
    for (int x = 0; x < m_rays.camera().width(); ++x) {
        const auto& [ray, inPhoto] = row[static_cast<std::size_t>(x)];
        if (ray.isZero(0)) {
            *trust.errorPx.at(x, y) = std::numeric_limits<float>::infinity();
            *trust.flags.at(x, y) = static_cast<std::uint8_t>(PixelFlag::Unseen);
        } else {
            const double angle = footprint(row, other, static_cast<std::size_t>(x));
            const double blur = blurPx(angle);
            const ShownError error = m_errors.at(x, y, ray);
            *trust.errorPx.at(x, y) = static_cast<float>(error.px + blur);
            *trust.flags.at(x, y) = static_cast<std::uint8_t>(flags(inPhoto, angle, blur > 0) | bits(error));
        }
        if (m_options.overlays != nullptr && *m_options.overlays->at(x, y) != 0) {
            *trust.flags.at(x, y) |= static_cast<std::uint8_t>(PixelFlag::Overlay);
        }
    }
}

void TrustRows::compute(int begin, int end, PixelTrust& trust) const {
    const int height = m_rays.camera().height();
    Row row = seen(begin);
    for (int y = begin; y < end; ++y) {
        Row other = y + 1 < height ? seen(y + 1) : y > 0 ? seen(y - 1) : Row();
        computeRow(y, row, other, trust);
        row.swap(other);
    }
}

} // namespace

void TrustOptions::validate() const {
    for (const double value : {distanceResidual, poleRadius.value(), stitchingHalfWidth.value()}) {
        if (!(value >= 0) || !std::isfinite(value)) {
            refuseTrust(
                text("the residual of the distance and the widths of pole and stitching zone must be 0 or "
                     "more, not ",
                     value));
        }
    }
    if (!(coarseness >= 1) || !std::isfinite(coarseness)) {
        refuseTrust(text("the coarseness must be 1 or more, not ", coarseness));
    }
}

PixelTrust pixelTrust(const ViewGeometry& view, const TrustOptions& options, WorkerPool& pool, int threads) {
    view.validate();
    options.validate();
    const CameraModel& camera = view.rays.camera();
    if (options.overlays != nullptr &&
        (options.overlays->width() != camera.width() || options.overlays->height() != camera.height())) {
        refuseTrust(text("the overlays' mask has ", options.overlays->width(), " x ",
                         options.overlays->height(), " pixels, the view ", camera.width(), " x ",
                         camera.height()));
    }
    PixelTrust result{Image<float, 1>(camera.width(), camera.height()),
                      MaskImage(camera.width(), camera.height())};
    const TrustRows rows(view, options);
    pool.run((camera.height() + kTrustRows - 1) / kTrustRows, threads, [&](int band, int) {
        rows.compute(kTrustRows * band, std::min(kTrustRows * (band + 1), camera.height()), result);
    });
    return result;
}

ViewTrust viewTrust(const ViewGeometry& view, const TrustOptions& options) {
    const CameraModel& camera = view.rays.camera();
    const SceneRays scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM);
    const ShownErrors errors(scene, view, options);
    std::vector<double> all;
    int seen = 0;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const int x = (2 * column + 1) * camera.width() / (2 * kColumns);
            const int y = (2 * row + 1) * camera.height() / (2 * kRows);
            const Vector3d ray = view.rays.ray(x, y);
            if (!ray.isZero(0)) {
                const ShownError error = errors.at(x, y, ray);
                all.push_back(error.px);
                seen += error.isFilled || error.isUnsure ? 0 : 1;
            }
        }
    }
    if (all.empty()) {
        return {std::numeric_limits<double>::infinity(), 0};
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return {*middle, seen / static_cast<double>(kRows * kColumns)};
}

} // namespace spherewalk::render
