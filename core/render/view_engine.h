// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_view.h"
#include "fast_view.h"
#include "loader.h"
#include "loader_photos.h"
#include "surfaces.h"
#include "tile_footprint.h"

#include "spherewalk/base/recently_used.h"
#include "spherewalk/render/renderer.h"

#include <memory>
#include <mutex>

namespace spherewalk::render {

/// Where a camera is and how it is to be rendered. Owner: the camera must outlive the request.
struct ViewRequest {
    const CameraModel& camera;
    Rigid3 roomFromCamera; ///< its rotation a unit quaternion
    ViewOptions options;
};

/// How one photo answers a request.
struct ViewPlan {
    PhotoLevel level;
    SceneKind scene = SceneKind::None; ///< with surfaces, what stands in for them where one photo is asked
    std::optional<SceneKind> surface;  ///< a scene model that has surfaces
    double radiusM = 0;
    Sampling sampling = Sampling::Footprint; ///< not Auto
    std::shared_ptr<const RayTable> rays;
};

/// What the renderer and its streams share: photos, tables, threads. Threads: all functions may be called
/// from any.
class ViewEngine {
  public:
    ViewEngine(std::shared_ptr<const Dataset> dataset, const RendererOptions& options);

    /// Errors: InvalidInput for a pose that is none, or a scene model that the dataset does not have.
    ViewRequest checked(const CameraModel& camera, const Rigid3& roomFromCamera,
                        const ViewOptions& options) const;

    std::size_t nearestPhoto(const ViewRequest& request) const;
    ViewPlan plan(const ViewRequest& request, std::size_t photo);

    /// The plan for the photo's thumbnail in its place.
    ViewPlan coarse(const ViewRequest& request, const ViewPlan& plan);

    /// The tiles of the plan's photo that the view shows. reachPx: and those so many photo pixels beside.
    TileNeed need(const ViewRequest& request, const ViewPlan& plan, double reachPx = kFilterReachPx);

    /// Makes all of the view from what was served.
    void make(const ViewRequest& request, const ViewPlan& plan, const Served& served, View& view);

    /// Makes all of a view whose plan has surfaces, from the photos nearest to the camera; waits for what is
    /// not decoded. Errors: those of the photos and of their depths.
    void makeFromSurfaces(const ViewRequest& request, const ViewPlan& plan, View& view);

    const Dataset& dataset() const { return *m_dataset; }

    TileStore& store() { return m_store; }

    LoaderPhotos& photos() { return *m_photos; }

    const std::shared_ptr<Thumbnails>& thumbnails() const { return m_thumbnails; }

  private:
    static constexpr double kFilterReachPx = 2;
    static constexpr std::size_t kCamerasKept = 8;

    Rigid3 roomFromPhoto(std::size_t photo) const { return m_dataset->info().photos[photo].roomFromPhoto; }

    std::shared_ptr<const RayTable> raysOf(const CameraModel& camera, int samplesPerAxis);
    void report(const ViewRequest& request, const ViewPlan& plan, const Served& served,
                ViewReport& report) const;
    void draw(const ViewRequest& request, const ViewPlan& plan, const PlaneView& photo, WorkerPool& pool,
              int threads, Workspace& workspace, View& view);
    void drawExactly(const ViewRequest& request, const ViewPlan& plan, const PlaneView& photo,
                     WorkerPool& pool, int threads, RgbImage& picture) const;
    void correctColour(const ViewRequest& request, WorkerPool& pool, int threads, View& view);
    void addLayers(const ViewRequest& request, const ViewPlan& plan, const PlaneView& photo, WorkerPool& pool,
                   int threads, DepthImage depth, View& view);
    void drawSurfaces(const ViewRequest& request, const ViewPlan& plan, WorkerPool& pool, int threads,
                      DepthView& depthView, Served& served, View& view);

    std::shared_ptr<const Dataset> m_dataset;
    std::shared_ptr<LoaderPhotos> m_photos;
    TileStore m_store;
    std::shared_ptr<Thumbnails> m_thumbnails;
    RecentlyUsed<std::pair<CameraIntrinsics, int>, RayTable> m_rays{kCamerasKept}; ///< by samples per axis
    RecentlyUsed<CameraIntrinsics, ViewFootprint> m_footprints{kCamerasKept};
    RecentlyUsed<CameraIntrinsics, PixelRays> m_pixelRays{kCamerasKept};
    Surfaces m_surfaces;
    std::optional<ColourTables> m_colour;
    Composer m_composer;
    std::mutex m_drawing; ///< of pool and workspace
    WorkerPool m_pool;
    Workspace m_workspace;
    DepthView m_depthView;
};

} // namespace spherewalk::render
