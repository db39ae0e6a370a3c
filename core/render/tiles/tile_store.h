// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/photo_plane.h"
#include "tiles/tile_grid.h"

#include "spherewalk/render/dataset.h"

#include <compare>
#include <condition_variable>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

namespace spherewalk::render {

/// A photo at its JPEG's size, or reduced while decoding by 2, 4 or 8.
struct PhotoLevel {
    std::size_t photo = 0;
    int denominator = 1;
    auto operator<=>(const PhotoLevel&) const = default;
};

/// Tiles of a photo that some view needs.
struct TileNeed {
    PhotoLevel level;
    TileSet tiles;
};

/// The decoder that the store gets its pixels from. Threads: all functions may be called from any, at a time.
class TileSource {
  public:
    virtual ~TileSource() = default;
    virtual EquirectSize size(const PhotoLevel& level) const = 0;
    /// It is called for every request, also for tiles that are decoded. Errors: Corrupt for a photo that was
    /// found to be damaged.
    virtual void check(std::size_t photo) const = 0;
    /// False for a photo that can only be decoded whole. decode() is then asked for all of it.
    virtual bool decodesParts(std::size_t photo) = 0;
    /// Passes the rows of the region to the sink, three bytes a pixel. Errors: any Error; the tiles then stay
    /// absent.
    virtual void decode(const PhotoLevel& level, const jpeg::PixelRect& region,
                        const jpeg::RowSink& sink) = 0;
};

class TileLease;

/// Decoded tiles of many photos within a budget of bytes. The tiles that were not used for the longest time
/// leave first. A tile in use by a lease never leaves, even beyond the budget. Two requests for the same tile
/// decode it once. Threads: all functions may be called from any, at a time.
class TileStore {
  public:
    /// Owner: the source is shared. budgetBytes: the budget for decoded pixels, counted in whole pages of
    /// memory.
    TileStore(std::shared_ptr<TileSource> source, std::uint64_t budgetBytes);
    ~TileStore();
    TileStore(const TileStore&) = delete;
    TileStore& operator=(const TileStore&) = delete;

    /// What to do with tiles that are not decoded.
    enum class Missing {
        Decode,  ///< Decode them, and wait.
        LeaveOut ///< Return at once without them.
    };

    /// The tiles, held until the lease ends. threads: the most to decode with, 0 for all of the machine.
    /// Errors: those of the source.
    TileLease acquire(const PhotoLevel& level, const TileSet& tiles, Missing missing, int threads = 0);

    /// Decodes missing tiles, block by block on all threads. Between blocks it gives way to every request
    /// that waits and every view that is being made. It returns early when stopped. Errors: none; they are
    /// counted.
    void prefetch(const PhotoLevel& level, const TileSet& tiles, const std::stop_token& stop);

    /// While one of these lives, prefetch() begins no block.
    class ViewInProgress {
      public:
        explicit ViewInProgress(TileStore& store);
        ~ViewInProgress();
        ViewInProgress(const ViewInProgress&) = delete;
        ViewInProgress& operator=(const ViewInProgress&) = delete;

      private:
        TileStore& m_store;
    };

    TileGrid grid(const PhotoLevel& level) const { return TileGrid(m_source->size(level)); }

    std::uint64_t budgetBytes() const { return m_budgetBytes; }

    LoadCounters counters() const;

  private:
    friend class TileLease;
    struct Photo;
    using Lock = std::unique_lock<std::mutex>;
    using Recency = std::list<std::pair<Photo*, int>>;

    std::shared_ptr<Photo> opened(const PhotoLevel& level);
    void prefetchBlock(const PhotoLevel& level, const TileSet& tiles, const TileBlock& block, int threads,
                       Lock& lock);
    /// Decodes tiles. Returns whether all of the photo was decoded.
    bool load(Photo& photo, const TileSet& tiles, int threads, int maxRows, Lock& lock);
    void decodeBlocks(Photo& photo, const TileSet& own, int threads, int maxRows);
    void decodeBlock(Photo& photo, const TileSet& own, const TileBlock& block);
    void finish(Photo& photo, const TileSet& own, const TileBlock& block);
    void giveUp(Photo& photo, const TileSet& own);
    void dropBeyondBudget();
    void dropPhoto(Photo& photo);
    void release(Photo& photo, const TileSet& held);

    std::shared_ptr<TileSource> m_source;
    std::uint64_t m_budgetBytes;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::map<PhotoLevel, std::shared_ptr<Photo>> m_photos;
    Recency m_recency; ///< The decoded tiles; the most recently used one is the first.
    int m_views = 0;
    std::uint64_t m_residentBytes = 0;
    LoadCounters m_counters;
};

/// Holds the tiles of one request. Owner: the store must outlive it.
class TileLease {
  public:
    TileLease() = default;
    TileLease(TileLease&& other) noexcept;
    TileLease& operator=(TileLease&& other) noexcept;
    ~TileLease();

    bool isComplete() const { return m_missing.empty(); }

    /// The tiles that were asked for and left out.
    const TileSet& missing() const { return m_missing; }

    /// The photo while the lease lives. Pixels outside of its tiles may have any values. Range: not a default
    /// lease.
    PlaneView plane() const;

    /// How long the request waited for tiles to be decoded.
    double waitedMs() const { return m_waitedMs; }

    /// The number of tiles that it waited for.
    int waitedTiles() const { return m_waitedTiles; }

    /// Whether all of the photo was decoded for the request.
    bool isWholeDecode() const { return m_isWholeDecode; }

  private:
    friend class TileStore;

    TileStore* m_store = nullptr;
    std::shared_ptr<TileStore::Photo> m_photo;
    TileSet m_held;
    TileSet m_missing;
    double m_waitedMs = 0;
    int m_waitedTiles = 0;
    bool m_isWholeDecode = false;
};

} // namespace spherewalk::render
