// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subject.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"

#include <stop_token>
#include <vector>

namespace spherewalk::measure {

constexpr const char* kSphereView = "sphere";

/// What views from surfaces cost: level views of 57 degrees on one thread, half as far from the photo as the
/// next one begins, bilinear and footprint, of each scene model that has surfaces. Rows
/// "scene.<model>.<sampling>", whose peer is the sphere's view in the same run: ratios are below one. Nothing
/// for a dataset without surfaces or without a sphere. Errors: Stopped; those of rendering.
std::vector<BenchRow> measureScenes(const Subject& subject, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop);

} // namespace spherewalk::measure
