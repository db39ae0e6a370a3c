// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tile_grid.h"
#include "tile_plane.h"

#include "spherewalk/render/load_counters.h"

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

/// A photo as its JPEG has it, or reduced while decoding by 2, 4 or 8.
struct PhotoLevel {
    std::size_t photo = 0;
    int denominator = 1;
    auto operator<=>(const PhotoLevel&) const = default;
};

/// Where the store's pixels come from. Threads: all functions may be called from any, at a time.
class TileSource {
  public:
    virtual ~TileSource() = default;
    virtual EquirectSize size(const PhotoLevel& level) const = 0;
    /// Called for every request, also for tiles that are there. Errors: those of a photo that has been found
    /// to be damaged.
    virtual void check(std::size_t photo) const = 0;
    /// False for a photo that can only be decoded whole; decode() is then asked for all of it.
    virtual bool decodesParts(std::size_t photo) = 0;
    /// Gives the rows of the region, three bytes a pixel. Errors: any Error; the tiles then stay absent.
    virtual void decode(const PhotoLevel& level, const jpeg::PixelRect& region,
                        const jpeg::RowSink& sink) = 0;
};

class TileLease;

/// Decoded tiles of many photos within a budget of bytes; those not used for the longest time leave first.
/// A tile in use by a lease never leaves, even beyond the budget. Two requests for the same tile decode it
/// once. Threads: all functions may be called from any.
class TileStore {
  public:
    /// Owner: the source is shared. budgetBytes: of decoded pixels, in whole pages of memory.
    TileStore(std::shared_ptr<TileSource> source, std::uint64_t budgetBytes);
    ~TileStore();
    TileStore(const TileStore&) = delete;
    TileStore& operator=(const TileStore&) = delete;

    enum class Missing {
        Decode,  ///< decode what is not there, and wait for it
        LeaveOut ///< return at once with what is there
    };

    /// The tiles, held until the lease ends. threads: for decoding, 0 for all of the machine. Errors: those
    /// of the source.
    TileLease acquire(const PhotoLevel& level, const TileSet& tiles, Missing missing, int threads = 0);

    /// Decodes what is not there, block by block on all threads, giving way between blocks to every request
    /// that waits and every view that is being made. Returns early when stopped. Errors: none; they are
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
    /// Whether all of the photo was decoded.
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
    Recency m_recency; ///< resident tiles, most recently used first
    int m_views = 0;
    std::uint64_t m_residentBytes = 0;
    LoadCounters m_counters;
};

/// Tiles in use. Owner: the store must outlive it.
class TileLease {
  public:
    TileLease() = default;
    TileLease(TileLease&& other) noexcept;
    TileLease& operator=(TileLease&& other) noexcept;
    ~TileLease();

    bool isComplete() const { return m_missing.empty(); }

    /// What was asked for and left out.
    const TileSet& missing() const { return m_missing; }

    /// Valid while the lease lives; pixels outside of its tiles are anything. Range: not a default lease.
    PlaneView plane() const;

    /// How long the request waited for tiles to be decoded.
    double waitedMs() const { return m_waitedMs; }

    /// Tiles that it waited for.
    int waitedTiles() const { return m_waitedTiles; }

    /// Whether all of the photo was decoded for it.
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
