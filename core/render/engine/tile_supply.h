// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tiles/photo_files.h"
#include "tiles/tile_store.h"

#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/view_stream.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace spherewalk::render {

/// How views get their tiles: decoded ahead for the predicted path of a camera, or late.

/// The pixels that one view is made from.
struct Served {
    ViewOrigin origin = ViewOrigin::Photo;
    bool isLate = false; ///< Whether some tile was not decoded when it was asked for.
    std::size_t photo = 0;
    TileLease lease;                          ///< The photo's tiles; none for ViewOrigin::Thumbnail.
    std::shared_ptr<const PhotoPlane> coarse; ///< The thumbnail, for ViewOrigin::Thumbnail only.
};

/// Decides for the views of one camera in turn what they are made from when tiles are late. Threads: one at a
/// time.
class LateViews {
  public:
    /// Owner: the store must outlive this.
    LateViews(TileStore& store, std::shared_ptr<Thumbnails> thumbnails);

    /// The tiles that the same view needs of another photo; nothing if that photo does not see the place.
    using NeedOf = std::function<std::optional<TileNeed>(std::size_t photo)>;

    /// The pixels for a view. Coarse needs a thumbnail, and Previous a previous photo whose tiles are
    /// decoded. Without these, the next of Previous, Coarse, Wait is done, and `origin` tells which. Late
    /// tiles must come first in the prefetcher's plan, or they are never decoded. threads: the most to use, 0
    /// for all. Errors: as PhotoFiles::decode() and Thumbnails::get().
    Served serve(const TileNeed& need, LatePolicy policy, const NeedOf& needOf, int threads = 0);

    /// Counts a view that was made of several photos, and waited if it was late.
    void countSurfaceView(bool isLate);

    const StreamCounters& counters() const { return m_counters; }

  private:
    Served wait(const TileNeed& need, int threads);
    std::optional<Served> servePrevious(const TileNeed& need, const NeedOf& needOf);

    TileStore& m_store;
    std::shared_ptr<Thumbnails> m_thumbnails;
    std::optional<std::size_t> m_previous; ///< The photo whose tiles were served last.
    StreamCounters m_counters;
};

/// How a camera moves. Frames: room. Units: m/s; rad/s about the vector's direction.
struct CameraMotion {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d turnRate = Eigen::Vector3d::Zero();
};

/// The motion that takes one pose to the other in this time. Range: seconds > 0. For other times the camera
/// is taken to stand. So it is for a jump too fast for a robot (1000 m/s), which is a new start.
CameraMotion motionBetween(const Rigid3& from, const Rigid3& to, double seconds);

/// The camera's pose after this time, at constant velocity and turn rate.
Rigid3 predicted(const Rigid3& roomFromCamera, const CameraMotion& motion, double seconds);

struct PrefetchOptions {
    double horizonSeconds = 0.5;
    double stepSeconds = 1.0 / 30; ///< The time between views.
    int mostTiles = 4000;          ///< The plan ends before it has more tiles.
};

/// The photo and the tiles of it that a view from this pose needs, with some pixels beyond. Paths bend, and a
/// view is late when its edge enters a tile that was not foreseen. (In the bench's walk the turn rate changes
/// by 0.25 rad/s^2. Without pixels beyond, one view in ninety was late, and with 24 none.)
using NeedOfView = std::function<TileNeed(const Rigid3& roomFromCamera)>;

/// The needs of the views on the predicted path, soonest first. Each photo occurs once, at its first need,
/// with all of its tiles. The same input gives the same plan. Stop: ends it early.
std::vector<TileNeed> prefetchPlan(const Rigid3& roomFromCamera, const CameraMotion& motion,
                                   const PrefetchOptions& options, const std::stop_token& stop,
                                   const NeedOfView& needOfView);

/// Decodes ahead of the views, in a thread of its own that gives way to them. Threads: all functions may be
/// called from any.
class Prefetcher {
  public:
    /// whenIdle: it is called again and again when the plan is done, until it returns false; then not before
    /// the next plan. It must not throw but Error{Stopped}. Owner: the store must outlive this.
    explicit Prefetcher(TileStore& store, std::function<bool(const std::stop_token&)> whenIdle = {});
    /// Stops within the time of one block of tiles.
    ~Prefetcher();
    Prefetcher(const Prefetcher&) = delete;
    Prefetcher& operator=(const Prefetcher&) = delete;

    /// Makes a plan. It is called in the prefetcher's thread, ends early when stopped, and must not throw.
    using MakePlan = std::function<std::vector<TileNeed>(const std::stop_token&)>;

    /// Replaces the plan. Tiles are decoded in the plan's order. The old plan ends after the block that is
    /// being decoded.
    void setPlan(MakePlan makePlan);

    /// Returns when the plan and the work of whenIdle are done.
    void waitUntilIdle();

  private:
    void run(const std::stop_token& stop);

    TileStore& m_store;
    std::function<bool(const std::stop_token&)> m_whenIdle;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    MakePlan m_makePlan;
    bool m_hasNewPlan = false;
    bool m_isIdle = true;
    std::stop_source m_planStop;
    std::jthread m_thread; ///< The last member: it ends before the members that it uses.
};

} // namespace spherewalk::render
