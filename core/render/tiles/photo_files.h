// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/photo_plane.h"
#include "tiles/tile_store.h"

#include "spherewalk/jpeg/region.h"
#include "spherewalk/render/dataset.h"

#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

namespace spherewalk::render {

/// What is known of a photo's hash.
enum class PhotoHash { Unverified, Verified, Damaged };

/// The photos of a dataset as a source of tiles. Photos with restart markers are decoded in parts, others
/// whole.
class PhotoFiles : public TileSource {
  public:
    PhotoFiles(std::shared_ptr<const Dataset> dataset, VerifyPhotos verify);
    ~PhotoFiles() override;

    EquirectSize size(const PhotoLevel& level) const override;
    void check(std::size_t photo) const override;
    /// Errors: as decode().
    bool decodesParts(std::size_t photo) override;
    /// Errors: NotFound, Io; Corrupt, also for every use of a photo after its hash was found to be wrong.
    void decode(const PhotoLevel& level, const jpeg::PixelRect& region, const jpeg::RowSink& sink) override;

    PhotoHash hash(std::size_t photo) const;

    /// With VerifyPhotos::InBackground: hashes one photo that was used and is not verified yet. It returns
    /// false if there is none. A wrong hash is no error here: every later use of the photo throws. Errors:
    /// Stopped.
    bool verifyNext(const std::stop_token& stop);

  private:
    struct Open;

    std::shared_ptr<const Open> opened(std::size_t photo);
    void verify(const Open& open, const std::stop_token& stop);
    [[noreturn]] void refuseDamaged(std::size_t photo) const;

    std::shared_ptr<const Dataset> m_dataset;
    VerifyPhotos m_verify;
    std::vector<std::atomic<PhotoHash>> m_hashes;
    std::mutex m_mutex;
    std::list<std::shared_ptr<const Open>> m_open; ///< The most recently used one is the first.
    std::vector<std::size_t> m_unverified;         ///< Photos in the order of their first use.
};

/// The thumbnails of a dataset. Once read, the bytes of the files stay in memory, and some decoded pictures
/// do. Threads: any, at a time.
class Thumbnails {
  public:
    explicit Thumbnails(std::shared_ptr<const Dataset> dataset);

    /// The decoded thumbnail; null if the photo has none. Errors: NotFound, Io, Corrupt; Unsupported for a
    /// size that cannot be sampled.
    std::shared_ptr<const PhotoPlane> get(std::size_t photo);

  private:
    struct Entry {
        std::size_t photo;
        std::shared_ptr<const PhotoPlane> picture;
    };

    std::shared_ptr<const Dataset> m_dataset;
    std::mutex m_mutex;
    std::vector<Bytes> m_files;
    std::list<Entry> m_decoded; ///< The most recently used one is the first.
};

} // namespace spherewalk::render
