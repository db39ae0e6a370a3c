// SPDX-License-Identifier: Apache-2.0
#include "view_engine.h"

#include "spherewalk/render/view_depth.h"

#include <chrono>

namespace spherewalk::render {

void ViewEngine::makeFromSurfaces(const ViewRequest& request, const ViewPlan& plan, View& view) {
    const auto begin = std::chrono::steady_clock::now();
    Served served;
    const std::unique_lock lock(m_drawing, std::try_to_lock);
    if (lock) {
        drawSurfaces(request, plan, m_pool, request.options.threads, m_depthView, served, view);
    } else { // another thread has them: each view is then made by its own thread
        WorkerPool alone(1);
        DepthView own;
        drawSurfaces(request, plan, alone, 1, own, served, view);
    }
    const double allMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    view.report.renderMs = allMs - view.report.decodeMs;
}

void ViewEngine::drawSurfaces(const ViewRequest& request, const ViewPlan& plan, WorkerPool& pool, int threads,
                              DepthView& depthView, Served& served, View& view) {
    const auto rays = m_pixelRays.get(request.camera.intrinsics(),
                                      [&] { return PixelRays(request.camera, pool, threads); });
    std::vector<DepthPhoto> photos;
    for (const std::size_t photo :
         m_surfaces.photosFor(*plan.surface, request.roomFromCamera.translation, request.options.without)) {
        const PhotoLevel level{photo, plan.level.denominator};
        photos.push_back(
            {photo, m_surfaces.get(*plan.surface, photo), roomFromPhoto(photo), m_store.grid(level)});
    }
    const std::vector<TileSet> needs = depthView.place(*rays, request.roomFromCamera, photos, plan.radiusM,
                                                       plan.rays->samplesPerAxis(), pool, threads);
    std::vector<TileLease> leases;
    std::vector<PlaneView> planes;
    double waitedMs = 0;
    int waitedTiles = 0;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        leases.push_back(m_store.acquire({photos[i].photo, plan.level.denominator}, needs[i],
                                         TileStore::Missing::Decode, request.options.threads));
        planes.push_back(leases.back().plane());
        waitedMs += leases.back().waitedMs();
        waitedTiles += leases.back().waitedTiles();
    }
    depthView.sample(*rays, planes, plan.sampling, pool, threads, view.picture);
    served.isLate = waitedTiles > 0;
    served.lease = std::move(leases.front());
    report(request, plan, served, view.report);
    view.report.decodeMs = waitedMs;
    view.report.decodedTiles = waitedTiles;
    view.report.filledShare = depthView.filledShare();
    DepthImage depth;
    if (request.options.wantsDepth || !request.options.overlays.empty()) {
        depth = depthView.depth(*rays);
    }
    addLayers(request, plan, planes.front(), pool, threads, std::move(depth), view);
}

} // namespace spherewalk::render
