// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_comparison.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/looks.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <set>

namespace spherewalk::jobs {

namespace {

constexpr std::size_t kMostBorders = 12;
constexpr double kBesideM = 1e-4;

/// A place between two photos, seen from either side. The two cameras stand so near each other that all of
/// the difference is that of the photos.
struct Border {
    Rigid3 before;
    Rigid3 after;
};

std::vector<Border> bordersOf(const render::Dataset& dataset) {
    const std::vector<render::DatasetPhoto>& photos = dataset.info().photos;
    const auto at = [&](std::size_t photo) -> const Eigen::Vector3d& {
        return photos[photo].roomFromPhoto.translation;
    };
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < photos.size() && photos.size() > 1; ++a) {
        const std::size_t b = dataset.nearestPhoto(at(a), a);
        pairs.insert(std::minmax(a, b));
    }
    std::vector<Border> all;
    for (const auto& [a, b] : pairs) {
        const Eigen::Vector3d middle = (at(a) + at(b)) / 2;
        const Eigen::Vector3d aside = kBesideM * (at(b) - at(a)).normalized();
        if (aside.allFinite() && dataset.nearestPhoto(middle - aside) == a &&
            dataset.nearestPhoto(middle + aside) == b) {
            // Neighbouring borders look in quite different directions.
            const Radians turn(std::numbers::pi * (3 - std::sqrt(5)) * static_cast<double>(all.size()));
            const Eigen::Quaterniond rotation = (yawRotation(turn) * bodyFromOptical()).normalized();
            all.push_back({{rotation, middle - aside}, {rotation, middle + aside}});
        }
    }
    std::vector<Border> chosen;
    const std::size_t count = std::min(all.size(), kMostBorders);
    for (std::size_t i = 0; i < count; ++i) {
        chosen.push_back(all[i * all.size() / count]);
    }
    return chosen;
}

Comparison compared(const Border& border, const render::Renderer& renderer, const CameraModel& camera,
                    const SceneAndSampling& with) {
    const auto view = [&](const Rigid3& pose) { return viewOf({pose, {}, {}, {}}, renderer, camera, with); };
    const render::View before = view(border.before);
    const render::View after = view(border.after);
    Comparison comparison;
    comparison.photo = after.report.photo;
    comparison.looks = looksOf(before.picture, {}, after.picture);
    comparison.features = placeErrors(compare::placeDisplacements(compare::PictureFeatures(before.picture),
                                                                  compare::PictureFeatures(after.picture)));
    return comparison;
}

} // namespace

std::vector<BorderJump> borderJumps(const render::Renderer& renderer, const CameraModel& camera,
                                    const MeasureOptions& options,
                                    const std::vector<render::SceneKind>& scenes, ProgressSink& progress,
                                    const std::stop_token& stop) {
    const std::vector<Border> borders = bordersOf(renderer.dataset());
    const render::Sampling sampling = samplingFor(options.sampling, renderer.dataset(), camera);
    const ComparisonCache cache(options.cacheFolder, renderer.dataset().info(), camera.intrinsics());
    std::vector<Comparisons> results(borders.size());
    std::mutex mutex;
    std::size_t done = 0;
    parallelFor(static_cast<int>(borders.size()), 1, options.threads, [&](int i, int /*end*/) {
        const auto border = static_cast<std::size_t>(i);
        const std::string key = text("border ", border, " of ", borders.size());
        Comparisons known = cache.read(key);
        bool isNew = false;
        for (const render::SceneKind scene : scenes) {
            throwIfStopped(stop);
            if (!known.views.contains({scene, sampling})) {
                known.views[{scene, sampling}] =
                    compared(borders[border], renderer, camera, {scene, sampling});
                isNew = true;
            }
        }
        if (isNew) {
            cache.write(key, known);
        }
        results[border] = std::move(known);
        const std::scoped_lock lock(mutex);
        ++done;
        progress.progress(static_cast<double>(done) / static_cast<double>(borders.size()),
                          text("Comparing border ", done, " of ", borders.size()));
    });
    std::vector<BorderJump> jumps;
    for (const render::SceneKind scene : scenes) {
        PlaceErrors places;
        std::vector<Looks> looks;
        for (const Comparisons& known : results) {
            const Comparison& comparison = known.views.at({scene, sampling});
            places.add(comparison.features);
            looks.push_back(comparison.looks);
        }
        if (!looks.empty()) {
            const LooksSummary summary = summaryOf(looks);
            jumps.push_back({scene, looks.size(), summary.mean.psnrDb, summary.worst.psnrDb,
                             quantilePx(places, 0.5), quantilePx(places, 0.95), places.missedShare()});
        }
    }
    return jumps;
}

} // namespace spherewalk::jobs
