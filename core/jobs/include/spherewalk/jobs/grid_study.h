// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/survey/plan.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

struct GridStudyOptions {
    double tolerancePx = 2;
    int largest = 4;       ///< the coarsest grid keeps every so many-th photo. Range: 2 to 20
    int mostOffsets = 2;   ///< grids of one step, shifted against each other
    int mostViews = 60;    ///< of one step
    int directions = 4;    ///< about the horizon
    bool withDepth = true; ///< estimates it from the photos that are kept, which takes most of the time
    render::Sampling sampling = render::Sampling::Footprint;
    survey::Room room;        ///< to be scanned; without an outline nothing is said of photos and minutes
    survey::PlanOptions plan; ///< its stepM is not used
    /// Where depths and results are kept, so that a run that was stopped goes on where it was; empty:
    /// nowhere.
    std::filesystem::path cacheFolder;
    int threads = 0;

    /// Errors: InvalidInput.
    void validate() const;
};

/// What views from a coarser grid are like, seen from where a robot may stand farthest from its photos.
struct GridRow {
    double stepM = 0;
    render::SceneKind scene = render::SceneKind::None;
    std::size_t keptPhotos = 0; ///< of all grids of this step
    std::size_t views = 0;
    double meanPsnrDb = 0;
    std::optional<double> medianPx;
    std::optional<double> p95Px;
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
    std::optional<double> stepM; ///< the greatest that holds; nothing if none of those studied does
    bool isLargest = false;      ///< no coarser one was studied
    std::optional<GridCost> cost;
};

struct GridStudy {
    double gridStepM = 0; ///< of the photos that are there
    std::size_t photos = 0;
    double tolerancePx = 0;
    std::vector<GridRow> rows;       ///< by step, then scene model, cheap to exact
    std::vector<GridCost> costs;     ///< of the steps studied
    std::vector<GridAnswer> answers; ///< one a scene model
    std::string reason;              ///< sentences
    double seconds = 0;
};

/// Answers "how dense must my grid be?" from photos of a small dense block: keeps every second, third ...
/// photo, renders what those between see from the kept ones, with scene models estimated from the kept ones
/// alone, and compares. The photos between stand as far from the kept ones as a robot can. Between the steps
/// studied the error is interpolated. Errors: InvalidInput if the photos form no grid with one between
/// others; those of rendering, depth and the cache; Stopped. Cost: minutes with depth.
GridStudy gridStudy(const render::Renderer& renderer, const CameraModel& camera,
                    const GridStudyOptions& options, ProgressSink& progress, const std::stop_token& stop);

std::string gridStudyText(const GridStudy& study);

Json toJson(const GridStudy& study);

} // namespace spherewalk::jobs
