// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "prefetch_path.h"
#include "tile_store.h"

#include "spherewalk/base/image.h"
#include "spherewalk/render/dataset.h"

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace spherewalk::render {

/// What a view is made from when its tiles are not there.
enum class LatePolicy {
    Wait,     ///< its tiles, decoded now
    Coarse,   ///< the photo's thumbnail
    Previous, ///< the photo of the view before, seen from the new pose
};

/// The thumbnails of a dataset. The files' bytes stay in memory once read, and a few decoded ones. Threads:
/// any.
class Thumbnails {
  public:
    explicit Thumbnails(std::shared_ptr<const Dataset> dataset);

    /// Nothing if the photo has none. Errors: NotFound, Io, Corrupt.
    std::shared_ptr<const RgbImage> get(std::size_t photo);

  private:
    struct Entry {
        std::size_t photo;
        std::shared_ptr<const RgbImage> picture;
    };

    std::shared_ptr<const Dataset> m_dataset;
    std::mutex m_mutex;
    std::vector<Bytes> m_files;
    std::list<Entry> m_decoded; ///< most recently used first
};

/// What a view is made from.
struct Served {
    enum class From {
        Tiles,    ///< as asked
        Coarse,   ///< `coarse`, of the photo asked for
        Previous, ///< `lease`, of another photo
    };

    From from = From::Tiles;
    bool isLate = false; ///< something was not there when it was asked for
    std::size_t photo = 0;
    TileLease lease;
    std::shared_ptr<const RgbImage> coarse;
    double waitedMs = 0;
};

/// Late views by policy, since the loader was made.
struct LoaderCounters {
    std::uint64_t views = 0;
    std::uint64_t late = 0;
    std::uint64_t waited = 0;
    std::uint64_t coarse = 0;
    std::uint64_t previous = 0;
};

/// Serves the views of one camera in turn. Threads: one at a time.
class ViewLoader {
  public:
    /// Owner: the store must outlive the loader.
    ViewLoader(TileStore& store, std::shared_ptr<Thumbnails> thumbnails);

    /// The tiles that this view would need of another photo.
    using TilesOf = std::function<TileSet(std::size_t photo)>;

    /// Coarse without a thumbnail, and Previous without a previous photo whose tiles are there, become the
    /// next of Previous, Coarse, Wait: what is served, `from` says. Put late tiles at the head of the
    /// prefetcher's plan, or they never come. Errors: those of the photos.
    Served serve(const TileNeed& need, LatePolicy policy, const TilesOf& tilesOf, int threads = 0);

    const LoaderCounters& counters() const { return m_counters; }

  private:
    Served wait(const TileNeed& need, int threads);
    std::optional<Served> servePrevious(const TileNeed& need, const TilesOf& tilesOf);

    TileStore& m_store;
    std::shared_ptr<Thumbnails> m_thumbnails;
    std::optional<std::size_t> m_previous; ///< the photo last served from tiles
    LoaderCounters m_counters;
};

} // namespace spherewalk::render
