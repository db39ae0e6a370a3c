// SPDX-License-Identifier: Apache-2.0
#include "photo_cache.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace spherewalk::render {

PhotoCache::PhotoCache(std::shared_ptr<const Dataset> dataset, std::uint64_t budgetBytes)
    : m_dataset(std::move(dataset)), m_budgetBytes(budgetBytes) {
}

PhotoCache::Result PhotoCache::get(std::size_t photo) {
    const std::scoped_lock lock(m_mutex);
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.photo == photo; });
    if (found != m_entries.end()) {
        m_entries.splice(m_entries.begin(), m_entries, found);
        return {m_entries.front().picture, 0};
    }
    const auto begin = std::chrono::steady_clock::now();
    m_entries.push_front({photo, decode(photo)});
    dropBeyondBudget();
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
    return {m_entries.front().picture, passed.count()};
}

std::shared_ptr<const RgbImage> PhotoCache::decode(std::size_t photo) const {
    const DatasetPhoto& entry = m_dataset->info().photos.at(photo);
    const std::string source = (m_dataset->folder() / entry.file).string();
    auto picture = std::make_shared<const RgbImage>(jpeg::decode(m_dataset->readPhoto(photo), source));
    if (picture->width() != entry.width || picture->height() != entry.height) {
        throw Error(ErrorKind::Corrupt,
                    text("Could not use ", source, ": it has ", picture->width(), " x ", picture->height(),
                         " pixels, not the ", entry.width, " x ", entry.height, " it should have."));
    }
    return picture;
}

void PhotoCache::dropBeyondBudget() {
    std::uint64_t total = 0;
    for (auto entry = m_entries.begin(); entry != m_entries.end(); ++entry) {
        total += entry->picture->values().size();
        if (total > m_budgetBytes && entry != m_entries.begin()) {
            m_entries.erase(entry, m_entries.end());
            return;
        }
    }
}

} // namespace spherewalk::render
