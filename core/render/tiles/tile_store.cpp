// SPDX-License-Identifier: Apache-2.0
#include "tiles/tile_store.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace spherewalk::render {

namespace {

using Moment = std::chrono::steady_clock::time_point;

double millisecondsSince(Moment begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

// This share of the budget is freed at once. Photos then leave whole, in one call to the system instead of
// one for each row.
constexpr std::uint64_t kSlack = 16;
// A background block of this many tile rows of a usual view takes a thread about two milliseconds.
constexpr int kBackgroundRows = 3;
// Other values of maxRows: as many as the threads need, and all of the photo in one block.
constexpr int kRowsByThreads = 0;
constexpr int kWholePhoto = -1;

} // namespace

/// One photo's tiles. The store's mutex guards everything but pixels. Only the decoder writes the pixels of a
/// tile that is being decoded, and nobody writes those of a held tile.
struct TileStore::Photo {
    enum class State : std::uint8_t { Absent, Decoding, Resident };

    struct Tile {
        State state = State::Absent;
        int leases = 0;
        Recency::iterator position; ///< The position of a resident tile.
    };

    Photo(const PhotoLevel& photoLevel, const EquirectSize& size)
        : level(photoLevel), grid(size), plane(size), tiles(static_cast<std::size_t>(grid.count())) {}

    Tile& tile(int i) { return tiles[static_cast<std::size_t>(i)]; }

    PhotoLevel level;
    TileGrid grid;
    SparsePlane plane;
    std::vector<Tile> tiles;
    int users = 0; ///< The number of leases and decoders.
    int resident = 0;
};

TileStore::TileStore(std::shared_ptr<TileSource> source, std::uint64_t budgetBytes)
    : m_source(std::move(source)), m_budgetBytes(budgetBytes) {
}

TileStore::~TileStore() = default;

std::shared_ptr<TileStore::Photo> TileStore::opened(const PhotoLevel& level) {
    const auto found = m_photos.find(level);
    if (found != m_photos.end()) {
        return found->second;
    }
    return m_photos.emplace(level, std::make_shared<Photo>(level, m_source->size(level))).first->second;
}

TileLease TileStore::acquire(const PhotoLevel& level, const TileSet& tiles, Missing missing, int threads) {
    m_source->check(level.photo);
    Lock lock(m_mutex);
    TileLease lease;
    lease.m_photo = opened(level);
    Photo& entry = *lease.m_photo;
    lease.m_store = this;
    lease.m_held = tiles;
    lease.m_missing = TileSet(tiles.grid());
    ++entry.users;
    tiles.forEach([&](int i) {
        Photo::Tile& tile = entry.tile(i);
        ++tile.leases;
        if (tile.state == Photo::State::Resident) {
            m_recency.splice(m_recency.begin(), m_recency, tile.position);
        } else {
            lease.m_missing.insert(i);
        }
    });
    if (lease.m_missing.empty()) {
        ++m_counters.hits;
        return lease;
    }
    ++m_counters.late;
    if (missing == Missing::LeaveOut) {
        lease.m_missing.forEach([&](int i) {
            --entry.tile(i).leases;
            lease.m_held.erase(i);
        });
        return lease;
    }
    ++m_counters.waits;
    const Moment begin = std::chrono::steady_clock::now();
    ++m_views;
    const int workers = threads > 0 ? threads : hardwareThreads();
    try {
        lease.m_isWholeDecode = load(entry, lease.m_missing, workers, kRowsByThreads, lock);
    } catch (...) { // only counted back; the lease lets go of the tiles, and needs the mutex
        --m_views;
        m_changed.notify_all();
        lock.unlock();
        throw;
    }
    --m_views;
    m_changed.notify_all();
    lease.m_waitedTiles = lease.m_missing.count();
    m_counters.decodedTiles += static_cast<std::uint64_t>(lease.m_waitedTiles);
    lease.m_missing = TileSet(tiles.grid());
    lease.m_waitedMs = millisecondsSince(begin);
    m_counters.decodeMs += lease.m_waitedMs;
    return lease;
}

void TileStore::prefetch(const PhotoLevel& level, const TileSet& tiles, const std::stop_token& stop) {
    // All threads work on what comes next: one alone would fall behind a camera that meets a new photo in
    // each view, and each view that then waits leaves less time for the next.
    const int threads = hardwareThreads();
    for (const TileBlock& block : blocksOf(tiles, kBackgroundRows * threads)) {
        Lock lock(m_mutex);
        m_changed.wait(lock, stop, [&] { return m_views == 0; });
        if (stop.stop_requested()) {
            return;
        }
        try {
            prefetchBlock(level, tiles, block, threads, lock);
        } catch (const Error&) {
            ++m_counters.prefetchErrors;
            return;
        }
    }
}

void TileStore::prefetchBlock(const PhotoLevel& level, const TileSet& tiles, const TileBlock& block,
                              int threads, Lock& lock) {
    const std::shared_ptr<Photo> entry = opened(level);
    TileSet absent(tiles.grid());
    for (int row = block.row; row < block.endRow; ++row) {
        for (int column = block.column; column < block.endColumn; ++column) {
            const int i = row * tiles.grid().columns() + column;
            if (tiles.contains(i) && entry->tile(i).state == Photo::State::Absent) {
                absent.insert(i);
            }
        }
    }
    if (absent.empty()) {
        dropPhoto(*entry);
        return;
    }
    const Moment begin = std::chrono::steady_clock::now();
    ++entry->users;
    absent.forEach([&](int i) { ++entry->tile(i).leases; }); // a small budget must not drop them meanwhile
    std::exception_ptr failure;
    try {
        load(*entry, absent, threads, kBackgroundRows, lock);
    } catch (...) { // rethrown below, when the photo has been let go
        failure = std::current_exception();
    }
    absent.forEach([&](int i) { --entry->tile(i).leases; });
    --entry->users;
    dropPhoto(*entry);
    dropBeyondBudget();
    if (failure) {
        std::rethrow_exception(failure);
    }
    m_counters.prefetchMs += millisecondsSince(begin);
    m_counters.prefetchedTiles += static_cast<std::uint64_t>(absent.count());
}

/// Returns when all of the tiles are resident: decodes those that nobody decodes, and waits for the others.
bool TileStore::load(Photo& photo, const TileSet& tiles, int threads, int maxRows, Lock& lock) {
    lock.unlock();
    bool isWhole = false;
    try {
        isWhole = !m_source->decodesParts(photo.level.photo); // may open a file
    } catch (...) {                                           // the caller expects the lock
        lock.lock();
        throw;
    }
    lock.lock();
    bool hasDecodedWhole = false;
    for (;;) {
        TileSet own(photo.grid);
        bool othersDecode = false;
        tiles.forEach(
            [&](int i) { othersDecode = othersDecode || photo.tile(i).state == Photo::State::Decoding; });
        const TileSet wanted = isWhole && !othersDecode ? TileSet::all(photo.grid) : tiles;
        wanted.forEach([&](int i) {
            if (photo.tile(i).state == Photo::State::Absent && (!isWhole || !othersDecode)) {
                own.insert(i);
            }
        });
        bool isComplete = true;
        tiles.forEach(
            [&](int i) { isComplete = isComplete && photo.tile(i).state == Photo::State::Resident; });
        if (isComplete) {
            return hasDecodedWhole;
        }
        if (own.empty()) {
            m_changed.wait(lock);
            continue;
        }
        own.forEach([&](int i) {
            photo.tile(i).state = Photo::State::Decoding;
            const std::uint64_t before = photo.plane.residentBytes();
            photo.plane.occupy(photo.grid.pixels(i));
            m_residentBytes += photo.plane.residentBytes() - before;
        });
        ++photo.users;
        dropBeyondBudget();
        lock.unlock();
        std::exception_ptr failure;
        try {
            decodeBlocks(photo, own, threads, isWhole ? kWholePhoto : maxRows);
        } catch (...) { // rethrown below, when the tiles have been given up
            failure = std::current_exception();
        }
        lock.lock();
        --photo.users;
        if (failure) {
            giveUp(photo, own);
            m_changed.notify_all();
            std::rethrow_exception(failure);
        }
        hasDecodedWhole = isWhole;
        m_counters.wholeDecodes += isWhole ? 1 : 0;
        m_changed.notify_all();
    }
}

void TileStore::decodeBlocks(Photo& photo, const TileSet& own, int threads, int maxRows) {
    std::vector<TileBlock> blocks;
    if (maxRows == kWholePhoto) {
        blocks = {{0, 0, photo.grid.columns(), photo.grid.rows()}};
    } else {
        // As many rows in a block that each thread has one or two: each block decodes a margin.
        int rows = 0;
        for (const TileBlock& block : blocksOf(own, photo.grid.rows())) {
            rows += block.endRow - block.row;
        }
        blocks =
            blocksOf(own, maxRows != kRowsByThreads ? maxRows : std::max(1, (rows + threads - 1) / threads));
    }
    parallelFor(static_cast<int>(blocks.size()), 1, threads, [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            decodeBlock(photo, own, blocks[static_cast<std::size_t>(i)]);
        }
    });
}

void TileStore::decodeBlock(Photo& photo, const TileSet& own, const TileBlock& block) {
    const jpeg::PixelRect region = photo.grid.pixels(block.column, block.row, block.endColumn, block.endRow);
    m_source->decode(photo.level, region, [&](int y, const std::uint8_t* row) {
        const int base = y / TileGrid::kTileHeight * photo.grid.columns();
        for (int column = block.column; column < block.endColumn; ++column) {
            if (own.contains(base + column)) {
                const jpeg::PixelRect tile = photo.grid.pixels(base + column);
                photo.plane.write(tile.x, y,
                                  {row + std::ptrdiff_t{3} * (tile.x - region.x),
                                   static_cast<std::size_t>(tile.width) * PlaneLayout::kPixelBytes});
            }
        }
    });
    const Lock lock(m_mutex);
    finish(photo, own, block);
    m_changed.notify_all();
}

void TileStore::finish(Photo& photo, const TileSet& own, const TileBlock& block) {
    for (int row = block.row; row < block.endRow; ++row) {
        for (int column = block.column; column < block.endColumn; ++column) {
            const int i = row * photo.grid.columns() + column;
            Photo::Tile& tile = photo.tile(i);
            if (own.contains(i) && tile.state == Photo::State::Decoding) {
                tile.state = Photo::State::Resident;
                m_recency.emplace_front(&photo, i);
                tile.position = m_recency.begin();
                ++photo.resident;
            }
        }
    }
}

void TileStore::giveUp(Photo& photo, const TileSet& own) {
    std::vector<jpeg::PixelRect> freed;
    own.forEach([&](int i) {
        Photo::Tile& tile = photo.tile(i);
        if (tile.state == Photo::State::Decoding) {
            tile.state = Photo::State::Absent;
            freed.push_back(photo.grid.pixels(i));
        }
    });
    const std::uint64_t before = photo.plane.residentBytes();
    photo.plane.vacate(freed);
    m_residentBytes -= before - photo.plane.residentBytes();
    dropPhoto(photo);
}

void TileStore::dropBeyondBudget() {
    if (m_residentBytes <= m_budgetBytes) {
        return;
    }
    const std::uint64_t target = m_budgetBytes - m_budgetBytes / kSlack;
    auto place = m_recency.end();
    while (m_residentBytes > target && place != m_recency.begin()) {
        // A batch of the least recently used tiles of one photo, as long as they follow each other.
        std::vector<jpeg::PixelRect> freed;
        Photo* photo = nullptr;
        std::uint64_t expected = 0;
        while (place != m_recency.begin() && m_residentBytes > target + expected) {
            const auto candidate = std::prev(place);
            const auto [owner, i] = *candidate;
            if (owner->tile(i).leases > 0) {
                place = candidate;
                continue;
            }
            if (photo != nullptr && owner != photo) {
                break;
            }
            photo = owner;
            photo->tile(i).state = Photo::State::Absent;
            --photo->resident;
            ++m_counters.droppedTiles;
            const jpeg::PixelRect pixels = photo->grid.pixels(i);
            freed.push_back(pixels);
            expected += static_cast<std::uint64_t>(pixels.width) * static_cast<std::uint64_t>(pixels.height) *
                        PlaneLayout::kPixelBytes;
            place = m_recency.erase(candidate);
        }
        if (photo == nullptr) {
            return; // all that is left is in use
        }
        const std::uint64_t before = photo->plane.residentBytes();
        if (photo->resident == 0 && photo->users == 0) {
            m_residentBytes -= before;
            m_photos.erase(photo->level); // all of its memory at once
        } else {
            photo->plane.vacate(freed);
            m_residentBytes -= before - photo->plane.residentBytes();
        }
    }
}

void TileStore::dropPhoto(Photo& photo) {
    if (photo.resident == 0 && photo.users == 0) {
        m_residentBytes -= photo.plane.residentBytes();
        m_photos.erase(photo.level);
    }
}

void TileStore::release(Photo& photo, const TileSet& held) {
    const Lock lock(m_mutex);
    held.forEach([&](int i) { --photo.tile(i).leases; });
    --photo.users;
    dropPhoto(photo);
    dropBeyondBudget();
}

LoadCounters TileStore::counters() const {
    const std::scoped_lock lock(m_mutex);
    LoadCounters result = m_counters;
    result.residentBytes = m_residentBytes;
    return result;
}

TileStore::ViewInProgress::ViewInProgress(TileStore& store) : m_store(store) {
    const std::scoped_lock lock(m_store.m_mutex);
    ++m_store.m_views;
}

TileStore::ViewInProgress::~ViewInProgress() {
    {
        const std::scoped_lock lock(m_store.m_mutex);
        --m_store.m_views;
    }
    m_store.m_changed.notify_all();
}

TileLease::TileLease(TileLease&& other) noexcept
    : m_store(std::exchange(other.m_store, nullptr)),
      m_photo(std::move(other.m_photo)),
      m_held(std::move(other.m_held)),
      m_missing(std::move(other.m_missing)),
      m_waitedMs(other.m_waitedMs),
      m_waitedTiles(other.m_waitedTiles),
      m_isWholeDecode(other.m_isWholeDecode) {
}

TileLease& TileLease::operator=(TileLease&& other) noexcept {
    TileLease taken(std::move(other));
    std::swap(m_store, taken.m_store);
    std::swap(m_photo, taken.m_photo);
    std::swap(m_held, taken.m_held);
    std::swap(m_missing, taken.m_missing);
    std::swap(m_waitedMs, taken.m_waitedMs);
    std::swap(m_waitedTiles, taken.m_waitedTiles);
    std::swap(m_isWholeDecode, taken.m_isWholeDecode);
    return *this;
}

TileLease::~TileLease() {
    if (m_store != nullptr) {
        m_store->release(*m_photo, m_held);
    }
}

PlaneView TileLease::plane() const {
    return m_photo->plane.view();
}

} // namespace spherewalk::render
