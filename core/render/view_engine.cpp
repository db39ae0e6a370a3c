// SPDX-License-Identifier: Apache-2.0
#include "view_engine.h"

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

/// See ViewReport::parallaxPx: offset times the error of the inverse distance times the focal length.
double parallax(const ViewPlan& plan, double offsetM, const CameraModel& camera) {
    const double inverseDistanceError =
        plan.scene == SceneKind::None ? 1 / plan.radiusM : 1 / (0.5 * plan.radiusM) - 1 / plan.radiusM;
    return std::max(camera.intrinsics().fx, camera.intrinsics().fy) * offsetM * inverseDistanceError;
}

void exactRow(const Projection& projection, const PlaneView& photo, int y, RgbImage& picture) {
    for (int x = 0; x < picture.width(); ++x) {
        const auto at = projection.photoPixel(Eigen::Vector2d(x, y));
        const Eigen::Vector3d value = at ? bilinear(photo, *at) : Eigen::Vector3d(0, 0, 0);
        for (int c = 0; c < 3; ++c) {
            picture.at(x, y)[c] = static_cast<std::uint8_t>(value[c] + 0.5);
        }
    }
}

} // namespace

ViewEngine::ViewEngine(std::shared_ptr<const Dataset> dataset, const RendererOptions& options)
    : m_dataset(std::move(dataset)),
      m_photos(std::make_shared<LoaderPhotos>(m_dataset, options.verify)),
      m_store(m_photos, options.cacheBytes),
      m_thumbnails(std::make_shared<Thumbnails>(m_dataset)) {
}

ViewRequest ViewEngine::checked(const CameraModel& camera, const Rigid3& roomFromCamera,
                                const ViewOptions& options) const {
    if (!roomFromCamera.translation.allFinite() || std::abs(roomFromCamera.rotation.norm() - 1) > 1e-3 ||
        !std::isfinite(roomFromCamera.rotation.norm())) {
        throw Error(
            ErrorKind::InvalidInput,
            "The camera's pose is not a position in metres and a unit quaternion; nothing was rendered.");
    }
    if (options.scene == SceneKind::Sphere && !m_dataset->info().sphereRadiusM) {
        throw Error(ErrorKind::InvalidInput,
                    text("The dataset ", m_dataset->folder().string(),
                         " has no sphere scene model; use none, or export it again."));
    }
    return {camera, {roomFromCamera.rotation.normalized(), roomFromCamera.translation}, options};
}

std::size_t ViewEngine::nearestPhoto(const ViewRequest& request) const {
    return m_dataset->nearestPhoto(request.roomFromCamera.translation);
}

ViewPlan ViewEngine::plan(const ViewRequest& request, std::size_t photo) {
    const DatasetInfo& info = m_dataset->info();
    ViewPlan plan;
    plan.level = {photo, 1};
    plan.scene = request.options.scene.value_or(info.sphereRadiusM ? SceneKind::Sphere : SceneKind::None);
    plan.radiusM = info.sphereRadiusM.value_or(kUsualDistanceM);
    const double ratio = minification(request.camera, info.photos[photo].width);
    plan.sampling = request.options.exact
                        ? Sampling::Bilinear
                        : chosenSampling(request.options.sampling, ratio, request.options.toleranceDb);
    if (plan.sampling == Sampling::Reduced) {
        if (PlaneLayout::fits(m_photos->size({photo, 2}))) {
            plan.level.denominator = 2;
        } else {
            plan.sampling = Sampling::Footprint; // too small, or of an odd height
        }
    }
    plan.table = m_tables.get(request.camera, samplesPerAxis(plan.sampling, ratio));
    return plan;
}

ViewPlan ViewEngine::coarse(const ViewRequest& request, const ViewPlan& plan) {
    ViewPlan coarse = plan;
    coarse.sampling = Sampling::Bilinear; // a thumbnail is magnified
    coarse.table = m_tables.get(request.camera, 1);
    return coarse;
}

TileNeed ViewEngine::need(const ViewRequest& request, const ViewPlan& plan, double reachPx) const {
    const TileGrid grid = m_store.grid(plan.level);
    const Projection projection(request.camera, request.roomFromCamera, roomFromPhoto(plan.level.photo),
                                grid.photo(), plan.scene, plan.radiusM);
    return {
        plan.level,
        plan.table.footprint->tiles(
            grid, [&](const Eigen::Vector2d& pixel) { return projection.photoDirection(pixel); }, reachPx)};
}

void ViewEngine::make(const ViewRequest& request, const ViewPlan& plan, const Served& served, View& view) {
    const auto begin = std::chrono::steady_clock::now();
    report(request, plan, served, view.report);
    const PlaneView photo = served.coarse ? served.coarse->view() : served.lease.plane();
    if (request.options.exact) {
        drawExactly(request, plan, photo, view.picture);
    } else {
        draw(request, plan, photo, view.picture);
    }
    view.report.renderMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void ViewEngine::report(const ViewRequest& request, const ViewPlan& plan, const Served& served,
                        ViewReport& report) const {
    const DatasetPhoto& photo = m_dataset->info().photos[plan.level.photo];
    report.photo = plan.level.photo;
    report.file = photo.file;
    report.scene = plan.scene;
    report.sampling = plan.sampling;
    report.origin = served.origin;
    report.isLate = served.isLate;
    report.offsetM = (request.roomFromCamera.translation - photo.roomFromPhoto.translation).norm();
    report.parallaxPx = parallax(plan, report.offsetM, request.camera);
    report.blurPx =
        served.coarse
            ? std::max(0.0, 0.5 / minification(request.camera, served.coarse->view().size().width) - 0.5)
            : 0;
    report.trust = 1 / (1 + report.parallaxPx + report.blurPx);
    report.decodeMs = served.lease.waitedMs();
    report.decodedTiles = served.lease.waitedTiles();
    report.isWholeDecode = served.lease.isWholeDecode();
    report.isVerified = m_photos->trust(plan.level.photo) == PhotoTrust::Verified;
}

void ViewEngine::draw(const ViewRequest& request, const ViewPlan& plan, const PlaneView& photo,
                      RgbImage& picture) {
    const ViewSource source{photo, roomFromPhoto(plan.level.photo), plan.scene, plan.radiusM};
    const auto drawWith = [&](WorkerPool& pool, int threads, Workspace& workspace) {
        renderView(*plan.table.rays, request.roomFromCamera, source, plan.sampling, pool, threads, workspace,
                   picture);
    };
    const std::unique_lock lock(m_drawing, std::try_to_lock);
    if (lock) {
        drawWith(m_pool, request.options.threads, m_workspace);
    } else { // another thread has them: each view is then made by its own thread
        WorkerPool alone(1);
        Workspace own;
        drawWith(alone, 1, own);
    }
}

void ViewEngine::drawExactly(const ViewRequest& request, const ViewPlan& plan, const PlaneView& photo,
                             RgbImage& picture) {
    const Projection projection(request.camera, request.roomFromCamera, roomFromPhoto(plan.level.photo),
                                photo.size(), plan.scene, plan.radiusM);
    if (picture.width() != request.camera.width() || picture.height() != request.camera.height()) {
        picture = RgbImage(request.camera.width(), request.camera.height());
    }
    parallelFor(picture.height(), 8, request.options.threads, [&](int first, int end) {
        for (int y = first; y < end; ++y) {
            exactRow(projection, photo, y, picture);
        }
    });
}

} // namespace spherewalk::render
