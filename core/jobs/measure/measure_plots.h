// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/grid_study.h"
#include "spherewalk/jobs/measure_report.h"

#include <string>

namespace spherewalk::jobs {

/// The room, and where photos stand in it and reach. Shape: SVG, as all below.
std::string coveragePlot(const render::DatasetInfo& info);

/// The plan in the colours of the errors about each photo that was left out, with a margin beyond the
/// outermost ones. Range: a report of photos that were left out.
std::string errorMap(const render::DatasetInfo& info, const SceneLikeness& scene, double tolerancePx);

/// The same, each photo as a disc with a sector a direction.
std::string directionMap(const render::DatasetInfo& info, const SceneLikeness& scene,
                         const MeasureReport& report);

/// Error against time: a line a scene model, a point a sampling.
std::string tradePlot(const MeasureReport& report);

/// Error against the grid's step: a line a scene model.
std::string gridPlot(const GridStudy& study);

/// Errors that were found on a robot's pictures against those that were foretold: a point a picture.
std::string predictionPlot(const MeasureReport& report);

} // namespace spherewalk::jobs
