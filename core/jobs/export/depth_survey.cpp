// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/cache_key.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/recently_used.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/room_fit.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>

namespace spherewalk::jobs {

namespace {

constexpr int kDepthMethod = 5; ///< grows when the same photos and options give another depth
constexpr std::size_t kPicturesKept = 24;
constexpr std::size_t kSmallKept = 1000; ///< pictures of 100 kB
constexpr std::uint64_t kBytesAPixel = 2;
constexpr int kRefinement = 1;              ///< grows when the same agreed depths are refined another way
constexpr double kWithAgreement = 1.25;     ///< a depth's time with the neighbours' agreement, of the sweep's
constexpr double kWithRefinement = 1.5;     ///< the same with refinement, too
constexpr int kSmallWidth = 256;            ///< of the pictures that exposures are told from
constexpr std::size_t kPhotosForScene = 12; ///< that radius and room are estimated from

/// Files are written under another name and renamed: those that are there are whole.
bool isThere(const std::filesystem::path& file) {
    return std::filesystem::is_regular_file(file);
}

void keep(const std::filesystem::path& file, const scene::PhotoDepth& depth) {
    writeFile(file, render::DepthMap(depth.inverseM, depth.sure).serialised());
}

scene::PhotoDepth kept(const std::filesystem::path& file) {
    const auto map = render::DepthMap::read(file);
    return {map.inverseM(), map.sure()};
}

class DepthJob {
  public:
    DepthJob(std::span<const DepthInput> photos, const DepthOptions& options, ProgressSink& progress,
             const std::stop_token& stop)
        : m_photos(photos), m_options(options), m_progress(progress), m_stop(stop) {
        options.sweep.validate();
        for (const DepthInput& photo : photos) {
            m_poses.push_back(photo.roomFromPhoto);
        }
        for (std::size_t i = 0; i < photos.size(); ++i) {
            m_neighbours.push_back(scene::sweepNeighbours(m_poses, i, options.sweep));
        }
        ensureFolder(options.cacheFolder);
    }

    SurveyDepth run() {
        const auto begin = std::chrono::steady_clock::now();
        SurveyDepth result;
        result.files.resize(m_photos.size());
        const std::vector<std::size_t> forScene = photosForScene();
        const std::vector<std::size_t> photos = wanted();
        for (const std::size_t i : photos) {
            throwIfStopped(m_stop);
            result.files[i] = fileOf(wantedKey(i));
            ++result.report.photos;
            if (isThere(result.files[i])) {
                ++result.report.reused;
            } else if (m_options.onlyForScene) {
                agreed(i);
            } else {
                keep(result.files[i], refined(i));
            }
            m_progress.progress(
                static_cast<double>(result.report.photos) / static_cast<double>(photos.size()),
                text("Estimating depth, photo ", result.report.photos, " of ", photos.size()));
        }
        estimateScene(forScene, result);
        if (!m_options.onlyForScene) {
            result.gains = exposures(photos);
        }
        result.report.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result;
    }

    DepthForecast forecast(bool withTrial) {
        DepthForecast result;
        const std::vector<std::size_t> photos = wanted();
        std::set<std::size_t> missing;
        for (const std::size_t photo : photos) {
            if (isThere(fileOf(wantedKey(photo)))) {
                continue;
            }
            addIfDisagreed(photo, missing);
            if (!m_options.onlyForScene) {
                for (const std::size_t other : agreeing(photo)) {
                    addIfDisagreed(other, missing);
                }
            }
        }
        result.photos = photos.size();
        result.missing = missing.size();
        result.bytes = photos.size() * kBytesAPixel * static_cast<std::uint64_t>(m_options.sweep.width) *
                       static_cast<std::uint64_t>(m_options.sweep.width / 2);
        if (withTrial && !missing.empty()) {
            result.secondsAPhoto = secondsToSweep(*missing.begin());
        }
        return result;
    }

    std::vector<std::filesystem::path> keptFiles() const {
        std::vector<std::filesystem::path> files(m_photos.size());
        for (const std::size_t i : photosWithNeighbours()) {
            const std::filesystem::path file = fileOf(refinedKey(i));
            files[i] = isThere(file) ? file : std::filesystem::path();
        }
        return files;
    }

  private:
    std::vector<std::size_t> wanted() const {
        return m_options.onlyForScene ? photosForScene() : photosWithNeighbours();
    }

    /// Adds what must be swept yet for a photo's agreed depth.
    void addIfDisagreed(std::size_t photo, std::set<std::size_t>& to) const {
        if (isThere(fileOf(agreedKey(photo)))) {
            return;
        }
        addIfUnswept(photo, to);
        for (const std::size_t other : agreeing(photo)) {
            addIfUnswept(other, to);
        }
    }

    void addIfUnswept(std::size_t photo, std::set<std::size_t>& to) const {
        if (!isThere(fileOf(sweptKey(photo)))) {
            to.insert(photo);
        }
    }

    /// Its pictures are read for it alone; in a run each is read for many.
    double secondsToSweep(std::size_t photo) {
        using Clock = std::chrono::steady_clock;
        const auto begin = Clock::now();
        picture(photo);
        for (const std::size_t other : m_neighbours[photo]) {
            picture(other);
        }
        const auto read = Clock::now();
        swept(photo);
        const std::chrono::duration<double> reading = read - begin;
        const std::chrono::duration<double> sweeping = Clock::now() - read;
        return reading.count() / static_cast<double>(1 + m_neighbours[photo].size()) +
               (m_options.onlyForScene ? kWithAgreement : kWithRefinement) * sweeping.count();
    }

    scene::PosedPicture posed(std::size_t photo, const RgbImage& picture) const {
        return {&picture, m_poses[photo], m_photos[photo].lenses};
    }

    scene::PosedDepth posed(std::size_t photo, const scene::PhotoDepth& depth) const {
        return {&depth, m_poses[photo], m_photos[photo].lenses};
    }

    std::string placeKey(std::size_t photo) const {
        return text(m_photos[photo].sha256, " ", keyOf(m_poses[photo]), " ", m_photos[photo].lenses.aheadM,
                    "\n");
    }

    /// All that a photo's own depth depends on.
    std::string sweptKey(std::size_t photo) const {
        const scene::SweepOptions& o = m_options.sweep;
        std::string key = text("sweep ", kDepthMethod, " ", o.width, " ", o.coarseWidth, " ", o.distances,
                               " ", o.stepPx, " ", o.nearestM, " ", o.keptShare, "\n", placeKey(photo));
        for (const std::size_t other : m_neighbours[photo]) {
            key += placeKey(other);
        }
        return sha256Hex(bytesOf(key));
    }

    std::span<const std::size_t> agreeing(std::size_t photo) const {
        const std::vector<std::size_t>& all = m_neighbours[photo];
        return {all.data(), std::min(all.size(), static_cast<std::size_t>(m_options.agreeing))};
    }

    std::string agreedKey(std::size_t photo) const {
        std::string key = "agreed " + sweptKey(photo);
        for (const std::size_t other : agreeing(photo)) {
            key += " " + sweptKey(other);
        }
        return sha256Hex(bytesOf(key));
    }

    std::string refinedKey(std::size_t photo) const {
        std::string key = text("refined ", kRefinement, " ", agreedKey(photo));
        for (const std::size_t other : agreeing(photo)) {
            key += " " + agreedKey(other);
        }
        return sha256Hex(bytesOf(key));
    }

    std::string wantedKey(std::size_t photo) const {
        return m_options.onlyForScene ? agreedKey(photo) : refinedKey(photo);
    }

    std::filesystem::path fileOf(const std::string& key) const {
        return m_options.cacheFolder / (key.substr(0, 32) + ".pgm");
    }

    std::shared_ptr<const RgbImage> picture(std::size_t photo) {
        return m_pictures.get(photo, [&] { return decoded(photo, 2 * m_options.sweep.width); });
    }

    /// A photo at the least size that JPEG offers and that has this width, or as it is.
    RgbImage decoded(std::size_t photo, int leastWidth) const {
        if (m_options.beforeReading) {
            m_options.beforeReading(photo);
        }
        const std::filesystem::path& file = m_photos[photo].file;
        return jpeg::decodeAtLeast(readFile(file), file.string(), leastWidth);
    }

    std::shared_ptr<const scene::PhotoDepth> swept(std::size_t photo) {
        return m_swept.get(photo, [&] {
            const std::filesystem::path file = fileOf(sweptKey(photo));
            if (isThere(file)) {
                return kept(file);
            }
            std::vector<std::shared_ptr<const RgbImage>> pictures;
            std::vector<scene::PosedPicture> neighbours;
            for (const std::size_t other : m_neighbours[photo]) {
                pictures.push_back(picture(other));
                neighbours.push_back(posed(other, *pictures.back()));
            }
            const auto own = picture(photo);
            keep(file, scene::sweptDepth(posed(photo, *own), neighbours, m_options.sweep, m_stop));
            return kept(file); // rounded as a later run will find it
        });
    }

    std::shared_ptr<const scene::PhotoDepth> agreed(std::size_t photo) {
        return m_agreed.get(photo, [&] {
            const std::filesystem::path file = fileOf(agreedKey(photo));
            if (!isThere(file)) {
                keep(file, newlyAgreed(photo));
            }
            return kept(file);
        });
    }

    scene::PhotoDepth newlyAgreed(std::size_t photo) {
        std::vector<std::shared_ptr<const scene::PhotoDepth>> depths;
        std::vector<scene::PosedDepth> neighbours;
        for (const std::size_t other : agreeing(photo)) {
            depths.push_back(swept(other));
            neighbours.push_back(posed(other, *depths.back()));
        }
        const auto own = swept(photo);
        return scene::agreeingDepth(posed(photo, *own), *picture(photo), neighbours, m_options.sweep.threads);
    }

    scene::PhotoDepth refined(std::size_t photo) {
        std::vector<std::shared_ptr<const RgbImage>> pictures;
        std::vector<std::shared_ptr<const scene::PhotoDepth>> depths;
        const auto known = [&](std::size_t i) {
            pictures.push_back(picture(i));
            depths.push_back(agreed(i));
            return scene::KnownPhoto{posed(i, *pictures.back()), depths.back().get()};
        };
        std::vector<scene::KnownPhoto> neighbours;
        for (const std::size_t other : agreeing(photo)) {
            neighbours.push_back(known(other));
        }
        return scene::refinedDepth(known(photo), neighbours, m_options.sweep.threads, m_stop);
    }

    std::vector<std::size_t> photosWithNeighbours() const {
        std::vector<std::size_t> photos;
        for (std::size_t i = 0; i < m_photos.size(); ++i) {
            if (!m_neighbours[i].empty()) {
                photos.push_back(i);
            }
        }
        return photos;
    }

    /// Those that radius and room are estimated from, spread evenly.
    std::vector<std::size_t> photosForScene() const {
        const std::vector<std::size_t> all = photosWithNeighbours();
        const std::size_t count = std::min(all.size(), kPhotosForScene);
        std::vector<std::size_t> chosen;
        for (std::size_t k = 0; k < count; ++k) {
            chosen.push_back(all[k * all.size() / count]);
        }
        return chosen;
    }

    /// The picture that exposures are told from.
    std::shared_ptr<const RgbImage> small(std::size_t photo) {
        return m_small.get(
            photo, [&] { return photo::resized(decoded(photo, kSmallWidth), kSmallWidth, kSmallWidth / 2); });
    }

    /// How bright photos are, compared with their neighbours.
    std::vector<scene::Gains> exposures(const std::vector<std::size_t>& photos) {
        std::vector<scene::ExposureRatio> ratios;
        for (const std::size_t photo : photos) {
            throwIfStopped(m_stop);
            const auto own = small(photo);
            const auto depth = agreed(photo);
            for (const std::size_t other : agreeing(photo)) {
                const auto its = small(other);
                const auto itsDepth = agreed(other);
                const auto gains = scene::gainsBySurfaces({posed(photo, *own), depth.get()},
                                                          {posed(other, *its), itsDepth.get()});
                if (gains) {
                    ratios.push_back({photo, other, *gains});
                }
            }
        }
        return scene::commonGains(m_photos.size(), ratios);
    }

    void estimateScene(const std::vector<std::size_t>& photos, SurveyDepth& result) const {
        if (photos.empty()) {
            return;
        }
        std::vector<scene::PhotoDepth> depths(photos.size());
        std::vector<scene::PosedDepth> known;
        for (std::size_t k = 0; k < photos.size(); ++k) {
            depths[k] = kept(fileOf(agreedKey(photos[k]))); // as a run for the scene alone would find it
            known.push_back(posed(photos[k], depths[k]));
        }
        result.radiusM = scene::sphereRadius(known);
        result.room = scene::fittedRoom(known, m_options.drawn);
    }

    std::span<const DepthInput> m_photos;
    const DepthOptions& m_options;
    ProgressSink& m_progress;
    std::stop_token m_stop;
    std::vector<Rigid3> m_poses;
    std::vector<std::vector<std::size_t>> m_neighbours;
    RecentlyUsed<std::size_t, RgbImage> m_pictures{kPicturesKept};
    RecentlyUsed<std::size_t, RgbImage> m_small{kSmallKept};
    RecentlyUsed<std::size_t, scene::PhotoDepth> m_swept{kPicturesKept};
    RecentlyUsed<std::size_t, scene::PhotoDepth> m_agreed{kPicturesKept};
};

} // namespace

SurveyDepth surveyDepth(std::span<const DepthInput> photos, const DepthOptions& options,
                        ProgressSink& progress, const std::stop_token& stop) {
    return DepthJob(photos, options, progress, stop).run();
}

DepthForecast depthForecast(std::span<const DepthInput> photos, const DepthOptions& options, bool withTrial,
                            const std::stop_token& stop) {
    return DepthJob(photos, options, noProgress(), stop).forecast(withTrial);
}

std::vector<std::filesystem::path> keptDepths(std::span<const DepthInput> photos,
                                              const DepthOptions& options) {
    return DepthJob(photos, options, noProgress(), {}).keptFiles();
}

} // namespace spherewalk::jobs
