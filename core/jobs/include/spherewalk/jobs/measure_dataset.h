// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/jobs/measure_report.h"
#include "spherewalk/jobs/robot_pictures.h"
#include "spherewalk/jobs/shard.h"
#include "spherewalk/render/renderer.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

namespace spherewalk::jobs {

struct MeasureOptions {
    /// Compared with the views from their poses; photos are left out all the same, to see what that foretold.
    std::vector<RobotPicture> pictures;
    int mostViews = 200;    ///< of photos that are left out, spread over photos and directions
    int directions = 4;     ///< spread evenly about the horizon
    int samplingViews = 16; ///< of them, that the samplings are compared on
    double tolerancePx = 2; ///< of the robot's camera
    Places places = Places::Features;
    std::optional<render::SceneKind> scene; ///< this one alone; nothing: all that the dataset has
    render::Sampling sampling = render::Sampling::Footprint; ///< that scene models are compared with
    std::size_t worst = 0;                                   ///< views kept in the report
    /// Where results are kept, so that a run that was stopped goes on where it was; empty: nowhere.
    std::filesystem::path cacheFolder;
    int threads = 0;

    /// Errors: InvalidInput.
    void validate() const;
};

/// Compares the views of each scene model of the dataset with the truth, and times them. Photos that are left
/// out are compared as a camera at their place would see them, level, in the given number of directions. What
/// the samplings change is found on some of the views, as the share by which the 95th percentile grows. The
/// same dataset, camera and options give the same errors; times differ. Cost: about a quarter of a second of
/// one core a view and scene model. Errors: those of rendering, of reading the pictures, and of the cache
/// folder; Stopped.
MeasureReport measureDataset(const render::Renderer& renderer, const CameraModel& camera,
                             const MeasureOptions& options, ProgressSink& progress,
                             const std::stop_token& stop);

struct MeasuredPart {
    std::size_t views = 0;  ///< of this part
    std::size_t reused = 0; ///< of them, from an earlier run
    std::size_t ofViews = 0;
};

/// Compares a part of the views and keeps what was found in the cache folder, so that several processes share
/// the work; measureDataset() with the same options then finds all of it there. Errors: InvalidInput without
/// a cache folder; those of measureDataset().
MeasuredPart measurePart(const render::Renderer& renderer, const CameraModel& camera,
                         const MeasureOptions& options, const Shard& shard, ProgressSink& progress,
                         const std::stop_token& stop);

/// Writes the choice into the dataset's description, for views that are made with "auto". Errors:
/// InvalidInput if there is none; those of reading and writing the description.
void storeChoice(const std::filesystem::path& dataset, const MeasureReport& report);

} // namespace spherewalk::jobs
