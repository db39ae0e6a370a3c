// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/find_features.h"

#include "spherewalk/align/features.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

namespace spherewalk::align {

static_assert(std::endian::native == std::endian::little, "the file is little endian");

namespace {

constexpr std::string_view kMagic = "SWFEAT03";
constexpr std::size_t kDigestBytes = 64;
constexpr std::uint32_t kMostCount = 50000;
constexpr std::uint32_t kMostDescriptorBytes = 128;

template <class Value>
void append(const Value* values, std::size_t count, Bytes& bytes) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(values);
    bytes.insert(bytes.end(), first, first + count * sizeof(Value));
}

/// Takes values off the front of the bytes. Range: enough bytes are left, as fromBytes() makes sure.
template <class Value>
void take(ByteView& bytes, std::size_t count, Value* values) {
    if (count > 0) {
        std::memcpy(values, bytes.data(), count * sizeof(Value));
        bytes = bytes.subspan(count * sizeof(Value));
    }
}

bool isUsable(const Features& features) {
    const auto isUnit = [](const Eigen::Vector3f& b) { return std::abs(b.norm() - 1) < 1e-4F; };
    const auto isSigma = [](float sigma) { return sigma > 0 && sigma < 1; };
    const auto isFinite = [](float response) { return std::isfinite(response); };
    for (std::size_t i = 0; i < features.firstOf.size(); ++i) {
        if (features.firstOf[i] < 0 || static_cast<std::size_t>(features.firstOf[i]) > i) {
            return false;
        }
    }
    const bool isUpright = !features.vertical || (std::abs(features.vertical->upInPhoto.norm() - 1) < 1e-9 &&
                                                  isSigma(static_cast<float>(features.vertical->sigmaRad)));
    return isUpright && std::all_of(features.bearings.begin(), features.bearings.end(), isUnit) &&
           std::all_of(features.sigmasRad.begin(), features.sigmasRad.end(), isSigma) &&
           std::all_of(features.responses.begin(), features.responses.end(), isFinite);
}

/// The features as a file: magic, key, counts, the vectors (little endian), and the SHA-256 of all that.
Bytes toBytes(const Features& features, std::string_view key) {
    const auto count = static_cast<std::uint32_t>(features.count());
    const std::uint32_t header[] = {static_cast<std::uint32_t>(key.size()),
                                    static_cast<std::uint32_t>(features.detector), count,
                                    static_cast<std::uint32_t>(features.descriptorBytes),
                                    static_cast<std::uint32_t>(features.firstOf.size())};
    Bytes bytes;
    append(kMagic.data(), kMagic.size(), bytes);
    append(header, std::size(header), bytes);
    append(key.data(), key.size(), bytes);
    for (const Eigen::Vector3f& bearing : features.bearings) {
        append(bearing.data(), 3, bytes);
    }
    append(features.sigmasRad.data(), count, bytes);
    append(features.responses.data(), count, bytes);
    append(features.descriptors.data(), features.descriptors.size(), bytes);
    append(features.firstOf.data(), features.firstOf.size(), bytes);
    const Vertical vertical = features.vertical.value_or(Vertical{});
    append(vertical.upInPhoto.data(), 3, bytes);
    append(&vertical.sigmaRad, 1, bytes); // 0 if there is none.
    const std::string digest = sha256Hex(bytes);
    append(digest.data(), digest.size(), bytes);
    return bytes;
}

/// Empty for bytes that toBytes() did not make for this key, or that hold values no features can have.
std::optional<Features> fromBytes(ByteView bytes, std::string_view key) {
    std::uint32_t header[5] = {};
    const std::size_t front = kMagic.size() + sizeof(header) + key.size();
    if (bytes.size() < front + kDigestBytes) {
        return std::nullopt;
    }
    const ByteView content = bytes.first(bytes.size() - kDigestBytes);
    if (textOf(bytes.last(kDigestBytes)) != sha256Hex(content) ||
        textOf(content.first(kMagic.size())) != kMagic) {
        return std::nullopt;
    }
    ByteView rest = content.subspan(kMagic.size());
    take(rest, std::size(header), header);
    const auto [keyBytes, detector, count, descriptorBytes, firsts] = std::to_array(header);
    const std::size_t each = 5 * sizeof(float) + descriptorBytes + (firsts > 0 ? sizeof(int) : 0);
    if (keyBytes != key.size() || textOf(rest.first(key.size())) != key || detector > 2 ||
        count > kMostCount || descriptorBytes > kMostDescriptorBytes || descriptorBytes % 32 != 0 ||
        (count > 0 && descriptorBytes == 0) || (firsts > 0 && firsts != count) ||
        rest.size() - key.size() != count * each + 4 * sizeof(double)) {
        return std::nullopt;
    }
    rest = rest.subspan(key.size());
    Features features;
    features.detector = static_cast<Detector>(detector);
    features.descriptorBytes = static_cast<int>(descriptorBytes);
    features.bearings.resize(count);
    features.sigmasRad.resize(count);
    features.responses.resize(count);
    features.descriptors.resize(static_cast<std::size_t>(count) * descriptorBytes);
    features.firstOf.resize(firsts);
    for (Eigen::Vector3f& bearing : features.bearings) {
        take(rest, 3, bearing.data());
    }
    take(rest, count, features.sigmasRad.data());
    take(rest, count, features.responses.data());
    take(rest, features.descriptors.size(), features.descriptors.data());
    take(rest, features.firstOf.size(), features.firstOf.data());
    Vertical vertical;
    take(rest, 3, vertical.upInPhoto.data());
    take(rest, 1, &vertical.sigmaRad);
    if (vertical.sigmaRad != 0) {
        features.vertical = vertical;
    }
    return isUsable(features) ? std::optional(std::move(features)) : std::nullopt;
}

} // namespace

namespace {

constexpr int kMethod = 1; ///< Grows when the same photo and options give other features.
constexpr std::uint64_t kMostFileBytes = 16 << 20;

std::string settingsText(const FeatureOptions& options, const MaskImage& mask) {
    return text("method ", kMethod, " detector ", std::string(name(options.detector)), " width ",
                options.width, " most ", options.most, " contrast ", options.leastContrast, " lowest ",
                options.lowestElevation.value(), " zenith ", static_cast<int>(options.usesZenith), " wide ",
                static_cast<int>(options.isWide), " mask ", mask.width(), " x ", mask.height(), " ",
                mask.empty() ? std::string("none") : sha256Hex(mask.values()));
}

} // namespace

FeatureCache::FeatureCache(std::filesystem::path folder, const FeatureOptions& options, const MaskImage& mask)
    : m_folder(std::move(folder)), m_settings(settingsText(options, mask)), m_options(options) {
}

std::string FeatureCache::keyOf(const std::string& photoSha256) const {
    return sha256Hex(bytesOf(text(photoSha256, " ", m_settings)));
}

std::filesystem::path FeatureCache::fileOf(const std::string& photoSha256) const {
    return m_folder / (keyOf(photoSha256).substr(0, 32) + ".features");
}

std::optional<Features> FeatureCache::find(const std::string& photoSha256) const {
    Bytes bytes;
    try {
        bytes = readFile(fileOf(photoSha256), kMostFileBytes);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::NotFound ||
            error.kind() == ErrorKind::Corrupt) { // Corrupt: too large for a file of the cache.
            return std::nullopt;
        }
        throw;
    }
    auto features = fromBytes(bytes, keyOf(photoSha256));
    const int most = m_options.isWide ? 5 * m_options.most : m_options.most; // Five views.
    const bool isOurs = features && features->detector == m_options.detector && features->count() <= most;
    return isOurs ? std::move(features) : std::nullopt;
}

void FeatureCache::keep(const std::string& photoSha256, const Features& features) const {
    ensureFolder(m_folder);
    writeFile(fileOf(photoSha256), toBytes(features, keyOf(photoSha256)));
}

namespace {

constexpr std::uint64_t kMostPhotoBytes = 1ULL << 30;

/// While this lives, OpenCV works on its caller's thread alone, since the photos are done in parallel.
class SerialOpenCv {
  public:
    SerialOpenCv() : m_before(cv::getNumThreads()) { cv::setNumThreads(1); }

    ~SerialOpenCv() { cv::setNumThreads(m_before); }

    SerialOpenCv(const SerialOpenCv&) = delete;
    SerialOpenCv& operator=(const SerialOpenCv&) = delete;

  private:
    int m_before;
};

/// Counts the photos that several threads have done.
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

    /// Warns once, since the next photos would fail alike.
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

} // namespace spherewalk::align
