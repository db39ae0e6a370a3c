// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/tile_supply.h"
#include "layers/view_geometry.h"
#include "sphere/sphere_view.h"
#include "surface/surface_view.h"
#include "tiles/photo_files.h"

#include "spherewalk/base/recently_used.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace spherewalk::render {

/// The photos that a moving camera's views were made from until now, and how much they still count.
struct FormerPhotos {
    std::vector<std::size_t> photos;
    double share = 0; ///< Range: 0 to 1.
};

/// A camera, its pose and the options of its view. Owner: the camera must outlive the request.
struct ViewRequest {
    const CameraModel& camera;
    Rigid3 roomFromCamera; ///< The pose of the optical frame; the rotation is a unit quaternion.
    ViewOptions options;
    std::vector<std::size_t> held; ///< PhotoQuery::held
    /// What is still mixed into a view with depth; nothing if its share is 0.
    FormerPhotos former = {};
};

/// Makes views: it chooses photos, gets their tiles and draws. The renderer and its streams share it with all
/// its photos, tables and threads. Threads: all functions may be called from any.
class ViewEngine {
  public:
    ViewEngine(std::shared_ptr<const Dataset> dataset, const RendererOptions& options);

    /// The checked request. Errors: InvalidInput for a pose that is not finite or not turned by a quaternion,
    /// and a scene model that the dataset does not have.
    ViewRequest request(const CameraModel& camera, const Rigid3& roomFromCamera,
                        const ViewOptions& options) const;

    /// The memory that serve() needs of one camera's views. Owner: the engine must outlive it.
    LateViews lateViews() { return {m_store, m_thumbnails}; }

    /// Makes all of a view. policy: what to do when tiles are not decoded. A view from surfaces always waits:
    /// there is no coarse picture of several photos. Errors: as PhotoFiles::decode() and Surfaces::get().
    void serve(const ViewRequest& request, LatePolicy policy, LateViews& late, View& view);

    /// The photos that serve() would make the view from.
    std::vector<std::size_t> photosOf(const ViewRequest& request) { return choice(request).second.photos; }

    /// Whether a view passes softly from other photos to its own: only where all photos' depths tell where
    /// things are, since two displaced pictures make edges that no camera sees, and only if the first of them
    /// sees the camera's place.
    bool passesSoftly(const ViewRequest& request, const std::vector<std::size_t>& former);

    /// The chosen photo and the tiles of it that the view shows. reachPx: how many photo pixels beside
    /// count, too. The default is what the filters of all samplings need.
    TileNeed need(const ViewRequest& request, double reachPx = kFilterReachPx);

    /// Hashes one more photo in the background: see PhotoFiles::verifyNext().
    bool verifyNext(const std::stop_token& stop) { return m_photos->verifyNext(stop); }

    const Dataset& dataset() const { return *m_dataset; }

    TileStore& store() { return m_store; }

  private:
    static constexpr double kFilterReachPx = 2;
    static constexpr std::size_t kCamerasKept = 8;

    /// How one photo answers a request.
    struct Plan {
        PhotoLevel level;
        SceneKind scene = SceneKind::None; ///< Of a model with surfaces: what stands in for one photo alone.
        std::optional<SceneKind> surface;  ///< The scene model, if it has surfaces.
        double radiusM = 0;
        Sampling sampling = Sampling::Footprint; ///< This is neither Best nor Auto.
        std::shared_ptr<const RayTable> rays;
    };

    /// Memory that views are made in.
    struct Memory {
        Workspace workspace;
        SurfaceView surfaceView;
        SurfaceView blendedView{true};
        DepthImage depth; ///< For overlays alone.
        RgbImage former;  ///< The picture of former photos.
    };

    /// What one view is drawn with. threads: the most to use of the pool.
    struct Tools {
        WorkerPool& pool;
        int threads;
        Memory& memory;
    };

    Rigid3 roomFromPhoto(std::size_t photo) const { return m_dataset->info().photos[photo].roomFromPhoto; }

    Eigen::Vector3d exposureGain(std::size_t photo) const;

    NearPhotos photosFor(const ViewRequest& request, std::optional<SceneKind> surface) const;
    Plan plan(const ViewRequest& request, std::size_t photo);
    std::pair<Plan, NearPhotos> choice(const ViewRequest& request);
    Plan coarse(const ViewRequest& request, const Plan& plan);
    TileNeed need(const ViewRequest& request, const Plan& plan, double reachPx);
    std::shared_ptr<const RayTable> raysOf(const CameraModel& camera, int samplesPerAxis);
    std::shared_ptr<const PixelRays> pixelRaysOf(const CameraModel& camera, const Tools& tools);

    template <class Draw>
    void withTools(int threads, Draw&& draw);
    void make(const ViewRequest& request, const Plan& plan, const Served& served, View& view);
    void draw(const ViewRequest& request, const Plan& plan, const PlaneView& photo, const Tools& tools,
              View& view);
    void makeFromSurfaces(const ViewRequest& request, const Plan& plan, const NearPhotos& photos, View& view);

    /// A picture from surfaces, and what it had to wait for.
    struct DrawnSurfaces {
        std::vector<TileLease> leases; ///< One a photo.
        std::vector<PlaneView> planes; ///< The same photos.
        double waitedMs = 0;
        int waitedTiles = 0;
    };

    DrawnSurfaces drawSurfaces(const ViewRequest& request, const Plan& plan,
                               const std::vector<std::size_t>& chosen, const Tools& tools,
                               SurfaceView& surfaceView, RgbImage& picture);
    void makeSurfaceView(const ViewRequest& request, const Plan& plan, const NearPhotos& chosen,
                         const Tools& tools, SurfaceView& surfaceView, View& view);
    void report(const ViewRequest& request, const Plan& plan, const Served& served, ViewReport& report) const;
    ViewEvidence evidence(const ViewRequest& request, const Plan& plan,
                          const std::vector<std::size_t>& shown) const;
    /// Makes a depth in memory that was used before.
    using MakeDepth = std::function<DepthImage(DepthImage memory)>;
    void addLayers(const ViewRequest& request, const Plan& plan, const PlaneView& photo, const Tools& tools,
                   ViewEvidence evidence, const MakeDepth& surfaceDepth, View& view);

    std::shared_ptr<const Dataset> m_dataset;
    std::shared_ptr<PhotoFiles> m_photos;
    TileStore m_store;
    std::shared_ptr<Thumbnails> m_thumbnails;
    /// The key has the samples per axis, too.
    RecentlyUsed<std::pair<CameraIntrinsics, int>, RayTable> m_rays{kCamerasKept};
    RecentlyUsed<CameraIntrinsics, ViewFootprint> m_footprints{kCamerasKept};
    RecentlyUsed<CameraIntrinsics, PixelRays> m_pixelRays{kCamerasKept};
    Surfaces m_surfaces;
    std::optional<ColourTables> m_colour;
    Composer m_composer;
    std::mutex m_drawing; ///< It guards the pool and the memory.
    WorkerPool m_pool;
    Memory m_memory;
};

} // namespace spherewalk::render
