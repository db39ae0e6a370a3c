// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/jobs/looks.h"
#include "spherewalk/render/ladder.h"
#include "spherewalk/survey/plan.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk {
class CameraModel;
}

namespace spherewalk::render {
class Renderer;
}

namespace spherewalk::jobs {

struct GridStudyOptions {
    double tolerancePx = 2;
    int largest = 4;       ///< The coarsest grid keeps every n-th photo. Range: 2 to 20.
    int mostOffsets = 2;   ///< Largest number of grids of one step, shifted against each other.
    int mostViews = 60;    ///< Largest number of views for one step.
    int directions = 4;    ///< Directions spread evenly about the horizon.
    bool withDepth = true; ///< Estimates depths from the kept photos; that takes most of the time.
    render::Sampling sampling = render::Sampling::Footprint;
    survey::Room room;        ///< The room to be scanned. Without an outline no costs are stated.
    survey::PlanOptions plan; ///< The study sets its stepM.
    /// Folder that keeps depths and results for later runs. Empty means that nothing is kept.
    std::filesystem::path cacheFolder;
    int threads = 0; ///< Range: 0 or above; 0 means all that the machine has.

    /// Errors: InvalidInput.
    void validate() const;
};

/// How right views from a coarser grid are, where a robot stands farthest from the grid's photos.
struct GridRow {
    double stepM = 0;
    render::SceneKind scene = render::SceneKind::None;
    std::size_t keptPhotos = 0; ///< Sum over all grids of this step.
    std::size_t views = 0;
    Looks looks;                    ///< Means over the views.
    std::optional<double> medianPx; ///< As in SceneLikeness.
    std::optional<double> p95Px;
    double missedShare = 0;
};

/// What a plan of the room with this step takes.
struct GridCost {
    double stepM = 0;
    int photos = 0;
    double minutes = 0;
};

/// How dense the grid must be for one scene model.
struct GridAnswer {
    render::SceneKind scene = render::SceneKind::None;
    std::optional<double> stepM; ///< The greatest step that holds; nothing if none of the studied steps does.
    bool isLargest = false;      ///< Whether no coarser step was studied.
    std::optional<GridCost> cost;
};

struct GridStudy {
    double gridStepM = 0; ///< Step of the photos that were taken.
    std::size_t photos = 0;
    double tolerancePx = 0;
    std::vector<GridRow> rows;       ///< By step, then by scene model, cheap to exact.
    std::vector<GridCost> costs;     ///< One for each studied step.
    std::vector<GridAnswer> answers; ///< One for each scene model.
    std::string reason;              ///< Sentences.
    double seconds = 0;
};

/// Answers "how dense must my grid be?" from photos of a small dense block. It keeps every second, third, ...
/// photo, estimates scene models from the kept photos alone, renders the views of the photos between, and
/// compares them. These stand as far from the kept ones as a robot can. Between the studied steps the error
/// is interpolated.
///
/// Cost: minutes with depth.
/// Errors: InvalidInput if the photos form no grid with one photo between others; those of rendering, of
/// depths, and of the cache folder; Stopped.
GridStudy gridStudy(const render::Renderer& renderer, const CameraModel& camera,
                    const GridStudyOptions& options, ProgressSink& progress, const std::stop_token& stop);

/// Tables and the reason, for people.
std::string gridStudyText(const GridStudy& study);

Json toJson(const GridStudy& study);

} // namespace spherewalk::jobs
