// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/cache_key.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/recently_used.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/room_fit.h"

#include <algorithm>
#include <chrono>
#include <compare>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <utility>

namespace spherewalk::jobs {

namespace {

constexpr int kDepthMethod = 11; ///< grows when the same photos and options give another depth
constexpr std::size_t kPicturesKept = 24;
constexpr std::size_t kSmallKept = 1000; ///< pictures of 100 kB
constexpr std::uint64_t kBytesAPixel = 2;
constexpr int kRefinement = 7;              ///< grows when the same agreed depths are refined another way
constexpr int kPhotosAtOnce = 4;            ///< whose depth is estimated; each takes 150 MB
constexpr double kShareOfStep = 0.25;       ///< an agreement's or a refinement's time, of the sweep's
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
            m_neighbours.push_back(scene::sweepNeighbours(m_poses, i, options.sweep, options.drawn.outline));
            m_agreeing.push_back(m_neighbours.back());
            m_agreeing.back().resize(
                std::min(m_agreeing.back().size(), static_cast<std::size_t>(options.agreeing)));
        }
        m_sceneKey = text(options.drawn.ceilingM, jobs::keyOf(options.drawn.outline));
        for (const std::size_t photo : photosForScene()) {
            m_sceneKey += keyOf({Kind::Agree, photo});
        }
        ensureFolder(options.cacheFolder);
    }

    SurveyDepth run() {
        const auto begin = std::chrono::steady_clock::now();
        SurveyDepth result;
        result.files.resize(m_photos.size());
        const std::vector<std::size_t> photos = wanted();
        for (const std::size_t i : photos) {
            result.files[i] = fileOf({lastKind(), i});
            result.report.reused += isThere(result.files[i]) ? 1 : 0;
        }
        result.report.photos = photos.size();
        estimateMissing(result);
        if (!m_options.onlyForScene) {
            compareExposures(photos, result);
        }
        result.report.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result;
    }

    DepthForecast forecast(bool withTrial) {
        DepthForecast result;
        const std::set<Step> steps = missing(wanted(), lastKind());
        const auto sweeps = steps.lower_bound({Kind::Sweep, 0});
        result.photos = wanted().size();
        result.missing = static_cast<std::size_t>(std::distance(sweeps, steps.end()));
        result.bytes = result.photos * kBytesAPixel * static_cast<std::uint64_t>(m_options.sweep.width) *
                       static_cast<std::uint64_t>(m_options.sweep.width / 2);
        if (withTrial && sweeps != steps.end()) {
            result.secondsAPhoto = secondsToSweep(sweeps->photo);
        }
        return result;
    }

    std::vector<std::filesystem::path> keptFiles() const {
        std::vector<std::filesystem::path> files(m_photos.size());
        for (const std::size_t i : photosWithNeighbours()) {
            const std::filesystem::path file = fileOf({Kind::Refine, i});
            files[i] = isThere(file) ? file : std::filesystem::path();
        }
        return files;
    }

  private:
    std::vector<std::size_t> wanted() const {
        return m_options.onlyForScene ? photosForScene() : photosWithNeighbours();
    }

    /// A photo's depth is swept, then agreed on with what was swept of its neighbours, then refined with what
    /// was agreed on of them. Steps that need others' results come before those in this list.
    enum class Kind { Refine, Agree, Sweep };

    struct Step {
        Kind kind;
        std::size_t photo;

        auto operator<=>(const Step&) const = default;
    };

    Kind lastKind() const { return m_options.onlyForScene ? Kind::Agree : Kind::Refine; }

    /// What a step needs.
    std::vector<Step> before(const Step& step) const {
        std::vector<Step> steps;
        if (step.kind != Kind::Sweep) {
            const Kind kind = step.kind == Kind::Refine ? Kind::Agree : Kind::Sweep;
            steps.push_back({kind, step.photo});
            for (const std::size_t other : m_agreeing[step.photo]) {
                steps.push_back({kind, other});
            }
        }
        return steps;
    }

    void addIfMissing(const Step& step, std::set<Step>& to) const {
        if (!to.contains(step) && !isThere(fileOf(step))) {
            to.insert(step);
            for (const Step& needed : before(step)) {
                addIfMissing(needed, to);
            }
        }
    }

    /// The steps up to this kind whose result no earlier run has kept.
    std::set<Step> missing(const std::vector<std::size_t>& photos, Kind last) const {
        std::set<Step> steps;
        for (const std::size_t photo : photos) {
            addIfMissing({last, photo}, steps);
            addIfMissing({Kind::Agree, photo}, steps); // which exposures and the scene need
        }
        return steps;
    }

    static double timeOf(const Step& step) { return step.kind == Kind::Sweep ? 1.0 : kShareOfStep; }

    static double timeOf(const std::set<Step>& steps) {
        return std::accumulate(steps.begin(), steps.end(), 0.0,
                               [](double sum, const Step& step) { return sum + timeOf(step); });
    }

    /// The steps that are left, those first for which most was done, while it is in memory.
    std::vector<Step> inOrder(const std::set<Step>& steps) const {
        const std::vector<std::size_t> rank = scene::ranksByPlace(m_poses);
        std::vector<Step> result(steps.begin(), steps.end());
        std::sort(result.begin(), result.end(), [&](const Step& a, const Step& b) {
            return std::pair(a.kind, rank[a.photo]) < std::pair(b.kind, rank[b.photo]);
        });
        return result;
    }

    /// For each step, those of the others that it needs.
    std::vector<std::vector<int>> needsOf(const std::vector<Step>& steps) const {
        std::map<Step, int> places;
        for (const Step& step : steps) {
            places.emplace(step, static_cast<int>(places.size()));
        }
        std::vector<std::vector<int>> needs(steps.size());
        for (std::size_t i = 0; i < steps.size(); ++i) {
            for (const Step& needed : before(steps[i])) {
                if (const auto found = places.find(needed); found != places.end()) {
                    needs[i].push_back(found->second);
                }
            }
        }
        return needs;
    }

    /// Refinements need the room, and so the depths that it is found in.
    void estimateMissing(SurveyDepth& result) {
        const double all = timeOf(missing(wanted(), lastKind()));
        estimate(missing(photosForScene(), Kind::Agree), result.report, all);
        estimateScene(result);
        m_room = result.room;
        estimate(missing(wanted(), lastKind()), result.report, all);
    }

    /// Works on several photos at a time, as threads that share one photo often wait for each other.
    void estimate(const std::set<Step>& left, const DepthReport& report, double all) {
        const std::vector<Step> steps = inOrder(left);
        const int threads = m_options.sweep.threads > 0 ? m_options.sweep.threads : hardwareThreads();
        const int atOnce = std::clamp(static_cast<int>(steps.size()), 1, std::min(threads, kPhotosAtOnce));
        double done = all - timeOf(missing(wanted(), lastKind()));
        std::size_t ready = report.reused;
        std::mutex telling;
        parallelTasks(needsOf(steps), atOnce, [&](int i) {
            const Step& step = steps[static_cast<std::size_t>(i)];
            throwIfStopped(m_stop);
            make(step, (threads + atOnce - 1) / atOnce);
            const std::scoped_lock lock(telling);
            done += timeOf(step);
            ready += step.kind == lastKind() ? 1 : 0;
            m_progress.progress(
                std::min(1.0, done / all),
                text("Estimating depth, photo ", std::min(ready + 1, report.photos), " of ", report.photos));
        });
    }

    void make(const Step& step, int threads) {
        switch (step.kind) {
        case Kind::Sweep:
            return sweep(step.photo, threads);
        case Kind::Agree:
            return agree(step.photo, threads);
        case Kind::Refine:
            return refine(step.photo, threads);
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
        sweep(photo, m_options.sweep.threads);
        const std::chrono::duration<double> reading = read - begin;
        const std::chrono::duration<double> sweeping = Clock::now() - read;
        return reading.count() / static_cast<double>(1 + m_neighbours[photo].size()) +
               (1 + (m_options.onlyForScene ? 1 : 2) * kShareOfStep) * sweeping.count();
    }

    scene::PosedPicture posed(std::size_t photo, const scene::PictureSizes& picture) const {
        return {&picture.largest(), m_poses[photo], m_photos[photo].lenses, &picture, m_photos[photo].gains};
    }

    scene::PosedPicture posed(std::size_t photo, const RgbImage& picture) const {
        return {&picture, m_poses[photo], m_photos[photo].lenses, nullptr, m_photos[photo].gains};
    }

    scene::PosedDepth posed(std::size_t photo, const scene::PhotoDepth& depth) const {
        return {&depth, m_poses[photo], m_photos[photo].lenses};
    }

    std::string placeKey(std::size_t photo) const {
        const auto [red, green, blue] = m_photos[photo].gains.value_or(scene::Gains());
        return text(m_photos[photo].sha256, " ", jobs::keyOf(m_poses[photo]), " ",
                    m_photos[photo].lenses.aheadM, " ", red, " ", green, " ", blue, "\n");
    }

    /// All that a step's result depends on.
    std::string keyOf(const Step& step) const {
        const scene::SweepOptions& o = m_options.sweep;
        std::string key;
        if (step.kind == Kind::Sweep) {
            key = text("sweep ", kDepthMethod, " ", o.width, " ", o.coarseWidth, " ", o.distances, " ",
                       o.stepPx, " ", o.nearestM, " ", o.keptShare, "\n", placeKey(step.photo));
            for (const std::size_t other : m_neighbours[step.photo]) {
                key += placeKey(other);
            }
        } else {
            key = step.kind == Kind::Agree ? std::string("agreed")
                                           : text("refined ", kRefinement, " ", m_sceneKey);
            for (const Step& needed : before(step)) {
                key += " " + keyOf(needed);
            }
        }
        return sha256Hex(bytesOf(key));
    }

    std::filesystem::path fileOf(const Step& step) const {
        return m_options.cacheFolder / (keyOf(step).substr(0, 32) + ".pgm");
    }

    /// A photo at the least size that JPEG offers and that is twice as wide as the depth, or as it is.
    std::shared_ptr<const scene::PictureSizes> picture(std::size_t photo) {
        return m_pictures.get(photo, [&] {
            if (m_options.beforeReading) {
                m_options.beforeReading(photo);
            }
            const std::filesystem::path& file = m_photos[photo].file;
            const int width = 2 * m_options.sweep.width;
            return scene::PictureSizes(jpeg::decodeAtLeast(readFile(file), file.string(), width), width);
        });
    }

    void sweep(std::size_t photo, int threads) {
        std::vector<std::shared_ptr<const scene::PictureSizes>> pictures;
        std::vector<scene::PosedPicture> neighbours;
        for (const std::size_t other : m_neighbours[photo]) {
            pictures.push_back(picture(other));
            neighbours.push_back(posed(other, *pictures.back()));
        }
        const auto own = picture(photo);
        small(photo); // for later, while its picture is in memory
        scene::SweepOptions options = m_options.sweep;
        options.threads = threads;
        keep(fileOf({Kind::Sweep, photo}),
             scene::sweptDepth(posed(photo, *own), neighbours, options, m_stop));
    }

    /// Each depth is read as it was kept, so that it is rounded as a later run will find it.
    std::shared_ptr<const scene::PhotoDepth> found(const Step& step) {
        return m_depths.get(step, [&] { return kept(fileOf(step)); });
    }

    void agree(std::size_t photo, int threads) {
        std::vector<std::shared_ptr<const scene::PhotoDepth>> depths;
        std::vector<scene::PosedDepth> neighbours;
        for (const std::size_t other : m_agreeing[photo]) {
            depths.push_back(found({Kind::Sweep, other}));
            neighbours.push_back(posed(other, *depths.back()));
        }
        const auto own = found({Kind::Sweep, photo});
        const auto pictures = picture(photo);
        keep(fileOf({Kind::Agree, photo}),
             scene::agreeingDepth(posed(photo, *own), pictures->atLeast(m_options.sweep.width), neighbours,
                                  threads));
    }

    void refine(std::size_t photo, int threads) {
        std::vector<std::shared_ptr<const scene::PictureSizes>> pictures;
        std::vector<std::shared_ptr<const scene::PhotoDepth>> depths;
        const auto known = [&](std::size_t i) {
            pictures.push_back(picture(i));
            depths.push_back(found({Kind::Agree, i}));
            return scene::KnownPhoto{posed(i, *pictures.back()), depths.back().get()};
        };
        std::vector<scene::KnownPhoto> neighbours;
        for (const std::size_t other : m_agreeing[photo]) {
            neighbours.push_back(known(other));
        }
        keep(fileOf({Kind::Refine, photo}),
             scene::refinedDepth(known(photo), neighbours, m_room ? &m_room->shape : nullptr, threads,
                                 m_stop));
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
        return spreadEvenly(photosWithNeighbours(), kPhotosForScene);
    }

    /// The picture that exposures are told from.
    std::shared_ptr<const RgbImage> small(std::size_t photo) {
        return m_small.get(photo, [&] {
            return photo::resized(picture(photo)->atLeast(kSmallWidth), kSmallWidth, kSmallWidth / 2);
        });
    }

    /// How bright photos are, compared with their neighbours.
    void compareExposures(const std::vector<std::size_t>& photos, SurveyDepth& result) {
        std::vector<scene::ExposureRatio> ratios;
        for (const std::size_t photo : photos) {
            throwIfStopped(m_stop);
            const auto own = small(photo);
            const auto depth = found({Kind::Agree, photo});
            for (const std::size_t other : m_agreeing[photo]) {
                if (const auto light = scene::sharedLight(
                        {posed(photo, *own), depth.get()},
                        {posed(other, *small(other)), found({Kind::Agree, other}).get()})) {
                    ratios.push_back({photo, other, *light});
                }
            }
        }
        result.gains = scene::commonGains(m_photos.size(), ratios);
        result.highlightRolloff = scene::highlightRolloff(result.gains, ratios);
    }

    void estimateScene(SurveyDepth& result) const {
        const std::vector<std::size_t> photos = photosForScene();
        std::vector<scene::PhotoDepth> depths(photos.size());
        std::vector<scene::PosedDepth> known;
        for (std::size_t k = 0; k < photos.size(); ++k) {
            depths[k] = kept(fileOf({Kind::Agree, photos[k]})); // as a run for the scene alone would find it
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
    std::vector<std::vector<std::size_t>> m_agreeing; ///< The nearest ones of them.
    std::string m_sceneKey;                           ///< All that radius and room depend on.
    std::optional<scene::FittedRoom> m_room;          ///< Once it is found.
    RecentlyUsed<std::size_t, scene::PictureSizes> m_pictures{kPicturesKept};
    RecentlyUsed<std::size_t, RgbImage> m_small{kSmallKept};
    RecentlyUsed<Step, scene::PhotoDepth> m_depths{2 * kPicturesKept};
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
