// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"
#include "spherewalk/base/progress.h"

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::align {

/// Features kept on disk, one file a photo, so that a stopped alignment goes on where it was. A file counts
/// only if it is whole and was made from exactly this photo, these options and this mask.
class FeatureCache {
  public:
    /// folder: is made when the first features are kept.
    FeatureCache(std::filesystem::path folder, const FeatureOptions& options, const MaskImage& mask = {});

    /// The kept features of the photo whose file has this SHA-256. Empty if the cache holds none, or if its
    /// file is damaged or was made otherwise. Errors: Io for a file that exists and cannot be read.
    std::optional<Features> find(const std::string& photoSha256) const;
    /// Writes the features durably and replaces what was kept. Errors: those of writeFile().
    void keep(const std::string& photoSha256, const Features& features) const;

    std::filesystem::path fileOf(const std::string& photoSha256) const;

  private:
    std::string keyOf(const std::string& photoSha256) const;

    std::filesystem::path m_folder;
    std::string m_settings; ///< All that features depend on besides the photo.
    FeatureOptions m_options;
};

/// A photo's JPEG on disk.
struct PhotoFile {
    std::filesystem::path file;
    std::string name; ///< The name that sentences for people use.
    /// Of the file, or of another with the same pixels. If empty, the file's is computed where the cache
    /// needs it.
    std::string sha256;
};

struct FindOptions {
    FeatureOptions features;
    MaskImage mask;                    ///< For all photos; see detectFeatures().
    std::filesystem::path cacheFolder; ///< If empty, no features are kept.
    int threads = 0;                   ///< 0 means all that the machine has. Each holds one photo in memory.
};

struct FoundFeatures {
    std::vector<Features> photos; ///< One entry a photo, in the order of the photos.
    int fromCache = 0;            ///< Number of photos whose features came from the cache.
    std::vector<int> unreadable; ///< Photos that are missing or damaged. They have a warning and no features.
};

/// The features of many photos, whole photos in parallel. The result is the same for any number of threads,
/// with and without the cache. A cache that cannot be written gives a warning. Errors: Stopped; InvalidInput
/// of the options; Io. Stop: heard at each view of a photo; what was found until then is in the cache.
/// Threads: one such job at a time, since it switches OpenCV's own threads off. Cost: about 250 MB a thread.
FoundFeatures findFeatures(std::span<const PhotoFile> photos, const FindOptions& options,
                           ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::align
