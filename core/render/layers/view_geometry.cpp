// SPDX-License-Identifier: Apache-2.0
#include "layers/view_geometry.h"

#include "sphere/exact_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"

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
constexpr double kUnitTolerance = 1e-6;

[[noreturn]] void refuseGeometry(const std::string& what) {
    throw Error(ErrorKind::InvalidInput,
                text("Neither depth nor trust of the view can be told: ", what, "."));
}

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

class TrustRows {
  public:
    TrustRows(const ViewGeometry& view, const TrustOptions& options)
        : m_rays(view.rays),
          m_scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM),
          m_usualDistanceM(view.sphereRadiusM),
          m_options(options),
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
    double displacementPx(int x, int y, const Vector3d& ray) const;
    double blurPx(double footprint) const;
    std::uint8_t flags(const Vector3d& inPhoto, double footprint, bool isBlurred) const;
    void computeRow(int y, const Row& row, const Row& other, PixelTrust& trust) const;

    const PixelRays& m_rays;
    SceneRays m_scene;
    double m_usualDistanceM;
    const TrustOptions& m_options;
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

double TrustRows::displacementPx(int x, int y, const Vector3d& ray) const {
    const Vector3d& offset = m_scene.offsetInCamera();
    const Vector3d across = offset - offset.dot(ray) * ray;
    const double acrossM = across.norm();
    if (!(acrossM > 0)) {
        return 0;
    }
    const double modelM = m_scene.distanceM(ray);
    const double distanceM = std::isfinite(modelM) ? modelM : m_usualDistanceM;
    return pixelsPerRadian(m_rays.camera(), Vector2d(x, y), ray, across / acrossM) * acrossM *
           m_options.distanceResidual / distanceM;
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
            *trust.errorPx.at(x, y) = static_cast<float>(displacementPx(x, y, ray) + blur);
            *trust.flags.at(x, y) = flags(inPhoto, angle, blur > 0);
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

/// Depths of a row's pixels in the sphere, without distortion. With rays that are not normalised, the depth
/// along the axis is radius * t of |from + t * ray| = 1, whose root has two forms that do not cancel.
void pinholeRow(const CameraIntrinsics& camera, const DisplacedCamera& inCamera, double radiusM, int y,
                float* depth) {
    const double perPixel = 1 / camera.fx;
    const double down = (y - camera.cy) / camera.fy;
    const double forward = inCamera.fromPhoto().y() * down + inCamera.fromPhoto().z();
    const double across = inCamera.fromPhoto().x();
    const double inside = inCamera.inside();
    const double rest = down * down + 1;
    const double left = camera.cx;
    const int width = camera.width;
    for (int x = 0; x < width; ++x) {
        const double right = (x - left) * perPixel;
        const double along = across * right + forward;
        const double lengthSquared = right * right + rest;
        const double root = std::sqrt(along * along + inside * lengthSquared);
        const double above = along > 0 ? inside : root - along;
        const double below = along > 0 ? along + root : lengthSquared;
        depth[x] = static_cast<float>(radiusM * above / below);
    }
}

} // namespace

void ViewGeometry::validate() const {
    if (!isPose(roomFromCamera, kUnitTolerance) || !isPose(roomFromPhoto, kUnitTolerance)) {
        refuseGeometry(
            "the pose of the camera or of the photo is not a position in metres and a unit quaternion");
    }
    if (photo.width < 1 || photo.height < 1) {
        refuseGeometry(text("the photo has ", photo.width, " x ", photo.height, " pixels"));
    }
    if (!(sphereRadiusM > 0) || !std::isfinite(sphereRadiusM)) {
        refuseGeometry(text("the scene's radius is ", sphereRadiusM, " m; it must be above zero"));
    }
}

DepthImage viewDepth(const ViewGeometry& view, WorkerPool& pool, int threads) {
    view.validate();
    if (view.scene == SceneKind::None) {
        return {};
    }
    const SceneRays scene(view.roomFromCamera, view.roomFromPhoto, view.scene, view.sphereRadiusM);
    DepthImage depth(view.rays.camera().width(), view.rays.camera().height());
    const CameraIntrinsics& camera = view.rays.camera().intrinsics();
    pool.run(depth.height(), threads, [&](int y, int) {
        if (camera.lens == LensModel::Pinhole) {
            pinholeRow(camera, scene.inCamera(), view.sphereRadiusM, y, depth.at(0, y));
            return;
        }
        for (int x = 0; x < depth.width(); ++x) {
            const Vector3d ray = view.rays.ray(x, y);
            *depth.at(x, y) = ray.z() > 0 ? static_cast<float>(ray.z() * scene.distanceM(ray))
                                          : std::numeric_limits<float>::infinity();
        }
    });
    return depth;
}

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

} // namespace spherewalk::render
