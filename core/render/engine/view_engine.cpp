// SPDX-License-Identifier: Apache-2.0
#include "engine/view_engine.h"

#include "sphere/exact_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rigid3.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr double kUsualDistanceM = 2;
/// So many photos tell about a view's errors.
constexpr std::size_t kWitnesses = 4;

/// What the dataset says about a photo's pose, across a ray: the median length of a normal error along two of
/// the three directions.
void fillSigmas(const DatasetPhoto& photo, PhotoEvidence& evidence) {
    const auto across = [](const Eigen::Vector3d& sigmas) {
        return std::sqrt(2 * std::numbers::ln2 / 3) * sigmas.norm();
    };
    if (photo.rotationSigma) {
        const auto& [yaw, pitch, roll] = *photo.rotationSigma;
        evidence.rotationSigmaRad = across({yaw.value(), pitch.value(), roll.value()});
    }
    if (photo.positionSigmaM) {
        evidence.positionSigmaM = across(*photo.positionSigmaM);
    }
}

/// The alignment gives no standard deviation to a photo that a quite different rotation fits as well.
bool isRotationKnown(const DatasetPhoto& photo) {
    return photo.rotationSource == "aligned"
               ? photo.rotationSigma.has_value()
               : photo.rotationSource != "metadata" && photo.rotationSource != "unknown";
}

std::optional<RoomShape> roomOf(const DatasetInfo& info) {
    if (info.roomShape || info.outline.size() < 3 || !(info.ceilingM > 0)) {
        return info.roomShape;
    }
    return RoomShape{info.outline, 0, info.ceilingM};
}

/// Mixes a picture into one of the same size. share: what it counts for, 0 to 1.
void mixIn(const RgbImage& other, double share, RgbImage& picture) {
    const auto weight = static_cast<int>(std::lround(256 * share));
    for (int y = 0; y < picture.height(); ++y) {
        const std::uint8_t* from = other.at(0, y);
        std::uint8_t* to = picture.at(0, y);
        for (int i = 0; i < 3 * picture.width(); ++i) {
            to[i] = static_cast<std::uint8_t>((weight * from[i] + (256 - weight) * to[i] + 128) / 256);
        }
    }
}

double elapsedMs(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

ViewEngine::ViewEngine(std::shared_ptr<const Dataset> dataset, const RendererOptions& options)
    : m_dataset(std::move(dataset)),
      m_photos(std::make_shared<PhotoFiles>(m_dataset, options.verify)),
      m_store(m_photos, options.cacheBytes),
      m_thumbnails(std::make_shared<Thumbnails>(m_dataset)),
      m_surfaces(m_dataset) {
    if (m_dataset->info().colour) {
        m_colour.emplace(*m_dataset->info().colour);
    }
}

ViewRequest ViewEngine::request(const CameraModel& camera, const Rigid3& roomFromCamera,
                                const ViewOptions& options) const {
    if (!isPose(roomFromCamera)) {
        throw Error(
            ErrorKind::InvalidInput,
            "The camera's pose is not a position in metres, of at most 10^9, and a unit quaternion; nothing "
            "was rendered.");
    }
    if (options.scene == SceneKind::Sphere && !m_dataset->info().sphereRadiusM) {
        throw Error(ErrorKind::InvalidInput,
                    text("The dataset ", m_dataset->folder().string(),
                         " has no sphere scene model; use none, or export it again."));
    }
    const auto hasScene = [&](SceneKind scene) {
        const std::vector<SceneKind> scenes = scenesOf(m_dataset->info());
        return std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
    };
    if (options.scene && hasSurfaces(*options.scene) && !hasScene(*options.scene)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The dataset ", m_dataset->folder().string(), " has no ", name(*options.scene),
                         " scene model; use another, or export it again with one."));
    }
    return {camera, {roomFromCamera.rotation.normalized(), roomFromCamera.translation}, options, {}, {}};
}

bool ViewEngine::passesSoftly(const ViewRequest& request, const std::vector<std::size_t>& former) {
    return plan(request, request.held.front()).surface == SceneKind::Depth &&
           std::all_of(former.begin(), former.end(),
                       [&](std::size_t photo) {
                           return photo != request.options.without && m_surfaces.has(SceneKind::Depth, photo);
                       }) &&
           m_dataset->sees(former.front(), request.roomFromCamera.translation);
}

std::shared_ptr<const RayTable> ViewEngine::raysOf(const CameraModel& camera, int samplesPerAxis) {
    return m_rays.get({camera.intrinsics(), samplesPerAxis},
                      [&] { return RayTable(camera, samplesPerAxis); });
}

/// The photos for a view. surface: the scene model, if it has surfaces; then only photos that have one count.
NearPhotos ViewEngine::photosFor(const ViewRequest& request, std::optional<SceneKind> surface) const {
    PhotoQuery query;
    query.without = request.options.without;
    query.held = request.held;
    if (surface) {
        query.most = *surface == SceneKind::Blend ? Surfaces::kPhotosOfBlend : Surfaces::kPhotosOfView;
        query.isUsable = [&](std::size_t photo) { return m_surfaces.has(*surface, photo); };
    }
    return m_dataset->photosNear(request.roomFromCamera.translation, query);
}

std::shared_ptr<const PixelRays> ViewEngine::pixelRaysOf(const CameraModel& camera, const Tools& tools) {
    return m_pixelRays.get(camera.intrinsics(), [&] { return PixelRays(camera, tools.pool, tools.threads); });
}

ViewEngine::Plan ViewEngine::plan(const ViewRequest& request, std::size_t photo) {
    const DatasetInfo& info = m_dataset->info();
    Plan plan;
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

/// The plan for the photo's thumbnail in its place.
ViewEngine::Plan ViewEngine::coarse(const ViewRequest& request, const Plan& plan) {
    Plan coarse = plan;
    coarse.sampling = Sampling::Bilinear; // a thumbnail is magnified
    coarse.rays = raysOf(request.camera, 1);
    return coarse;
}

TileNeed ViewEngine::need(const ViewRequest& request, double reachPx) {
    return need(request, plan(request, photosFor(request, {}).photos.front()), reachPx);
}

TileNeed ViewEngine::need(const ViewRequest& request, const Plan& plan, double reachPx) {
    const TileGrid grid = m_store.grid(plan.level);
    const Projection projection(request.camera, request.roomFromCamera, roomFromPhoto(plan.level.photo),
                                grid.photo(), plan.scene, plan.radiusM);
    const auto footprint =
        m_footprints.get(request.camera.intrinsics(), [&] { return ViewFootprint(request.camera); });
    const auto seenIn = [&](const Eigen::Vector2d& pixel) { return projection.photoDirection(pixel); };
    return {plan.level, footprint->tiles(grid, seenIn, reachPx)};
}

/// The first photo's plan and the photos of a view.
std::pair<ViewEngine::Plan, NearPhotos> ViewEngine::choice(const ViewRequest& request) {
    NearPhotos nearest = photosFor(request, {});
    const Plan plan = this->plan(request, nearest.photos.front());
    return {plan, plan.surface ? photosFor(request, plan.surface) : std::move(nearest)};
}

void ViewEngine::serve(const ViewRequest& request, LatePolicy policy, LateViews& late, View& view) {
    const auto [nearest, photos] = choice(request);
    view.report.seesPlace = photos.seesPlace;
    const TileStore::ViewInProgress inProgress(m_store);
    if (nearest.surface) {
        makeFromSurfaces(request, nearest, photos, view);
        late.countSurfaceView(view.report.isLate);
        return;
    }
    const auto needOf = [&](std::size_t photo) -> std::optional<TileNeed> {
        if (!m_dataset->sees(photo, request.roomFromCamera.translation)) {
            return std::nullopt;
        }
        return need(request, plan(request, photo), kFilterReachPx);
    };
    const TileNeed own = need(request, nearest, kFilterReachPx);
    const Served served = late.serve(own, policy, needOf, request.options.threads);
    switch (served.origin) {
    case ViewOrigin::Photo:
        make(request, nearest, served, view);
        break;
    case ViewOrigin::Thumbnail:
        make(request, coarse(request, nearest), served, view);
        break;
    case ViewOrigin::PreviousPhoto:
        make(request, plan(request, served.photo), served, view);
        break;
    }
}

/// Calls draw(tools). While another thread has the pool and the memory, the view is made by its own thread
/// alone.
template <class Draw>
void ViewEngine::withTools(int threads, Draw&& draw) {
    const std::unique_lock lock(m_drawing, std::try_to_lock);
    if (lock) {
        draw(Tools{m_pool, threads, m_memory});
    } else {
        WorkerPool alone(1);
        Memory own;
        draw(Tools{alone, 1, own});
    }
}

void ViewEngine::make(const ViewRequest& request, const Plan& plan, const Served& served, View& view) {
    const auto begin = std::chrono::steady_clock::now();
    report(request, plan, served, view.report);
    const PlaneView photo = served.coarse ? served.coarse->view() : served.lease.plane();
    withTools(request.options.threads, [&](const Tools& tools) { draw(request, plan, photo, tools, view); });
    view.report.renderMs = elapsedMs(begin);
}

void ViewEngine::draw(const ViewRequest& request, const Plan& plan, const PlaneView& photo,
                      const Tools& tools, View& view) {
    if (request.options.exact) {
        const Projection projection(request.camera, request.roomFromCamera, roomFromPhoto(plan.level.photo),
                                    photo.size(), plan.scene, plan.radiusM);
        drawExactly(request.camera, projection, photo, tools.pool, tools.threads, view.picture);
    } else {
        const ViewSource source{photo, roomFromPhoto(plan.level.photo), plan.scene, plan.radiusM};
        renderView(*plan.rays, request.roomFromCamera, source, plan.sampling, tools.pool, tools.threads,
                   tools.memory.workspace, view.picture);
    }
    addLayers(request, plan, photo, tools, evidence(request, plan, {plan.level.photo}), {}, view);
}

/// Makes all of a view whose plan has surfaces, from these photos.
void ViewEngine::makeFromSurfaces(const ViewRequest& request, const Plan& plan, const NearPhotos& photos,
                                  View& view) {
    const auto begin = std::chrono::steady_clock::now();
    withTools(request.options.threads, [&](const Tools& tools) {
        SurfaceView& surfaces =
            plan.surface == SceneKind::Blend ? tools.memory.blendedView : tools.memory.surfaceView;
        makeSurfaceView(request, plan, photos, tools, surfaces, view);
    });
    view.report.renderMs = elapsedMs(begin) - view.report.decodeMs;
}

Eigen::Vector3d ViewEngine::exposureGain(std::size_t photo) const {
    return m_dataset->info().photos[photo].exposureGain.value_or(Eigen::Vector3d::Ones());
}

/// Makes a picture from the surfaces of these photos, as bright as the first one.
ViewEngine::DrawnSurfaces ViewEngine::drawSurfaces(const ViewRequest& request, const Plan& plan,
                                                   const std::vector<std::size_t>& chosen, const Tools& tools,
                                                   SurfaceView& surfaceView, RgbImage& picture) {
    const auto rays = pixelRaysOf(request.camera, tools);
    std::vector<SurfacePhoto> photos;
    for (const std::size_t photo : chosen) {
        const PhotoLevel level{photo, plan.level.denominator};
        photos.push_back(
            {photo, m_surfaces.get(*plan.surface, photo), roomFromPhoto(photo), m_store.grid(level)});
        photos.back().lenses = m_dataset->info().photos[photo].lenses;
        photos.back().highlightRolloff = m_dataset->info().highlightRolloff;
        photos.back().gain = exposureGain(photo).cwiseQuotient(exposureGain(photos.front().photo));
    }
    const std::vector<TileSet> needs =
        surfaceView.prepare(*rays, request.roomFromCamera, photos, plan.radiusM, plan.rays->samplesPerAxis(),
                            tools.pool, tools.threads);
    DrawnSurfaces drawn;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const TileLease& lease =
            drawn.leases.emplace_back(m_store.acquire({photos[i].photo, plan.level.denominator}, needs[i],
                                                      TileStore::Missing::Decode, request.options.threads));
        drawn.planes.push_back(lease.plane());
        drawn.waitedMs += lease.waitedMs();
        drawn.waitedTiles += lease.waitedTiles();
    }
    surfaceView.sample(*rays, drawn.planes, plan.sampling, tools.pool, tools.threads, picture);
    return drawn;
}

void ViewEngine::makeSurfaceView(const ViewRequest& request, const Plan& plan, const NearPhotos& chosen,
                                 const Tools& tools, SurfaceView& surfaceView, View& view) {
    double waitedMs = 0;
    int waitedTiles = 0;
    if (request.former.share > 0) {
        const DrawnSurfaces former =
            drawSurfaces(request, plan, request.former.photos, tools, surfaceView, tools.memory.former);
        waitedMs = former.waitedMs;
        waitedTiles = former.waitedTiles;
    }
    DrawnSurfaces drawn = drawSurfaces(request, plan, chosen.photos, tools, surfaceView, view.picture);
    if (request.former.share > 0) {
        mixIn(tools.memory.former, request.former.share, view.picture);
    }
    Served served;
    served.isLate = waitedTiles + drawn.waitedTiles > 0;
    served.lease = std::move(drawn.leases.front());
    report(request, plan, served, view.report);
    view.report.decodeMs = waitedMs + drawn.waitedMs;
    view.report.decodedTiles = waitedTiles + drawn.waitedTiles;
    view.report.filledShare = surfaceView.filledShare();
    ViewEvidence evidence = this->evidence(request, plan, chosen.photos);
    evidence.inverseM = [&surfaceView, isPinhole = request.camera.intrinsics().lens == LensModel::Pinhole](
                            int x, int y, const Eigen::Vector3d& ray) {
        return surfaceView.inverse(x, y) * (isPinhole ? ray.z() : 1);
    };
    const auto rays = pixelRaysOf(request.camera, tools);
    const auto depthOfSurfaces = [&](DepthImage memory) {
        return surfaceView.depth(*rays, tools.pool, tools.threads, std::move(memory));
    };
    addLayers(request, plan, drawn.planes.front(), tools, evidence, depthOfSurfaces, view);
}

void ViewEngine::report(const ViewRequest& request, const Plan& plan, const Served& served,
                        ViewReport& report) const {
    const DatasetPhoto& photo = m_dataset->info().photos[plan.level.photo];
    report.photo = plan.level.photo;
    report.file = photo.file;
    report.scene = plan.surface.value_or(plan.scene);
    report.sampling = plan.sampling;
    report.origin = served.origin;
    report.isLate = served.isLate;
    report.offsetM = (request.roomFromCamera.translation - photo.roomFromPhoto.translation).norm();
    report.blurPx =
        served.coarse
            ? std::max(0.0, 0.5 / minification(request.camera, served.coarse->view().size().width) - 0.5)
            : 0;
    report.isOutside = m_dataset->isOutside(request.roomFromCamera.translation);
    report.decodeMs = served.lease.waitedMs();
    report.decodedTiles = served.lease.waitedTiles();
    report.isWholeDecode = served.lease.isWholeDecode();
    report.isVerified = m_photos->hash(plan.level.photo) == PhotoHash::Verified;
}

/// What is known about a view of these photos. The photos near the camera tell about it, too.
ViewEvidence ViewEngine::evidence(const ViewRequest& request, const Plan& plan,
                                  const std::vector<std::size_t>& shown) const {
    const DatasetInfo& info = m_dataset->info();
    ViewEvidence evidence;
    const auto add = [&](std::size_t photo) {
        PhotoEvidence of;
        of.roomFromPhoto = roomFromPhoto(photo);
        of.depth = m_dataset->evidence(photo);
        fillSigmas(info.photos[photo], of);
        evidence.photos.push_back(std::move(of));
    };
    std::for_each(shown.begin(), shown.end(), add);
    PhotoQuery near;
    near.most = kWitnesses;
    near.without = request.options.without;
    near.isUsable = [&](std::size_t photo) { return !info.photos[photo].depth.empty(); };
    for (const std::size_t photo : m_dataset->photosNear(request.roomFromCamera.translation, near).photos) {
        const bool isShown = std::find(shown.begin(), shown.end(), photo) != shown.end();
        if (!isShown && photo != request.options.without && evidence.photos.size() < kWitnesses) {
            add(photo);
        }
    }
    evidence.shown = shown.size();
    evidence.showsDepths = plan.surface && usesDepths(*plan.surface);
    evidence.room = roomOf(info);
    return evidence;
}

/// Adds the dataset's colour correction, and to the report how far the view can be trusted. Then it adds
/// depth, overlays and trust, if they are wanted. surfaceDepth: makes the depth of a view from surfaces.
void ViewEngine::addLayers(const ViewRequest& request, const Plan& plan, const PlaneView& photo,
                           const Tools& tools, ViewEvidence evidence, const MakeDepth& surfaceDepth,
                           View& view) {
    const ViewOptions& options = request.options;
    if (m_colour && options.correctsColour) {
        m_colour->apply(view.picture, *pixelRaysOf(request.camera, tools), tools.pool, tools.threads);
    }
    const auto rays = pixelRaysOf(request.camera, tools);
    const DatasetPhoto& whole = m_dataset->info().photos[plan.level.photo];
    const ViewGeometry geometry{
        *rays,       request.roomFromCamera, whole.roomFromPhoto, {whole.width, whole.height}, plan.scene,
        plan.radiusM};
    ViewReport& report = view.report;
    const ViewTrust judged = viewTrust(geometry, evidence);
    evidence.isKnown = isRotationKnown(whole) && report.seesPlace && !report.isOutside;
    report.parallaxPx = judged.displacementPx;
    report.seenShare = evidence.isKnown ? judged.seenShare : 0;
    report.trust = evidence.isKnown ? 1 / (1 + report.parallaxPx + report.blurPx) : 0;
    const bool needDepth = std::any_of(options.overlays.begin(), options.overlays.end(),
                                       [](const Overlay& overlay) { return overlay.roomDepth.empty(); });
    DepthImage& depth = options.wantsDepth ? view.depth : tools.memory.depth;
    if (options.wantsDepth || needDepth) {
        depth = plan.surface ? surfaceDepth(std::move(depth))
                             : viewDepth(geometry, tools.pool, tools.threads, std::move(depth));
    }
    if (!options.wantsLabels) {
        view.labels = {};
    }
    if (options.overlays.empty()) {
        view.overlaid = {};
        if (options.wantsLabels) {
            view.labels = LabelImage(view.picture.width(), view.picture.height());
        }
    } else {
        ComposeOptions compose = options.compose;
        compose.threads = tools.threads;
        const DepthImage none;
        m_composer.compose(options.overlays, request.camera, needDepth ? depth : none, compose, tools.pool,
                           view.picture, &view.overlaid, options.wantsLabels ? &view.labels : nullptr);
        if (options.wantsDepth && options.depthShowsOverlays) {
            m_composer.layDepth(options.overlays, request.camera, view.overlaid, compose, tools.pool,
                                view.depth);
        }
    }
    if (options.wantsTrust) {
        TrustOptions trust;
        trust.coarseness = static_cast<double>(whole.width) / photo.size().width;
        trust.overlays = view.overlaid.empty() ? nullptr : &view.overlaid;
        view.trust = pixelTrust(geometry, evidence, trust, tools.pool, tools.threads, std::move(view.trust));
    } else {
        view.trust = {};
    }
    if (!options.wantsDepth) {
        view.depth = {};
    }
}

} // namespace spherewalk::render
