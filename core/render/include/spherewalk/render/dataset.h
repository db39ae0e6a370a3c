// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/render/dataset_format.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>

namespace spherewalk::render {

/// How much of a dataset's files is checked when it is opened.
enum class Verify {
    Sizes,  ///< Every file exists, and each photo has the size that dataset.json says. A photo's hash is
            ///< checked when the photo is read.
    Hashes, ///< The hash of every photo is checked now, too.
};

/// When the SHA-256 of a photo is compared with the one in dataset.json.
enum class VerifyPhotos {
    AtOpen,       ///< All photos are verified already: the dataset was opened with Verify::Hashes.
    BeforeUse,    ///< A photo is verified when it is first used, and the view waits for it.
    InBackground, ///< A ViewStream verifies a photo some time after its first use. The report of a view that
                  ///< was made before then says that it is not verified.
};

/// How much a renderer has decoded since it was made. A request is the part of one photo that one view needs.
struct LoadCounters {
    std::uint64_t hits = 0;         ///< Requests with all their tiles in memory.
    std::uint64_t late = 0;         ///< All other requests.
    std::uint64_t waits = 0;        ///< Late requests that waited.
    std::uint64_t decodedTiles = 0; ///< Tiles that requests waited for.
    std::uint64_t prefetchedTiles = 0;
    std::uint64_t droppedTiles = 0;
    std::uint64_t wholeDecodes = 0;   ///< Decodes of whole photos, as they cannot be decoded in parts.
    std::uint64_t prefetchErrors = 0; ///< The view that needs the tile gets the same Error again.
    double decodeMs = 0;              ///< How long requests waited, for other requests' tiles, too.
    double prefetchMs = 0;
    std::uint64_t residentBytes = 0; ///< The size of the decoded pixels that are in memory now.
};

/// A dataset on disk, opened and checked. Threads: const functions may run on any number at a time.
class Dataset {
  public:
    /// Reads dataset.json and checks the files. Errors: NotFound, Corrupt, Unsupported, Io; the sentence
    /// names the file at fault. Stopped, when asked to.
    static Dataset open(const std::filesystem::path& folder, Verify verify = Verify::Sizes,
                        ProgressSink& progress = noProgress(), const std::stop_token& stop = {});

    const DatasetInfo& info() const { return m_info; }

    const std::filesystem::path& folder() const { return m_folder; }

    /// The index of the photo that was taken nearest to the point; of several, the first. Range: a finite
    /// point. without: a photo that is left out, if there is another.
    std::size_t nearestPhoto(const Eigen::Vector3d& pInRoom,
                             std::optional<std::size_t> without = std::nullopt) const;

    /// The bytes of the photo's JPEG. Errors: NotFound, Io; Corrupt if its size or hash is not the one that
    /// dataset.json says.
    Bytes readPhoto(std::size_t photo) const;

  private:
    Dataset(std::filesystem::path folder, DatasetInfo info);
    void checkSizes() const;

    std::filesystem::path m_folder;
    DatasetInfo m_info;
};

} // namespace spherewalk::render
