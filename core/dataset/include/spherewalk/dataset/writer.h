// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset_format.h"
#include "spherewalk/survey/private_region.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::dataset {

/// One photo to be written. The caller fills in `entry` the station, the pose, its standard deviations and
/// the rotation's source; the writer fills in the rest.
struct SourcePhoto {
    std::filesystem::path file;
    std::string sha256; ///< The hash that the file must have.
    render::DatasetPhoto entry;
    /// A tag for the XMP of the dataset's copy, in place of an earlier one.
    std::optional<photo::PositionTag> tag = {};
    std::filesystem::path depthFile = {}; ///< The photo's depth map, which is copied; empty for none.
    /// What is blurred in the photo before anything of it is written, its thumbnail and Exif included.
    std::vector<survey::PrivateRegion> regions = {};
};

struct Contents {
    render::DatasetInfo info; ///< Everything but the photos.
    std::vector<SourcePhoto> photos;
};

struct WriteOptions {
    /// MCUs between restart markers; the writer takes the nearest number that divides a row of the photo.
    /// resources/docs/formats.md tells what other numbers cost.
    int mcusPerInterval = 8;
    int thumbnailWidth = 512;
    int threads = 0; ///< 0 stands for all that the machine has.

    /// Errors: InvalidInput.
    void validate() const;
};

struct WriteReport {
    std::size_t photos = 0;
    std::size_t blurredPhotos = 0;  ///< Photos in which regions were blurred.
    std::size_t blurredRegions = 0; ///< Their regions.
    std::uint64_t sourceBytes = 0;  ///< Size of the photos before.
    std::uint64_t photoBytes = 0;   ///< Size of the photos as written, with restart markers.
    std::uint64_t totalBytes = 0;   ///< Size of the whole dataset.
    double seconds = 0;
};

/// Writes a dataset of version 1 beside its final place, and renames it when it is complete and synced.
/// Errors: InvalidInput without photos; Exists if the folder exists; Corrupt if a photo differs from its hash
/// or is not a JPEG of 2:1; Full, Io, Stopped. After an error nothing is left. Stop: before each photo.
WriteReport writeDataset(const Contents& contents, const std::filesystem::path& folder,
                         const WriteOptions& options, ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::dataset
