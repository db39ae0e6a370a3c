// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/renderer.h"

#include "photo_cache.h"
#include "reference_sampling.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/projection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
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

} // namespace

struct Renderer::State {
    State(std::shared_ptr<const Dataset> from, std::uint64_t cacheBytes)
        : dataset(std::move(from)), cache(dataset, cacheBytes) {}

    std::shared_ptr<const Dataset> dataset;
    PhotoCache cache;
};

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
    const Projection projection(camera, {roomFromCamera.rotation.normalized(), roomFromCamera.translation},
                                photo.roomFromPhoto, {photo.width, photo.height}, report.scene, radius);
    view.picture = RgbImage(camera.width(), camera.height());
    parallelFor(camera.height(), 8, options.threads, [&](int first, int end) {
        for (int y = first; y < end; ++y) {
            renderRow(projection, *cached.photo, y, view.picture);
        }
    });
    report.renderMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return view;
}

} // namespace spherewalk::render
