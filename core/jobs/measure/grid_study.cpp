// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/grid_study.h"

#include "measure/measure_summary.h"
#include "measure/photo_grid.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/survey/plan_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>
#include <span>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

/// The same file under another name where the file system can, else a copy.
void place(const fs::path& from, const fs::path& to) {
    std::error_code failure;
    fs::create_directories(to.parent_path(), failure);
    fs::create_hard_link(from, to, failure);
    if (failure) {
        failure.clear();
        fs::copy_file(from, to, failure);
    }
    if (failure) {
        throw Error(
            failure == std::errc::no_space_on_device ? ErrorKind::Full : ErrorKind::Io,
            text("Could not copy ", from.string(), " to ", to.string(), ": ", failure.message(), "."));
    }
}

/// A dataset of some photos of another one, as if no others had been taken. Removed at the end.
class SubsetDataset {
  public:
    /// depth: of these photos, in their order; its radius and room replace those of the whole dataset; null:
    /// none. Errors: Io, Full; those of Dataset::open().
    SubsetDataset(const render::Dataset& whole, std::span<const std::size_t> photos,
                  const SurveyDepth* depth);

    const render::Renderer& renderer() const { return *m_renderer; }

  private:
    TemporaryFolder m_folder{"spherewalk-subset"};
    std::optional<render::Renderer> m_renderer;
};

SubsetDataset::SubsetDataset(const render::Dataset& whole, std::span<const std::size_t> photos,
                             const SurveyDepth* depth) {
    render::DatasetInfo info = whole.info();
    info.choice.reset();
    info.measuredErrorPx.clear();
    info.photos.clear();
    if (depth != nullptr) {
        info.sphereRadiusM = depth->radiusM ? depth->radiusM : info.sphereRadiusM;
        info.roomShape = depth->room ? std::optional(depth->room->shape) : std::nullopt;
    }
    for (std::size_t i = 0; i < photos.size(); ++i) {
        render::DatasetPhoto photo = whole.info().photos[photos[i]];
        photo.scene.reset();
        photo.depth.clear();
        if (depth != nullptr && !depth->files[i].empty()) {
            photo.depth = text("depth/", depth->files[i].filename().string()); // says what it depends on
            place(depth->files[i], m_folder.path() / photo.depth);
        }
        for (const std::string& name : {photo.file, photo.restartIndex, photo.thumbnail}) {
            if (!name.empty()) {
                place(whole.folder() / name, m_folder.path() / name);
            }
        }
        info.photos.push_back(std::move(photo));
    }
    writeFile(m_folder.path() / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
    m_renderer.emplace(std::make_shared<const render::Dataset>(render::Dataset::open(m_folder.path())));
}

using render::SceneKind;

constexpr double kDepthShare = 0.7; ///< of a step's time, where depth is estimated

std::string cm(double metres) {
    return text(fixed(100 * metres, 0), " cm");
}

/// What is compared of one split.
struct HeldOutView {
    std::size_t photo;
    Radians turn;
};

std::vector<HeldOutView> heldOutViews(const GridSplit& split, std::size_t most, int directions) {
    std::vector<HeldOutView> views;
    for (const SpreadView& view : spreadViews(split.heldOut.size(), directions, most)) {
        const double share = static_cast<double>(view.direction) / directions;
        views.push_back({split.heldOut[view.photo], Radians(2 * std::numbers::pi * share)});
    }
    return views;
}

class Study {
  public:
    Study(const render::Renderer& renderer, const CameraModel& camera, const GridStudyOptions& options,
          const std::stop_token& stop)
        : m_renderer(renderer),
          m_camera(camera),
          m_options(options),
          m_sampling(samplingFor(options.sampling, renderer.dataset(), camera)),
          m_stop(stop) {
        for (const render::DatasetPhoto& photo : photos()) {
            m_places.push_back(photo.roomFromPhoto.translation);
        }
    }

    GridStudy run(ProgressSink& progress) {
        const PhotoGrid grid(m_places);
        std::vector<std::vector<GridSplit>> steps;
        for (int every = 1; every <= m_options.largest; ++every) {
            steps.push_back(bestSplits(grid, every, m_options.mostOffsets));
        }
        std::erase_if(steps, [](const auto& splits) { return splits.empty(); });
        if (steps.empty()) {
            throw Error(ErrorKind::InvalidInput,
                        "The photos form no grid with a photo between others: take a block of 3 x 3 or more, "
                        "5 x 5 best, at the finest step that you would scan with.");
        }
        GridStudy study;
        study.gridStepM = grid.stepM();
        study.photos = m_places.size();
        study.tolerancePx = m_options.tolerancePx;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const auto all = static_cast<double>(steps.size());
            ProgressStep step(progress, static_cast<double>(i) / all, static_cast<double>(i + 1) / all);
            studyStep(steps[i], grid.stepM(), step, study);
        }
        return study;
    }

  private:
    const std::vector<render::DatasetPhoto>& photos() const { return m_renderer.dataset().info().photos; }

    void studyStep(const std::vector<GridSplit>& splits, double gridStepM, ProgressSink& progress,
                   GridStudy& study) {
        std::map<SceneKind, SceneSummary> summaries;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < splits.size(); ++i) {
            const auto all = static_cast<double>(splits.size());
            ProgressStep part(progress, static_cast<double>(i) / all, static_cast<double>(i + 1) / all);
            kept += splits[i].kept.size();
            studySplit(splits[i], static_cast<std::size_t>(m_options.mostViews) / splits.size() + 1,
                       cm(splits[i].grid.stepM(gridStepM)), part, summaries);
        }
        for (const auto& [scene, summary] : summaries) {
            const SceneLikeness found = summary.result();
            study.rows.push_back({splits.front().grid.stepM(gridStepM), scene, kept, found.views.size(),
                                  found.looks.mean, found.medianPx, found.p95Px, found.missedShare});
        }
    }

    void studySplit(const GridSplit& split, std::size_t mostViews, const std::string& step,
                    ProgressSink& progress, std::map<SceneKind, SceneSummary>& summaries) {
        const double shareOfDepth = m_options.withDepth ? kDepthShare : 0;
        ProgressStep finding(progress, 0, shareOfDepth);
        const std::optional<SurveyDepth> depth = depthOf(split, finding);
        const SubsetDataset subset(m_renderer.dataset(), split.kept, depth ? &*depth : nullptr);
        const render::DatasetInfo& info = subset.renderer().dataset().info();
        const ComparisonCache cache(m_options.cacheFolder, info, m_camera.intrinsics());
        const std::vector<HeldOutView> views = heldOutViews(split, mostViews, m_options.directions);
        std::vector<Comparisons> results(views.size());
        ProgressStep comparing(progress, shareOfDepth, 1);
        std::mutex mutex;
        std::size_t done = 0;
        parallelFor(static_cast<int>(views.size()), 1, m_options.threads, [&](int i, int /*end*/) {
            const auto k = static_cast<std::size_t>(i);
            results[k] = compareView(views[k], subset.renderer(), render::scenesOf(info), cache);
            const std::scoped_lock lock(mutex);
            comparing.progress(static_cast<double>(++done) / static_cast<double>(views.size()),
                               text("Grid of ", step, ": comparing view ", done, " of ", views.size()));
        });
        for (const Comparisons& result : results) {
            for (const auto& [with, comparison] : result.views) {
                summaries.try_emplace(with.first, with.first, with.second, Places::Features)
                    .first->second.add(comparison, ViewLikeness{});
            }
        }
    }

    /// From the kept photos alone.
    std::optional<SurveyDepth> depthOf(const GridSplit& split, ProgressSink& progress) {
        if (!m_options.withDepth) {
            return std::nullopt;
        }
        std::vector<DepthInput> inputs;
        for (const std::size_t photo : split.kept) {
            inputs.push_back({m_renderer.dataset().folder() / photos()[photo].file, photos()[photo].sha256,
                              photos()[photo].roomFromPhoto, photos()[photo].lenses});
        }
        tellGains(inputs);
        DepthOptions depth;
        depth.cacheFolder = m_options.cacheFolder.empty() ? m_ownFolder.path() : m_options.cacheFolder;
        depth.drawn = {m_renderer.dataset().info().outline, m_renderer.dataset().info().ceilingM};
        depth.sweep.threads = m_options.threads;
        return surveyDepth(inputs, depth, progress, m_stop);
    }

    Comparisons compareView(const HeldOutView& view, const render::Renderer& from,
                            const std::vector<SceneKind>& scenes, const ComparisonCache& cache) const {
        const std::string key =
            text("held out ", photos()[view.photo].sha256, " ", view.photo, " ", view.turn.value());
        Comparisons known = cache.read(key);
        const Rigid3 pose = levelPose(photos()[view.photo], view.turn);
        const auto truth = [&] {
            return TruePicture{
                pose, truthFromPhoto(m_renderer, m_camera, pose), {}, {}, photos()[view.photo].exposureGain};
        };
        if (compareMissing(scenes, m_sampling, truth, from, m_camera, m_stop, known)) {
            cache.write(key, known);
        }
        return known;
    }

    const render::Renderer& m_renderer;
    const CameraModel& m_camera;
    const GridStudyOptions& m_options;
    render::Sampling m_sampling; ///< That scene models are compared with.
    std::stop_token m_stop;
    std::vector<Eigen::Vector3d> m_places;
    TemporaryFolder m_ownFolder{"spherewalk-grid"};
};

std::optional<GridCost> costOf(const GridStudyOptions& options, double stepM) {
    if (options.room.outline.empty() || !(options.room.ceilingM > 0)) {
        return std::nullopt;
    }
    survey::PlanOptions plan = options.plan;
    plan.stepM = stepM;
    const survey::PlanReport report = survey::report(options.room, plan, survey::plan(options.room, plan));
    return GridCost{stepM, report.stations, report.minutes};
}

/// Where the error passes the tolerance between two steps, as a power of the step.
double crossing(const GridRow& holds, const GridRow& fails, double tolerancePx) {
    constexpr double kLeastPx = 0.01;
    const double low = std::log(std::max(kLeastPx, *holds.p95Px));
    const double high = std::log(*fails.p95Px);
    const double share = (std::log(tolerancePx) - low) / (high - low);
    return holds.stepM * std::pow(fails.stepM / holds.stepM, std::clamp(share, 0.0, 1.0));
}

GridAnswer answerOf(const GridStudy& study, SceneKind scene, const GridStudyOptions& options) {
    GridAnswer answer{scene, {}, true, {}};
    const GridRow* last = nullptr;
    for (const GridRow& row : study.rows) {
        if (row.scene != scene) {
            continue;
        }
        if (!row.p95Px || *row.p95Px > study.tolerancePx) {
            answer.isLargest = false;
            if (last != nullptr && row.p95Px && std::isfinite(*row.p95Px)) {
                answer.stepM = crossing(*last, row, study.tolerancePx);
            }
            break;
        }
        answer.stepM = row.stepM;
        last = &row;
    }
    if (answer.stepM) {
        answer.stepM = std::floor(100 * *answer.stepM + 1e-6) / 100; // whole centimetres, on the safe side
        answer.cost = costOf(options, *answer.stepM);
    }
    return answer;
}

std::string costWords(const GridCost& cost) {
    return text(cost.photos, " photos, about ",
                humanDuration(std::chrono::duration<double>(60 * cost.minutes)));
}

std::string gridStudyReason(const GridStudy& study) {
    const GridAnswer* best = nullptr;
    for (const GridAnswer& answer : study.answers) {
        if (answer.stepM && (best == nullptr || *answer.stepM > *best->stepM)) {
            best = &answer;
        }
    }
    const std::string wanted = text(fixed(study.tolerancePx, study.tolerancePx < 10 ? 1 : 0), " px");
    if (best == nullptr) {
        const auto least =
            std::min_element(study.rows.begin(), study.rows.end(), [](const GridRow& a, const GridRow& b) {
                return a.p95Px.value_or(1e9) < b.p95Px.value_or(1e9);
            });
        const bool isFound = least->p95Px && std::isfinite(*least->p95Px);
        return text("None of the steps studied holds ", wanted, " in 95 of 100 places; the best, ",
                    cm(least->stepM), " with the scene model ", name(least->scene),
                    isFound ? text(", reaches ", fixed(*least->p95Px, 2), " px.")
                            : ", misses more than 5 of 100 places.",
                    " Study a denser block, or allow more.");
    }
    return text("For ", wanted, " in 95 of 100 places a grid of ", cm(*best->stepM),
                " is enough with the scene model ", name(best->scene),
                best->isLargest ? " (no coarser one was studied)" : "",
                best->cost ? text(": ", costWords(*best->cost)) : "", ".");
}

} // namespace

void GridStudyOptions::validate() const {
    if (!(tolerancePx > 0) || largest < 2 || largest > 20 || mostOffsets < 1 || mostViews < 1 ||
        directions < 1 || sampling == render::Sampling::Auto) {
        throw Error(ErrorKind::InvalidInput,
                    "The grid cannot be studied: a tolerance above 0, 2 to 20 as the largest step, at least "
                    "one offset, view and direction, and a sampling other than auto are needed.");
    }
}

GridStudy gridStudy(const render::Renderer& renderer, const CameraModel& camera,
                    const GridStudyOptions& options, ProgressSink& progress, const std::stop_token& stop) {
    options.validate();
    const auto begin = std::chrono::steady_clock::now();
    GridStudy study = Study(renderer, camera, options, stop).run(progress);
    for (const GridRow& row : study.rows) {
        if (study.costs.empty() || study.costs.back().stepM != row.stepM) {
            if (const auto cost = costOf(options, row.stepM)) {
                study.costs.push_back(*cost);
            }
        }
    }
    for (const SceneKind scene :
         {SceneKind::None, SceneKind::Sphere, SceneKind::Room, SceneKind::Depth, SceneKind::Blend}) {
        if (std::any_of(study.rows.begin(), study.rows.end(),
                        [&](const GridRow& row) { return row.scene == scene; })) {
            study.answers.push_back(answerOf(study, scene, options));
        }
    }
    study.reason = gridStudyReason(study);
    study.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return study;
}

} // namespace spherewalk::jobs
