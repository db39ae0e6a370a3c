// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/render/dataset_format.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <stop_token>

namespace spherewalk::render {

/// How much of a dataset's files is checked when it is opened.
enum class Verify {
    Sizes,  ///< every file is there and has the size that dataset.json says; the hash of a photo when it is
            ///< read
    Hashes, ///< and the hash of every photo now
};

/// A dataset on disk, opened and checked. Threads: const, any number.
class Dataset {
  public:
    /// Errors: NotFound, Corrupt, Unsupported, Io; the sentence names the file at fault.
    static Dataset open(const std::filesystem::path& folder, Verify verify = Verify::Sizes,
                        ProgressSink& progress = noProgress(), const std::stop_token& stop = {});

    const DatasetInfo& info() const { return m_info; }

    const std::filesystem::path& folder() const { return m_folder; }

    /// The photo whose position is nearest; of several, the first. Range: any finite point.
    /// without: a photo that is left out, if there is another.
    std::size_t nearestPhoto(const Eigen::Vector3d& pInRoom,
                             std::optional<std::size_t> without = std::nullopt) const;

    /// The photo's JPEG. Errors: NotFound, Io; Corrupt if its size or hash is not the one of dataset.json.
    Bytes readPhoto(std::size_t photo) const;

  private:
    Dataset(std::filesystem::path folder, DatasetInfo info);
    void checkSizes() const;

    std::filesystem::path m_folder;
    DatasetInfo m_info;
};

} // namespace spherewalk::render
