// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/measure_dataset.h"

#include "measure/measure_comparison.h"
#include "measure/measure_summary.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/renderer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>
#include <numeric>

namespace spherewalk::jobs {

namespace {

using render::Sampling;
using render::SceneKind;

constexpr std::array kTolerancesPx{1.0, 2.0, 4.0, 8.0};
constexpr std::size_t kTimedViews = 8;
constexpr int kTimedRounds = 3;

std::vector<SceneKind> wantedScenes(const MeasureOptions& options, const render::DatasetInfo& info) {
    const std::vector<SceneKind> there = render::scenesOf(info);
    if (!options.scene) {
        return there;
    }
    if (std::find(there.begin(), there.end(), *options.scene) == there.end()) {
        throw Error(ErrorKind::InvalidInput, text("The dataset has no ", name(*options.scene),
                                                  " scene model; use another, or export it with one."));
    }
    return {*options.scene};
}

/// Compares the views with photos that are left out, or with the robot's pictures.
class Measurement {
  public:
    Measurement(const render::Renderer& renderer, const CameraModel& camera, const MeasureOptions& options,
                bool isLeaveOneOut)
        : m_renderer(renderer),
          m_camera(camera),
          m_options(options),
          m_sampling(samplingFor(options.sampling, renderer.dataset(), camera)),
          m_isLeaveOneOut(isLeaveOneOut),
          m_pictures(isLeaveOneOut ? leftOutTruePictures(options, renderer, camera)
                                   : robotTruePictures(options, camera)),
          m_cache(options.cacheFolder, renderer.dataset().info(), camera.intrinsics()),
          m_scenes(wantedScenes(options, renderer.dataset().info())),
          m_results(m_pictures.count) {
        if (m_pictures.count == 0) {
            throw Error(ErrorKind::InvalidInput,
                        "Could not measure: with a single photo there is nothing to compare it with.");
        }
    }

    /// Only the views of this part, into the cache.
    MeasuredPart runPart(const Shard& shard, ProgressSink& progress, const std::stop_token& stop) {
        std::vector<std::size_t> part;
        for (std::size_t i = shard.index; i < m_pictures.count; i += shard.count) { // alike in what they cost
            part.push_back(i);
        }
        compare(part, progress, stop);
        return {part.size(), m_reused, m_pictures.count};
    }

    MeasureReport run(ProgressSink& progress, const std::stop_token& stop) {
        const auto begin = std::chrono::steady_clock::now();
        ProgressStep comparing(progress, 0, 0.95);
        std::vector<std::size_t> all(m_pictures.count);
        std::iota(all.begin(), all.end(), 0);
        compare(all, comparing, stop);
        ProgressStep timing(progress, 0.95, 1);
        MeasureReport report = summarised();
        timeAll(report, timing, stop);
        choose(report);
        report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return report;
    }

  private:
    /// The views of a scene model that are farthest from the truth.
    std::vector<ShownView> worstViews(const SceneLikeness& scene) const {
        std::vector<const ViewLikeness*> views;
        for (const ViewLikeness& view : scene.views) {
            views.push_back(&view);
        }
        const std::size_t count = std::min(views.size(), m_options.worst);
        std::partial_sort(views.begin(), views.begin() + static_cast<std::ptrdiff_t>(count), views.end(),
                          [of = m_options.places](const ViewLikeness* a, const ViewLikeness* b) {
                              const double errorA = a->errorPx(of).value_or(0);
                              const double errorB = b->errorPx(of).value_or(0);
                              return errorA != errorB ? errorA > errorB : a->looks.ssim < b->looks.ssim;
                          });
        views.resize(count);
        std::vector<ShownView> result;
        for (const ViewLikeness* likeness : views) {
            const TruePicture truth = m_pictures.get(likeness->index);
            result.push_back(
                shownView(*likeness, m_options.places, truth.picture,
                          viewOf(truth, m_renderer, m_camera, {scene.scene, scene.sampling}).picture));
        }
        return result;
    }

    void choose(MeasureReport& report) const {
        report.choice = chosen(report, m_options.tolerancePx);
        for (const double tolerancePx : kTolerancesPx) {
            report.choices.push_back(chosen(report, tolerancePx));
        }
        for (const SceneLikeness& scene : report.scenes) {
            if (report.choice.rung && scene.scene == report.rungs[*report.choice.rung].scene) {
                report.worst = worstViews(scene);
            }
        }
    }

    /// Whether the samplings are compared on this picture; evenly spread.
    bool comparesSamplings(std::size_t picture) const {
        return (picture * samplingViews()) % m_pictures.count < samplingViews();
    }

    std::size_t samplingViews() const {
        return std::min(m_pictures.count, static_cast<std::size_t>(m_options.samplingViews));
    }

    void compare(const std::vector<std::size_t>& pictures, ProgressSink& progress,
                 const std::stop_token& stop) {
        std::mutex mutex;
        std::size_t done = 0;
        parallelFor(static_cast<int>(pictures.size()), 1, m_options.threads, [&](int i, int /*end*/) {
            const bool isReused = compareOne(pictures[static_cast<std::size_t>(i)], stop);
            const std::scoped_lock lock(mutex);
            m_reused += isReused ? 1 : 0;
            ++done;
            progress.progress(static_cast<double>(done) / static_cast<double>(pictures.size()),
                              text("Comparing view ", done, " of ", pictures.size()));
        });
    }

    /// Whether all was known from an earlier run.
    bool compareOne(std::size_t i, const std::stop_token& stop) {
        const std::string key = m_pictures.key(i);
        Comparisons known = m_cache.read(key);
        const bool lacksSamplings = comparesSamplings(i) && known.samplings.empty();
        const bool lackedScenes = compareMissing(
            m_scenes, m_sampling, [&] { return m_pictures.get(i); }, m_renderer, m_camera, stop, known);
        if (lacksSamplings) {
            known.samplings = samplingErrors(m_pictures.place(i), m_renderer, m_camera);
        }
        const bool isReused = !lackedScenes && !lacksSamplings;
        if (!isReused) {
            m_cache.write(key, known);
        }
        m_results[i] = std::move(known);
        return isReused;
    }

    MeasureReport summarised() const {
        const render::DatasetInfo& info = m_renderer.dataset().info();
        MeasureReport report;
        report.dataset = info.name;
        report.isLeaveOneOut = m_isLeaveOneOut;
        report.photos = info.photos.size();
        report.places = m_options.places;
        report.directions = m_options.directions;
        report.reusedViews = m_reused;
        report.sphereRadiusM = info.sphereRadiusM;
        report.focalPx = std::max(m_camera.intrinsics().fx, m_camera.intrinsics().fy);
        report.samplingViews = samplingViews();
        std::vector<Eigen::Vector3d> places;
        for (const render::DatasetPhoto& photo : info.photos) {
            places.push_back(photo.roomFromPhoto.translation);
        }
        report.betweenM = betweenPhotosM(places);
        SamplingSummary samplings;
        for (std::size_t i = 0; i < m_pictures.count; ++i) {
            if (comparesSamplings(i)) {
                samplings.add(m_results[i].samplings);
            }
        }
        for (const SceneKind scene : m_scenes) {
            SceneSummary summary(scene, m_sampling, m_options.places);
            for (std::size_t i = 0; i < m_pictures.count; ++i) {
                const Comparison& comparison = m_results[i].views.at({scene, m_sampling});
                summary.add(comparison, likenessOf(i, comparison));
            }
            report.scenes.push_back(summary.result());
            const std::optional<double> errorPx = report.scenes.back().errorPx(m_options.places);
            for (const Sampling sampling : kSamplings) {
                report.rungs.push_back({scene, sampling, samplings.errorWith(sampling, m_sampling, errorPx),
                                        0, bytesWith(scene)});
            }
        }
        std::vector<double> distances;
        for (std::size_t i = 0; i < m_pictures.count;
             ++i) { // of one scene model, since all use the same photos
            const Comparison& comparison = m_results[i].views.at({m_scenes.back(), m_sampling});
            distances.push_back(likenessOf(i, comparison).offset.norm());
        }
        report.viewM = median(std::move(distances));
        return report;
    }

    /// What is known of a view before it was compared.
    ViewLikeness likenessOf(std::size_t i, const Comparison& comparison) const {
        const TruePictures::Place place = m_pictures.place(i);
        const render::DatasetPhoto& from = m_renderer.dataset().info().photos[comparison.photo];
        ViewLikeness view;
        view.subject = place.name;
        view.photo = from.file;
        view.index = i;
        view.leftOut = place.without;
        view.roomFromCamera = place.roomFromCamera;
        view.offset = view.at() - from.roomFromPhoto.translation;
        return view;
    }

    std::uint64_t bytesWith(SceneKind scene) const {
        std::uint64_t bytes = 0;
        for (const render::DatasetPhoto& photo : m_renderer.dataset().info().photos) {
            bytes += photo.sizeBytes;
            if (render::usesDepths(scene) && !photo.depth.empty()) {
                bytes += std::filesystem::file_size(m_renderer.dataset().folder() / photo.depth);
            }
        }
        return bytes;
    }

    /// One after the other, all rungs in turns, so that what else the machine does meets all alike.
    void timeAll(MeasureReport& report, ProgressSink& progress, const std::stop_token& stop) const {
        std::vector<std::vector<double>> ms(report.rungs.size());
        const std::size_t count = std::min(m_pictures.count, kTimedViews);
        for (std::size_t k = 0; k < count; ++k) {
            const TruePictures::Place place = m_pictures.place(k * m_pictures.count / count);
            for (int round = -1; round < kTimedRounds; ++round) { // the first decodes
                for (std::size_t r = 0; r < report.rungs.size(); ++r) {
                    throwIfStopped(stop);
                    render::ViewOptions wanted;
                    wanted.scene = report.rungs[r].scene;
                    wanted.sampling = report.rungs[r].sampling;
                    wanted.threads = m_options.threads;
                    wanted.without = place.without;
                    const double took =
                        m_renderer.render(m_camera, place.roomFromCamera, wanted).report.renderMs;
                    if (round >= 0) {
                        ms[r].push_back(took);
                    }
                }
            }
            progress.progress(static_cast<double>(k + 1) / static_cast<double>(count), "Timing views");
        }
        for (std::size_t r = 0; r < report.rungs.size(); ++r) {
            report.rungs[r].renderMs = median(ms[r]);
        }
    }

    const render::Renderer& m_renderer;
    const CameraModel& m_camera;
    const MeasureOptions& m_options;
    Sampling m_sampling; ///< That scene models are compared with.
    bool m_isLeaveOneOut;
    TruePictures m_pictures;
    ComparisonCache m_cache;
    std::vector<SceneKind> m_scenes;
    std::vector<Comparisons> m_results;
    std::size_t m_reused = 0;
};

} // namespace

void MeasureOptions::validate() const {
    if (mostViews < 1 || directions < 1 || samplingViews < 0 || !(tolerancePx > 0) ||
        sampling == Sampling::Auto) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not measure: at least one view, one direction, a tolerance above 0 and a sampling "
                    "other than auto are needed.");
    }
}

MeasureReport measureDataset(const render::Renderer& renderer, const CameraModel& camera,
                             const MeasureOptions& options, ProgressSink& progress,
                             const std::stop_token& stop) {
    options.validate();
    const bool isLeaveOneOut = options.pictures.empty();
    ProgressStep comparing(progress, 0, isLeaveOneOut ? 0.95 : 0.4);
    MeasureReport report = Measurement(renderer, camera, options, isLeaveOneOut).run(comparing, stop);
    if (!isLeaveOneOut && renderer.dataset().info().photos.size() > 1) {
        ProgressStep leaving(progress, 0.4, 0.95);
        MeasureOptions leftOut = options;
        leftOut.worst = 0;
        auto foretold =
            std::make_shared<MeasureReport>(Measurement(renderer, camera, leftOut, true).run(leaving, stop));
        report.predictions = predictions(*foretold, report, camera);
        report.leaveOneOut = std::move(foretold);
    }
    ProgressStep passing(progress, 0.95, 1);
    report.borders = borderJumps(renderer, camera, options, wantedScenes(options, renderer.dataset().info()),
                                 passing, stop);
    return report;
}

MeasuredPart measurePart(const render::Renderer& renderer, const CameraModel& camera,
                         const MeasureOptions& options, const Shard& shard, ProgressSink& progress,
                         const std::stop_token& stop) {
    options.validate();
    if (options.cacheFolder.empty()) {
        throw Error(ErrorKind::InvalidInput, "Part of a measurement needs a folder to keep its results in.");
    }
    MeasuredPart all;
    for (const bool isLeaveOneOut : {false, true}) {
        if (isLeaveOneOut || !options.pictures.empty()) {
            ProgressStep step(progress, isLeaveOneOut && !options.pictures.empty() ? 0.5 : 0,
                              isLeaveOneOut ? 1 : 0.5);
            const MeasuredPart part =
                Measurement(renderer, camera, options, isLeaveOneOut).runPart(shard, step, stop);
            all = {all.views + part.views, all.reused + part.reused, all.ofViews + part.ofViews};
        }
    }
    return all;
}

} // namespace spherewalk::jobs
