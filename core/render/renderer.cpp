// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/renderer.h"

#include "photo_cache.h"
#include "reference_sampling.h"
#include "view_tools.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/projection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr double kUsualDistanceM = 2;

void checkPose(const Rigid3& roomFromCamera) {
    if (!roomFromCamera.translation.allFinite() || std::abs(roomFromCamera.rotation.norm() - 1) > 1e-3) {
        throw Error(
            ErrorKind::InvalidInput,
            "The camera's pose is not a position in metres and a unit quaternion; nothing was rendered.");
    }
}

SceneKind chosenScene(const std::optional<SceneKind>& wanted, const Dataset& dataset) {
    const bool hasSphere = dataset.info().sphereRadiusM.has_value();
    if (wanted == SceneKind::Sphere && !hasSphere) {
        throw Error(ErrorKind::InvalidInput,
                    text("The dataset ", dataset.folder().string(),
                         " has no sphere scene model; use none, or export it again."));
    }
    return wanted.value_or(hasSphere ? SceneKind::Sphere : SceneKind::None);
}

/// See ViewReport::parallaxPx: offset times the error of the inverse distance times the focal length.
double parallax(SceneKind scene, double offsetM, double radiusM, const CameraModel& camera) {
    const double inverseDistanceError =
        scene == SceneKind::None ? 1 / radiusM : 1 / (0.5 * radiusM) - 1 / radiusM;
    return std::max(camera.intrinsics().fx, camera.intrinsics().fy) * offsetM * inverseDistanceError;
}

void renderRow(const Projection& projection, const RgbImage& photo, int y, RgbImage& picture) {
    for (int x = 0; x < picture.width(); ++x) {
        if (const auto at = projection.photoPixel(Eigen::Vector2d(x, y))) {
            const Eigen::Vector3d value = bilinear(photo, *at);
            for (int c = 0; c < 3; ++c) {
                picture.at(x, y)[c] = static_cast<std::uint8_t>(value[c] + 0.5);
            }
        }
    }
}

/// Where a photo stands and what the scene is taken for.
struct Placed {
    Rigid3 roomFromPhoto;
    SceneKind scene;
    double radiusM;
};

} // namespace

struct Renderer::State {
    State(std::shared_ptr<const Dataset> from, std::uint64_t cacheBytes)
        : dataset(std::move(from)), cache(dataset, cacheBytes) {}

    void renderExactly(const CameraModel& camera, const Rigid3& roomFromCamera, const RgbImage& photo,
                       const Placed& placed, int threads, RgbImage& view) const;
    Sampling renderFast(const CameraModel& camera, const Rigid3& roomFromCamera,
                        const std::shared_ptr<const RgbImage>& photo, const Placed& placed,
                        const ViewOptions& options, RgbImage& view);

    std::shared_ptr<const Dataset> dataset;
    PhotoCache cache;
    Planes planes;
    RayTables tables;
    std::mutex rendering; ///< of pool and workspace
    WorkerPool pool;
    Workspace workspace;
};

void Renderer::State::renderExactly(const CameraModel& camera, const Rigid3& roomFromCamera,
                                    const RgbImage& photo, const Placed& placed, int threads,
                                    RgbImage& view) const {
    const Projection projection(camera, roomFromCamera, placed.roomFromPhoto, {photo.width(), photo.height()},
                                placed.scene, placed.radiusM);
    view = RgbImage(camera.width(), camera.height());
    parallelFor(camera.height(), 8, threads, [&](int first, int end) {
        for (int y = first; y < end; ++y) {
            renderRow(projection, photo, y, view);
        }
    });
}

Sampling Renderer::State::renderFast(const CameraModel& camera, const Rigid3& roomFromCamera,
                                     const std::shared_ptr<const RgbImage>& photo, const Placed& placed,
                                     const ViewOptions& options, RgbImage& view) {
    const double ratio = minification(camera, photo->width());
    Sampling sampling = chosenSampling(options.sampling, ratio, options.toleranceDb);
    std::shared_ptr<const PhotoPlane> plane =
        sampling == Sampling::Reduced ? planes.half(photo) : planes.whole(photo);
    if (!plane) {
        sampling = Sampling::Footprint; // too small, or of an odd height
        plane = planes.whole(photo);
    }
    const std::shared_ptr<const RayTable> rays = tables.get(camera, samplesPerAxis(sampling, ratio));
    const ViewSource source{*plane, placed.roomFromPhoto, placed.scene, placed.radiusM};
    const std::unique_lock lock(rendering, std::try_to_lock);
    if (lock) {
        renderView(*rays, roomFromCamera, source, sampling, pool, options.threads, workspace, view);
    } else { // another thread has them: each view is then made by its own thread
        WorkerPool alone(1);
        Workspace own;
        renderView(*rays, roomFromCamera, source, sampling, alone, 1, own, view);
    }
    return sampling;
}

Renderer::Renderer(std::shared_ptr<const Dataset> dataset, const RendererOptions& options)
    : m_state(std::make_unique<State>(std::move(dataset), options.cacheBytes)) {
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Dataset& Renderer::dataset() const {
    return *m_state->dataset;
}

View Renderer::render(const CameraModel& camera, const Rigid3& roomFromCamera,
                      const ViewOptions& options) const {
    checkPose(roomFromCamera);
    const Dataset& dataset = *m_state->dataset;
    const double radius = dataset.info().sphereRadiusM.value_or(kUsualDistanceM);
    View view;
    ViewReport& report = view.report;
    report.photo = dataset.nearestPhoto(roomFromCamera.translation);
    report.scene = chosenScene(options.scene, dataset);
    const DatasetPhoto& photo = dataset.info().photos[report.photo];
    report.file = photo.file;
    report.offsetM = (roomFromCamera.translation - photo.roomFromPhoto.translation).norm();
    report.parallaxPx = parallax(report.scene, report.offsetM, radius, camera);
    report.trust = 1 / (1 + report.parallaxPx);

    const PhotoCache::Result cached = m_state->cache.get(report.photo);
    report.decodeMs = cached.decodeMs;
    const auto begin = std::chrono::steady_clock::now();
    const Rigid3 pose{roomFromCamera.rotation.normalized(), roomFromCamera.translation};
    const Placed placed{photo.roomFromPhoto, report.scene, radius};
    if (options.exact || !PhotoPlane::fits({photo.width, photo.height})) {
        report.sampling = Sampling::Bilinear;
        m_state->renderExactly(camera, pose, *cached.photo, placed, options.threads, view.picture);
    } else {
        report.sampling = m_state->renderFast(camera, pose, cached.photo, placed, options, view.picture);
    }
    report.renderMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return view;
}

} // namespace spherewalk::render
