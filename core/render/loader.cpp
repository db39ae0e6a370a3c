// SPDX-License-Identifier: Apache-2.0
#include "loader.h"

#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <utility>

namespace spherewalk::render {

namespace {

// Decoded thumbnails of half a megabyte each.
constexpr std::size_t kMostDecoded = 32;
constexpr std::uint64_t kLargestThumbnail = 16ULL << 20;

} // namespace

Thumbnails::Thumbnails(std::shared_ptr<const Dataset> dataset)
    : m_dataset(std::move(dataset)), m_files(m_dataset->info().photos.size()) {
}

std::shared_ptr<const PhotoPlane> Thumbnails::get(std::size_t photo) {
    const std::string& name = m_dataset->info().photos.at(photo).thumbnail;
    if (name.empty()) {
        return nullptr;
    }
    const std::scoped_lock lock(m_mutex);
    const auto found = std::find_if(m_decoded.begin(), m_decoded.end(),
                                    [&](const Entry& entry) { return entry.photo == photo; });
    if (found != m_decoded.end()) {
        m_decoded.splice(m_decoded.begin(), m_decoded, found);
        return m_decoded.front().picture;
    }
    const auto file = m_dataset->folder() / name;
    if (m_files[photo].empty()) {
        m_files[photo] = readFile(file, kLargestThumbnail);
    }
    m_decoded.push_front(
        {photo, std::make_shared<const PhotoPlane>(jpeg::decode(m_files[photo], file.string()))});
    if (m_decoded.size() > kMostDecoded) {
        m_decoded.pop_back();
    }
    return m_decoded.front().picture;
}

ViewLoader::ViewLoader(TileStore& store, std::shared_ptr<Thumbnails> thumbnails)
    : m_store(store), m_thumbnails(std::move(thumbnails)) {
}

Served ViewLoader::wait(const TileNeed& need, int threads) {
    Served served;
    served.photo = need.level.photo;
    served.lease = m_store.acquire(need.level, need.tiles, TileStore::Missing::Decode, threads);
    served.isLate = served.lease.waitedTiles() > 0;
    m_counters.late += served.isLate ? 1 : 0;
    m_counters.waited += served.isLate ? 1 : 0;
    m_previous = need.level.photo;
    return served;
}

std::optional<Served> ViewLoader::servePrevious(const TileNeed& need, const NeedOf& needOf) {
    if (!m_previous || *m_previous == need.level.photo) {
        return std::nullopt;
    }
    Served served;
    served.photo = *m_previous;
    const TileNeed previous = needOf(*m_previous);
    served.lease = m_store.acquire(previous.level, previous.tiles, TileStore::Missing::LeaveOut);
    if (!served.lease.isComplete()) {
        return std::nullopt;
    }
    served.origin = ViewOrigin::PreviousPhoto;
    return served;
}

Served ViewLoader::serve(const TileNeed& need, LatePolicy policy, const NeedOf& needOf, int threads) {
    ++m_counters.views;
    if (policy == LatePolicy::Wait) {
        return wait(need, threads);
    }
    Served served;
    served.photo = need.level.photo;
    served.lease = m_store.acquire(need.level, need.tiles, TileStore::Missing::LeaveOut);
    if (served.lease.isComplete()) {
        m_previous = need.level.photo;
        return served;
    }
    if (policy == LatePolicy::Previous) {
        if (std::optional<Served> previous = servePrevious(need, needOf)) {
            ++m_counters.late;
            ++m_counters.previous;
            previous->isLate = true;
            return std::move(*previous);
        }
    }
    served.coarse = m_thumbnails->get(need.level.photo);
    if (!served.coarse) {
        return wait(need, threads);
    }
    ++m_counters.late;
    ++m_counters.coarse;
    served.origin = ViewOrigin::Thumbnail;
    served.isLate = true;
    return served;
}

} // namespace spherewalk::render
