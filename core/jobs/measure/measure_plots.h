// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/grid_study.h"
#include "spherewalk/jobs/measure_report.h"

#include <cstddef>
#include <functional>
#include <string>

namespace spherewalk::web {
struct Floor;
}

namespace spherewalk::jobs {

/// The floor within the reach of photos. A run ends where the nearest photo has another colour; an empty
/// colour is no floor. colour: of a photo by its index.
web::Floor floorCells(const render::DatasetInfo& info, const std::function<std::string(std::size_t)>& colour);

/// The room, the photos in it, and the floor within their reach. Shape: SVG, as all functions below.
std::string coveragePlot(const render::DatasetInfo& info);

/// The plan with the error about each photo that was left out, as a colour. Range: a report of photos that
/// were left out.
std::string errorMap(const render::DatasetInfo& info, const SceneLikeness& scene, double tolerancePx);

/// The plan with a disc for each photo that was left out, and in it a sector for each direction.
std::string directionMap(const render::DatasetInfo& info, const SceneLikeness& scene,
                         const MeasureReport& report);

/// Error against time, with a line for each scene model and a point for each sampling.
std::string tradePlot(const MeasureReport& report);

/// Error against the grid's step, with a line for each scene model.
std::string gridPlot(const GridStudy& study);

/// The error found on each picture of a robot against the foretold one.
std::string predictionPlot(const MeasureReport& report);

} // namespace spherewalk::jobs
