// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/render/dataset.h"

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>

namespace spherewalk::render {

/// Decoded photos, at most `budgetBytes` of them and always the last one used; least recently used ones leave
/// first. Threads: all functions may be called from any; two that want the same new photo decode it once, one
/// after the other.
class PhotoCache {
  public:
    PhotoCache(std::shared_ptr<const Dataset> dataset, std::uint64_t budgetBytes);

    struct Result {
        std::shared_ptr<const RgbImage> photo;
        double decodeMs = 0; ///< 0 if it was there
    };

    /// Errors: those of Dataset::readPhoto(); Corrupt if the picture cannot be decoded or has another size
    /// than stated.
    Result get(std::size_t photo);

  private:
    struct Entry {
        std::size_t photo;
        std::shared_ptr<const RgbImage> picture;
    };

    std::shared_ptr<const RgbImage> decode(std::size_t photo) const;
    void dropBeyondBudget();

    std::shared_ptr<const Dataset> m_dataset;
    std::uint64_t m_budgetBytes;
    std::mutex m_mutex;
    std::list<Entry> m_entries; ///< most recently used first
};

} // namespace spherewalk::render
