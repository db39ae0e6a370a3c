// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo_plane.h"
#include "prefetch_path.h"
#include "tile_store.h"

#include "spherewalk/render/dataset.h"
#include "spherewalk/render/view_stream.h"

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace spherewalk::render {

/// The thumbnails of a dataset. The files' bytes stay in memory once read, and a few decoded ones. Threads:
/// any.
class Thumbnails {
  public:
    explicit Thumbnails(std::shared_ptr<const Dataset> dataset);

    /// Nothing if the photo has none. Errors: NotFound, Io, Corrupt; Unsupported for a size that cannot be
    /// sampled.
    std::shared_ptr<const PhotoPlane> get(std::size_t photo);

  private:
    struct Entry {
        std::size_t photo;
        std::shared_ptr<const PhotoPlane> picture;
    };

    std::shared_ptr<const Dataset> m_dataset;
    std::mutex m_mutex;
    std::vector<Bytes> m_files;
    std::list<Entry> m_decoded; ///< most recently used first
};

/// What a view is made from.
struct Served {
    ViewOrigin origin = ViewOrigin::Photo;
    bool isLate = false; ///< something was not there when it was asked for
    std::size_t photo = 0;
    TileLease lease;                          ///< of the photo, but for ViewOrigin::Thumbnail
    std::shared_ptr<const PhotoPlane> coarse; ///< for ViewOrigin::Thumbnail
};

/// Serves the views of one camera in turn. Threads: one at a time.
class ViewLoader {
  public:
    /// Owner: the store must outlive the loader.
    ViewLoader(TileStore& store, std::shared_ptr<Thumbnails> thumbnails);

    /// What this view would need of another photo.
    using NeedOf = std::function<TileNeed(std::size_t photo)>;

    /// Coarse without a thumbnail, and Previous without a previous photo whose tiles are there, become the
    /// next of Previous, Coarse, Wait: what is served, `origin` says. Put late tiles at the head of the
    /// prefetcher's plan, or they never come. Errors: those of the photos.
    Served serve(const TileNeed& need, LatePolicy policy, const NeedOf& needOf, int threads = 0);

    /// A view that was made without this loader, and waited if it was late.
    void countSurfaceView(bool isLate) {
        ++m_counters.views;
        m_counters.late += isLate ? 1 : 0;
        m_counters.waited += isLate ? 1 : 0;
    }

    const StreamCounters& counters() const { return m_counters; }

  private:
    Served wait(const TileNeed& need, int threads);
    std::optional<Served> servePrevious(const TileNeed& need, const NeedOf& needOf);

    TileStore& m_store;
    std::shared_ptr<Thumbnails> m_thumbnails;
    std::optional<std::size_t> m_previous; ///< the photo last served from tiles
    StreamCounters m_counters;
};

} // namespace spherewalk::render
