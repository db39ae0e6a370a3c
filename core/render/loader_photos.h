// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tile_store.h"

#include "spherewalk/jpeg/region.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/render/renderer.h"

#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

namespace spherewalk::render {

enum class PhotoTrust { Unverified, Verified, Damaged };

/// The photos of a dataset as a source of tiles: parts of those with restart markers, all of the others.
class LoaderPhotos : public TileSource {
  public:
    LoaderPhotos(std::shared_ptr<const Dataset> dataset, VerifyPhotos verify);
    ~LoaderPhotos() override;

    EquirectSize size(const PhotoLevel& level) const override;
    void check(std::size_t photo) const override;
    /// Errors: as decode().
    bool decodesParts(std::size_t photo) override;
    /// Errors: NotFound, Io; Corrupt, also for every use of a photo after its hash was found to be wrong.
    void decode(const PhotoLevel& level, const jpeg::PixelRect& region, const jpeg::RowSink& sink) override;

    PhotoTrust trust(std::size_t photo) const;

    /// With VerifyPhotos::InBackground: hashes one photo that was used and is not verified yet; false if
    /// there is none. A wrong hash is no error here, but one of every use from now on. Errors: Stopped.
    bool verifyNext(const std::stop_token& stop);

  private:
    struct Open;

    std::shared_ptr<const Open> opened(std::size_t photo);
    void verify(const Open& open, const std::stop_token& stop);
    [[noreturn]] void refuseDamaged(std::size_t photo) const;

    std::shared_ptr<const Dataset> m_dataset;
    VerifyPhotos m_verify;
    std::vector<std::atomic<PhotoTrust>> m_trust;
    std::mutex m_mutex;
    std::list<std::shared_ptr<const Open>> m_open; ///< most recently used first
    std::vector<std::size_t> m_unverified;         ///< used, in the order of their first use
};

} // namespace spherewalk::render
