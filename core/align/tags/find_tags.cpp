// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/room_tags.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace spherewalk::align {

namespace {

constexpr std::uint64_t kLargestPhotoBytes = 1ULL << 30;
constexpr std::uint64_t kMostCacheBytes = 1ULL << 22;
constexpr std::string_view kFormat = "april-tags 2"; ///< Changes whenever other tags would be found.
/// Features of tags are counted from here on, beyond those that are found otherwise.
constexpr int kFirstTagFeature = 1 << 24;
constexpr double kLeastTagSigmaRad = 1.5e-4; ///< Lenses and seams err so much, however sharp a tag is.

Json toJson(const std::vector<photo::SeenTag>& tags) {
    Json list = Json::array();
    for (const photo::SeenTag& tag : tags) {
        Json directions = Json::array();
        for (const Eigen::Vector3d& direction : tag.directions) {
            directions.push_back({direction.x(), direction.y(), direction.z()});
        }
        list.push_back({{"number", tag.number}, {"sigma_rad", tag.sigmaRad}, {"directions", directions}});
    }
    return {{"format", kFormat}, {"tags", list}};
}

std::vector<photo::SeenTag> tagsOf(const Json& json, const std::string& source) {
    const JsonReader reader(json, source);
    std::vector<photo::SeenTag> tags;
    const JsonReader list = reader.member("tags");
    if (reader.string("format") != kFormat) {
        reader.fail("it is of another version");
    }
    for (std::size_t i = 0; i < list.arraySize(1000); ++i) {
        const JsonReader one = list.element(i);
        photo::SeenTag tag;
        tag.number = static_cast<int>(one.integer("number", 0, photo::kTagNumbers - 1));
        tag.sigmaRad = one.number("sigma_rad");
        if (!(tag.sigmaRad > 0)) {
            one.fail("sigma_rad should be above zero");
        }
        const JsonReader directions = one.member("directions");
        if (directions.arraySize(4) != 4) {
            directions.fail("expected four directions");
        }
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const JsonReader direction = directions.element(corner);
            if (direction.arraySize(3) != 3) {
                direction.fail("expected three numbers");
            }
            tag.directions[corner] = {direction.element(0).asNumber(), direction.element(1).asNumber(),
                                      direction.element(2).asNumber()};
            if (!(std::abs(tag.directions[corner].norm() - 1) < 1e-6)) {
                direction.fail("expected a unit vector");
            }
        }
        tags.push_back(tag);
    }
    return tags;
}

class TagJob {
  public:
    TagJob(std::span<const PhotoFile> photos, const FindTagsOptions& options, ProgressSink& progress)
        : m_photos(photos), m_options(options), m_progress(progress), m_found(photos.size()) {}

    std::vector<TagSighting> run(const std::stop_token& stop) {
        parallelFor(static_cast<int>(m_photos.size()), 1, m_options.threads, [&](int i, int /*end*/) {
            throwIfStopped(stop);
            find(static_cast<std::size_t>(i));
        });
        std::vector<TagSighting> sightings;
        for (std::size_t i = 0; i < m_found.size(); ++i) {
            for (const photo::SeenTag& tag : m_found[i]) {
                sightings.push_back({static_cast<int>(i), tag});
            }
        }
        return sightings;
    }

  private:
    void find(std::size_t i) {
        try {
            m_found[i] = keptOrFound(m_photos[i]);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::NotFound && error.kind() != ErrorKind::Corrupt &&
                error.kind() != ErrorKind::Unsupported && error.kind() != ErrorKind::InvalidInput) {
                throw;
            }
        }
        const std::scoped_lock lock(m_mutex);
        m_progress.progress(static_cast<double>(++m_done) / static_cast<double>(m_photos.size()),
                            "Looking for AprilTags");
    }

    std::vector<photo::SeenTag> keptOrFound(const PhotoFile& photo) {
        if (m_options.cacheFolder.empty()) {
            return found(photo);
        }
        const std::string sha256 = photo.sha256.empty() ? sha256HexOfFile(photo.file) : photo.sha256;
        const std::filesystem::path kept = m_options.cacheFolder / (sha256.substr(0, 32) + ".tags");
        try {
            return tagsOf(parseJson(readTextFile(kept, kMostCacheBytes), kept.string()), kept.string());
        } catch (const Error&) { // None is kept, or a damaged file: the photo is looked at.
        }
        std::vector<photo::SeenTag> tags = found(photo);
        try {
            ensureFolder(m_options.cacheFolder);
            writeFile(kept, bytesOf(toJson(tags).dump()));
        } catch (const Error& error) {
            warnOfCache(error);
        }
        return tags;
    }

    static std::vector<photo::SeenTag> found(const PhotoFile& photo) {
        return photo::seenTags(jpeg::decode(readFile(photo.file, kLargestPhotoBytes), photo.file.string()));
    }

    /// Warns once, since the next photos would fail alike.
    void warnOfCache(const Error& error) {
        const std::scoped_lock lock(m_mutex);
        if (!m_isCacheWarned) {
            m_isCacheWarned = true;
            m_progress.warning(text("The next alignment will look for tags anew: ", error.sentence()));
        }
    }

    std::span<const PhotoFile> m_photos;
    const FindTagsOptions& m_options;
    ProgressSink& m_progress;
    std::vector<std::vector<photo::SeenTag>> m_found;
    std::mutex m_mutex;
    std::size_t m_done = 0;
    bool m_isCacheWarned = false;
};

} // namespace

std::vector<TagSighting> findTags(std::span<const PhotoFile> photos, const FindTagsOptions& options,
                                  ProgressSink& progress, const std::stop_token& stop) {
    return TagJob(photos, options, progress).run(stop);
}

void joinTags(std::span<const TagSighting> sightings, std::span<PhotoPair> pairs) {
    std::map<std::pair<int, int>, std::vector<std::size_t>> seen; // By photo and number.
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        seen[{sightings[i].photo, sightings[i].tag.number}].push_back(i);
    }
    const auto feature = [](std::size_t sighting, std::size_t corner) {
        return kFirstTagFeature + static_cast<int>(4 * sighting + corner);
    };
    for (PhotoPair& pair : pairs) {
        for (auto of = seen.lower_bound({pair.a, 0}); of != seen.end() && of->first.first == pair.a; ++of) {
            const auto other = seen.find({pair.b, of->first.second});
            if (other == seen.end() || of->second.size() != 1 || other->second.size() != 1) {
                continue;
            }
            const std::size_t a = of->second.front();
            const std::size_t b = other->second.front();
            const double sigma =
                std::max({kLeastTagSigmaRad, sightings[a].tag.sigmaRad, sightings[b].tag.sigmaRad});
            for (std::size_t corner = 0; corner < 4; ++corner) {
                pair.matches.push_back({sightings[a].tag.directions[corner],
                                        sightings[b].tag.directions[corner], sigma, feature(a, corner),
                                        feature(b, corner)});
            }
        }
    }
}

} // namespace spherewalk::align
