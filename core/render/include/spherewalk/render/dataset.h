// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/render/dataset_format.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

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

/// Which photos a view from a place asks for.
struct PhotoQuery {
    std::size_t most = 1;                           ///< How many photos at most.
    std::optional<std::size_t> without = {};        ///< A photo that is left out, if there is another.
    std::function<bool(std::size_t)> isUsable = {}; ///< Photos that may be taken; all of them if it is empty.
    /// The photos of the view before, in its order. They stay, in this order, until the camera is 2 cm beyond
    /// the border at which another photo is as near.
    std::span<const std::size_t> held = {};
};

/// The photos for a view from a place.
struct NearPhotos {
    std::vector<std::size_t> photos; ///< The nearest first; empty if none may be taken.
    bool seesPlace = true; ///< Whether the photos see the place. If none does, the nearest ones are given.
};

class DepthEvidence;
class DepthSteps;
class SightMaps;

/// A dataset on disk, opened and checked. Threads: const functions may run on any number at a time.
class Dataset {
  public:
    /// Reads dataset.json and checks the files. Errors: NotFound, Corrupt, Unsupported, Io; the sentence
    /// names the file at fault. Stopped, when asked to.
    static Dataset open(const std::filesystem::path& folder, Verify verify = Verify::Sizes,
                        ProgressSink& progress = noProgress(), const std::stop_token& stop = {});

    const DatasetInfo& info() const { return m_info; }

    const std::filesystem::path& folder() const { return m_folder; }

    /// The index of the nearest photo that sees the place: the first of photosNear(). Range: a finite point.
    /// without: a photo that is left out, if there is another.
    std::size_t nearestPhoto(const Eigen::Vector3d& pInRoom,
                             std::optional<std::size_t> without = std::nullopt) const;

    /// The photos nearest to a place of those that see it. A photo does not see a place if its own depth
    /// shows a surface well in front of it, or if a wall of the outline or an obstacle lies between. What
    /// leaves way within 10 cm hides nothing, since outlines are rough. A depth that clearly ends beyond the
    /// place counts more than an outline. Range: a finite point. Cost: microseconds, and the reading of a
    /// depth file when it is first asked.
    NearPhotos photosNear(const Eigen::Vector3d& pInRoom, const PhotoQuery& query = {}) const;

    /// Whether a photo sees a place, as photosNear() defines it.
    bool sees(std::size_t photo, const Eigen::Vector3d& pInRoom) const;

    /// Whether a place lies outside of what was scanned: beyond the outline, below the floor, above the
    /// ceiling, or in an obstacle. An obstacle in or over which photos were taken, or a depth shows free
    /// space, is not solid there. Photos that stand beyond the outline themselves belong to what was scanned,
    /// with the free space that their depths show.
    bool isOutside(const Eigen::Vector3d& pInRoom) const;

    /// What a photo's depth tells about its own errors; nothing if the photo has no depth, or none that can
    /// be read.
    std::shared_ptr<const DepthEvidence> evidence(std::size_t photo) const;

    /// A photo's depth. The last ones used are kept. Range: the photo has a depth. Errors: as
    /// DepthMap::read().
    std::shared_ptr<const DepthSteps> depth(std::size_t photo) const;

    /// The bytes of the photo's JPEG. Errors: NotFound, Io; Corrupt if its size or hash is not the one that
    /// dataset.json says.
    Bytes readPhoto(std::size_t photo) const;

  private:
    Dataset(std::filesystem::path folder, DatasetInfo info);
    void checkSizes() const;
    bool seesFirmly(std::size_t photo, const Eigen::Vector3d& pInRoom) const;

    std::filesystem::path m_folder;
    DatasetInfo m_info;
    std::shared_ptr<SightMaps> m_sight;
};

} // namespace spherewalk::render
