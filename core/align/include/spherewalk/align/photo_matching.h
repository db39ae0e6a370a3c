// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"
#include "spherewalk/align/match.h"
#include "spherewalk/base/progress.h"

#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::align {

/// A photo's JPEG on disk.
struct PhotoFile {
    std::filesystem::path file;
    std::string name;   ///< as people call it, for sentences
    std::string sha256; ///< of the file; empty: computed where the cache needs it
};

struct FindOptions {
    FeatureOptions features;
    MaskImage mask;                    ///< of all photos; see detectFeatures()
    std::filesystem::path cacheFolder; ///< empty: nothing is kept
    int threads = 0;                   ///< 0: all that the machine has; each has one photo in memory
};

struct FoundFeatures {
    std::vector<Features> photos; ///< one a photo, of the same order
    int fromCache = 0;            ///< so many of them
    std::vector<int> unreadable;  ///< photos that are not there or damaged: a warning each, and no features
};

/// The features of many photos, whole photos in parallel. The result is the same for any number of threads
/// and with and without the cache. A cache that cannot be written is a warning. Errors: Stopped; InvalidInput
/// of the options; Io. Stop: heard at each view of a photo, what was found till then is in the cache.
/// Threads: one such job at a time, as OpenCV's own threads are switched off meanwhile. Cost: about 250 MB a
/// thread.
FoundFeatures findFeatures(std::span<const PhotoFile> photos, const FindOptions& options,
                           ProgressSink& progress, const std::stop_token& stop);

/// One PhotoPair a pair, of the same order. Range: indices into photos, the first less than the second.
/// Errors: InvalidInput; Stopped. Stop: heard at each pair.
std::vector<PhotoPair> matchPairs(std::span<const Features> photos,
                                  std::span<const std::pair<int, int>> pairs, const MatchOptions& options,
                                  int threads, ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::align
