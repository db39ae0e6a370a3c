// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/photo_matching.h"

#include "spherewalk/align/feature_cache.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <mutex>
#include <optional>

namespace spherewalk::align {

namespace {

constexpr std::uint64_t kMostPhotoBytes = 1ULL << 30;

/// OpenCV works on its caller's thread alone while this lives: the photos are what is done in parallel.
class SerialOpenCv {
  public:
    SerialOpenCv() : m_before(cv::getNumThreads()) { cv::setNumThreads(1); }

    ~SerialOpenCv() { cv::setNumThreads(m_before); }

    SerialOpenCv(const SerialOpenCv&) = delete;
    SerialOpenCv& operator=(const SerialOpenCv&) = delete;

  private:
    int m_before;
};

/// Counts what is done by several threads.
class Counter {
  public:
    Counter(ProgressSink& progress, std::size_t all, std::string_view activity)
        : m_progress(progress), m_all(all), m_activity(activity) {}

    void oneMore() {
        const std::scoped_lock lock(m_mutex);
        m_progress.progress(static_cast<double>(++m_done) / static_cast<double>(m_all), m_activity);
    }

    void warn(const std::string& sentence) {
        const std::scoped_lock lock(m_mutex);
        m_progress.warning(sentence);
    }

  private:
    ProgressSink& m_progress;
    std::size_t m_all;
    std::string_view m_activity;
    std::mutex m_mutex;
    std::size_t m_done = 0;
};

class FeatureJob {
  public:
    FeatureJob(std::span<const PhotoFile> photos, const FindOptions& options, ProgressSink& progress,
               std::stop_token stop)
        : m_photos(photos),
          m_options(options),
          m_stop(std::move(stop)),
          m_counter(progress, photos.size(), "Looking for features") {
        m_found.photos.resize(photos.size());
        if (!options.cacheFolder.empty()) {
            m_cache.emplace(options.cacheFolder, options.features, options.mask);
        }
    }

    FoundFeatures run() {
        const SerialOpenCv serial;
        parallelFor(static_cast<int>(m_photos.size()), 1, m_options.threads, [this](int i, int /*end*/) {
            throwIfStopped(m_stop);
            find(static_cast<std::size_t>(i));
            m_counter.oneMore();
        });
        std::sort(m_found.unreadable.begin(), m_found.unreadable.end());
        return std::move(m_found);
    }

  private:
    void find(std::size_t i) {
        try {
            m_found.photos[i] = m_cache ? fromCacheOrFile(m_photos[i]) : fromFile(m_photos[i]);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::NotFound && error.kind() != ErrorKind::Corrupt &&
                error.kind() != ErrorKind::Unsupported) {
                throw;
            }
            m_counter.warn(text("Left out photo ", m_photos[i].name, ": ", error.sentence()));
            const std::scoped_lock lock(m_mutex);
            m_found.unreadable.push_back(static_cast<int>(i));
        }
    }

    Features fromFile(const PhotoFile& photo) const {
        return detected(photo, readFile(photo.file, kMostPhotoBytes));
    }

    Features detected(const PhotoFile& photo, ByteView bytes) const {
        return detectFeatures(bytes, photo.file.string(), m_options.features, m_options.mask, m_stop);
    }

    Features fromCacheOrFile(const PhotoFile& photo) {
        const std::string known = photo.sha256.empty() ? sha256HexOfFile(photo.file) : photo.sha256;
        if (auto kept = m_cache->find(known)) {
            const std::scoped_lock lock(m_mutex);
            ++m_found.fromCache;
            return std::move(*kept);
        }
        Features features = fromFile(photo);
        try {
            m_cache->keep(known, features);
        } catch (const Error& error) {
            warnOfCache(error);
        }
        return features;
    }

    /// Once: the next photos would fail alike.
    void warnOfCache(const Error& error) {
        {
            const std::scoped_lock lock(m_mutex);
            if (m_isCacheWarned) {
                return;
            }
            m_isCacheWarned = true;
        }
        m_counter.warn(text("An alignment that is stopped will begin anew: ", error.sentence()));
    }

    std::span<const PhotoFile> m_photos;
    const FindOptions& m_options;
    std::stop_token m_stop;
    std::optional<FeatureCache> m_cache;
    Counter m_counter;
    std::mutex m_mutex;
    bool m_isCacheWarned = false;
    FoundFeatures m_found;
};

} // namespace

FoundFeatures findFeatures(std::span<const PhotoFile> photos, const FindOptions& options,
                           ProgressSink& progress, const std::stop_token& stop) {
    options.features.validate();
    return FeatureJob(photos, options, progress, stop).run();
}

std::vector<PhotoPair> matchPairs(std::span<const Features> photos,
                                  std::span<const std::pair<int, int>> pairs, const MatchOptions& options,
                                  int threads, ProgressSink& progress, const std::stop_token& stop) {
    options.validate();
    const int count = static_cast<int>(photos.size());
    for (const auto& [a, b] : pairs) {
        if (a < 0 || a >= b || b >= count) {
            throw Error(ErrorKind::InvalidInput, text("Could not match photos ", a, " and ", b, " of ", count,
                                                      ": the first must come before the second."));
        }
    }
    std::vector<PhotoPair> matched(pairs.size());
    Counter counter(progress, pairs.size(), "Matching photos");
    parallelFor(static_cast<int>(pairs.size()), 1, threads, [&](int i, int /*end*/) {
        throwIfStopped(stop);
        const auto& [a, b] = pairs[static_cast<std::size_t>(i)];
        matched[static_cast<std::size_t>(i)] = {
            a, b,
            matchFeatures(photos[static_cast<std::size_t>(a)], photos[static_cast<std::size_t>(b)], options)};
        counter.oneMore();
    });
    return matched;
}

} // namespace spherewalk::align
