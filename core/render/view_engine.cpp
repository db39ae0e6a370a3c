// SPDX-License-Identifier: Apache-2.0
#include "view_engine.h"

#include "reference_sampling.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/pose_check.h"
#include "spherewalk/render/projection.h"
#include "spherewalk/render/view_depth.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr double kUsualDistanceM = 2;
/// Of 1 / distance, where depths are not measured against anything.
constexpr double kDepthResidual = 0.02;

/// See ViewReport::parallaxPx: offset times the error of the inverse distance times the focal length.
double parallax(const ViewPlan& plan, double offsetM, const CameraModel& camera) {
    const double inverseDistanceError = plan.surface == SceneKind::Depth ? kDepthResidual / plan.radiusM
                                        : plan.scene == SceneKind::None
                                            ? 1 / plan.radiusM
                                            : 1 / (0.5 * plan.radiusM) - 1 / plan.radiusM;
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
      m_thumbnails(std::make_shared<Thumbnails>(m_dataset)),
      m_surfaces(m_dataset) {
    if (m_dataset->info().colour) {
        m_colour.emplace(*m_dataset->info().colour);
    }
}

ViewRequest ViewEngine::checked(const CameraModel& camera, const Rigid3& roomFromCamera,
                                const ViewOptions& options) const {
    if (!isPose(roomFromCamera)) {
        throw Error(
            ErrorKind::InvalidInput,
            "The camera's pose is not a position in metres and a unit quaternion; nothing was rendered.");
    }
    if (options.scene == SceneKind::Sphere && !m_dataset->info().sphereRadiusM) {
        throw Error(ErrorKind::InvalidInput,
                    text("The dataset ", m_dataset->folder().string(),
                         " has no sphere scene model; use none, or export it again."));
    }
    if (options.scene && hasSurfaces(*options.scene) &&
        m_surfaces.photosFor(*options.scene, roomFromCamera.translation, options.without).empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The dataset ", m_dataset->folder().string(), " has no ", name(*options.scene),
                         " scene model; use another, or export it again with one."));
    }
    return {camera, {roomFromCamera.rotation.normalized(), roomFromCamera.translation}, options};
}

std::shared_ptr<const RayTable> ViewEngine::raysOf(const CameraModel& camera, int samplesPerAxis) {
    return m_rays.get({camera.intrinsics(), samplesPerAxis},
                      [&] { return RayTable(camera, samplesPerAxis); });
}

std::size_t ViewEngine::nearestPhoto(const ViewRequest& request) const {
    return m_dataset->nearestPhoto(request.roomFromCamera.translation, request.options.without);
}

ViewPlan ViewEngine::plan(const ViewRequest& request, std::size_t photo) {
    const DatasetInfo& info = m_dataset->info();
    ViewPlan plan;
    plan.level = {photo, 1};
    plan.scene = request.options.scene.value_or(autoScene(info, photo, request.camera.intrinsics()));
    if (hasSurfaces(plan.scene)) {
        plan.surface = plan.scene;
        plan.scene = info.sphereRadiusM ? SceneKind::Sphere : SceneKind::None;
    }
    plan.radiusM = info.sphereRadiusM.value_or(kUsualDistanceM);
    const double ratio = minification(request.camera, info.photos[photo].width);
    plan.sampling =
        request.options.exact
            ? Sampling::Bilinear
            : chosenSampling(autoSampling(info, request.options.sampling, request.camera.intrinsics()), ratio,
                             request.options.toleranceDb);
    if (plan.sampling == Sampling::Reduced) {
        if (PlaneLayout::fits(m_photos->size({photo, 2}))) {
            plan.level.denominator = 2;
        } else {
            plan.sampling = Sampling::Footprint; // too small, or of an odd height
        }
    }
    plan.rays = raysOf(request.camera, samplesPerAxis(plan.sampling, ratio));
    return plan;
}

ViewPlan ViewEngine::coarse(const ViewRequest& request, const ViewPlan& plan) {
    ViewPlan coarse = plan;
    coarse.sampling = Sampling::Bilinear; // a thumbnail is magnified
    coarse.rays = raysOf(request.camera, 1);
    return coarse;
}

TileNeed ViewEngine::need(const ViewRequest& request, const ViewPlan& plan, double reachPx) {
    const TileGrid grid = m_store.grid(plan.level);
    const Projection projection(request.camera, request.roomFromCamera, roomFromPhoto(plan.level.photo),
                                grid.photo(), plan.scene, plan.radiusM);
    const auto footprint =
        m_footprints.get(request.camera.intrinsics(), [&] { return ViewFootprint(request.camera); });
    const auto seenIn = [&](const Eigen::Vector2d& pixel) { return projection.photoDirection(pixel); };
    return {plan.level, footprint->tiles(grid, seenIn, reachPx)};
}

void ViewEngine::make(const ViewRequest& request, const ViewPlan& plan, const Served& served, View& view) {
    const auto begin = std::chrono::steady_clock::now();
    report(request, plan, served, view.report);
    const PlaneView photo = served.coarse ? served.coarse->view() : served.lease.plane();
    const std::unique_lock lock(m_drawing, std::try_to_lock);
    if (lock) {
        draw(request, plan, photo, m_pool, request.options.threads, m_workspace, view);
    } else { // another thread has them: each view is then made by its own thread
        WorkerPool alone(1);
        Workspace own;
        draw(request, plan, photo, alone, 1, own, view);
    }
    view.report.renderMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void ViewEngine::report(const ViewRequest& request, const ViewPlan& plan, const Served& served,
                        ViewReport& report) const {
    const DatasetPhoto& photo = m_dataset->info().photos[plan.level.photo];
    report.photo = plan.level.photo;
    report.file = photo.file;
    report.scene = plan.surface.value_or(plan.scene);
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
                      WorkerPool& pool, int threads, Workspace& workspace, View& view) {
    if (request.options.exact) {
        drawExactly(request, plan, photo, pool, threads, view.picture);
    } else {
        const ViewSource source{photo, roomFromPhoto(plan.level.photo), plan.scene, plan.radiusM};
        renderView(*plan.rays, request.roomFromCamera, source, plan.sampling, pool, threads, workspace,
                   view.picture);
    }
    addLayers(request, plan, photo, pool, threads, {}, view);
}

void ViewEngine::drawExactly(const ViewRequest& request, const ViewPlan& plan, const PlaneView& photo,
                             WorkerPool& pool, int threads, RgbImage& picture) const {
    const Projection projection(request.camera, request.roomFromCamera, roomFromPhoto(plan.level.photo),
                                photo.size(), plan.scene, plan.radiusM);
    if (picture.width() != request.camera.width() || picture.height() != request.camera.height()) {
        picture = RgbImage(request.camera.width(), request.camera.height());
    }
    pool.run(picture.height(), threads, [&](int y, int) { exactRow(projection, photo, y, picture); });
}

void ViewEngine::correctColour(const ViewRequest& request, WorkerPool& pool, int threads, View& view) {
    if (m_colour && request.options.correctsColour) {
        const auto rays = m_pixelRays.get(request.camera.intrinsics(),
                                          [&] { return PixelRays(request.camera, pool, threads); });
        m_colour->apply(view.picture, *rays, pool, threads);
    }
}

/// The dataset's colour correction; then, as far as they are wanted, depth, overlays and trust. depth: of the
/// view, if it is known already.
void ViewEngine::addLayers(const ViewRequest& request, const ViewPlan& plan, const PlaneView& photo,
                           WorkerPool& pool, int threads, DepthImage depth, View& view) {
    const ViewOptions& options = request.options;
    view.depth = {};
    view.trust = {};
    view.overlaid = {};
    correctColour(request, pool, threads, view);
    if (!options.wantsDepth && !options.wantsTrust && options.overlays.empty()) {
        return;
    }
    const auto rays = m_pixelRays.get(request.camera.intrinsics(),
                                      [&] { return PixelRays(request.camera, pool, threads); });
    const DatasetPhoto& whole = m_dataset->info().photos[plan.level.photo];
    const ViewGeometry geometry{
        *rays,       request.roomFromCamera, whole.roomFromPhoto, {whole.width, whole.height}, plan.scene,
        plan.radiusM};
    const bool needDepth = std::any_of(options.overlays.begin(), options.overlays.end(),
                                       [](const Overlay& overlay) { return overlay.roomDepth.empty(); });
    if (options.wantsDepth || needDepth) {
        view.depth = plan.surface ? std::move(depth) : viewDepth(geometry, pool, threads);
    }
    if (!options.overlays.empty()) {
        ComposeOptions compose = options.compose;
        compose.threads = threads;
        m_composer.compose(options.overlays, request.camera, view.depth, compose, pool, view.picture,
                           &view.overlaid);
    }
    if (options.wantsTrust) {
        TrustOptions trust;
        trust.coarseness = static_cast<double>(whole.width) / photo.size().width;
        trust.distanceResidual = plan.surface == SceneKind::Depth ? kDepthResidual : 1;
        trust.overlays = view.overlaid.empty() ? nullptr : &view.overlaid;
        view.trust = pixelTrust(geometry, trust, pool, threads);
    }
    if (!options.wantsDepth) {
        view.depth = {};
    }
}

} // namespace spherewalk::render
