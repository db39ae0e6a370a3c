// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/jobs/measure_report.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/jobs/shard.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

namespace spherewalk::render {
class Renderer;
}

namespace spherewalk::jobs {

struct MeasureOptions {
    /// Pictures to compare with the views from their poses. Photos are left out all the same, to see what
    /// that foretold.
    std::vector<RobotPicture> pictures;
    int mostViews = 200;    ///< Largest number of views, spread over photos and directions.
    int directions = 4;     ///< Directions spread evenly about the horizon.
    int samplingViews = 16; ///< Number of views that the samplings are compared on.
    double tolerancePx = 2; ///< In pixels of the robot's camera. Range: above 0.
    Places places = Places::Features;
    std::optional<render::SceneKind> scene; ///< The only scene model to measure; nothing means all.
    render::Sampling sampling =
        render::Sampling::Footprint; ///< The sampling that scene models are measured with.
    std::size_t worst = 0;           ///< Number of views that the report keeps.
    /// Folder that keeps results for later runs. Empty means that nothing is kept.
    std::filesystem::path cacheFolder;
    int threads = 0; ///< Range: 0 or above; 0 means all that the machine has.

    /// Errors: InvalidInput.
    void validate() const;
};

/// Compares the views of each scene model of the dataset with true pictures, and times them. A photo that is
/// left out serves as the true picture of a level camera at its place, in the given number of directions.
/// Some of the views show by which share a sampling makes the 95th percentile grow. The same dataset, camera
/// and options give the same errors; times differ.
///
/// Cost: about a third of a second of one core for each view and scene model.
/// Errors: InvalidInput; those of rendering, of reading the pictures, and of the cache folder.
/// Stop: Stopped, between two views; the cache folder keeps the views so far.
MeasureReport measureDataset(const render::Renderer& renderer, const CameraModel& camera,
                             const MeasureOptions& options, ProgressSink& progress,
                             const std::stop_token& stop);

struct MeasuredPart {
    std::size_t views = 0;   ///< Views of this part.
    std::size_t reused = 0;  ///< Views of this part that an earlier run compared.
    std::size_t ofViews = 0; ///< Views of all parts.
};

/// Compares a part of the views and keeps the results in the cache folder, so that several processes share
/// the work. measureDataset() with the same options then finds all of them there. Errors: InvalidInput
/// without a cache folder; those of measureDataset().
MeasuredPart measurePart(const render::Renderer& renderer, const CameraModel& camera,
                         const MeasureOptions& options, const Shard& shard, ProgressSink& progress,
                         const std::stop_token& stop);

} // namespace spherewalk::jobs
