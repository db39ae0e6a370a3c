// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset_format.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::dataset {

/// One photo to be written: its file, and what dataset.json is to say of it. Of `entry` the caller fills
/// station, pose, their standard deviations and the rotation's source; the writer fills the rest.
struct SourcePhoto {
    std::filesystem::path file;
    std::string sha256; ///< that the file must have
    render::DatasetPhoto entry;
    /// For the XMP of the dataset's copy, in place of an earlier one.
    std::optional<photo::PositionTag> tag = {};
    std::filesystem::path depthFile = {}; ///< its depth, to be copied; empty for none
};

struct Contents {
    render::DatasetInfo info; ///< all but the photos
    std::vector<SourcePhoto> photos;
};

struct WriteOptions {
    /// Between restart markers; the nearest number that divides a row of the photo is taken. See
    /// resources/docs/formats.md for what others cost.
    int mcusPerInterval = 8;
    int thumbnailWidth = 512;
    int threads = 0; ///< 0: all that the machine has

    /// Errors: InvalidInput.
    void validate() const;
};

struct WriteReport {
    std::size_t photos = 0;
    std::uint64_t sourceBytes = 0; ///< of the photos as they were
    std::uint64_t photoBytes = 0;  ///< of the photos as written, with restart markers
    std::uint64_t totalBytes = 0;  ///< of the whole dataset
    double seconds = 0;
};

/// Writes a dataset, version 1, beside its final place, and renames it into place when it is complete and
/// synced. Errors: Exists if the folder is there already; Corrupt if a photo's bytes have not their hash or
/// are no 2:1 JPEG; Full, Io, Stopped. After an error nothing is left.
WriteReport writeDataset(const Contents& contents, const std::filesystem::path& folder,
                         const WriteOptions& options, ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::dataset
