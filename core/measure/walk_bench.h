// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"
#include "spherewalk/render/dataset.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace spherewalk::measure {

struct WalkOptions {
    std::vector<double> speedsMS;
    int views = 90; ///< of each walk, 30 a second, after a start of ten that are counted apart
};

/// Walks along a serpentine through the photos' places and back, looking about slowly, in real time: at each
/// speed with each policy for late views and prefetch, and waiting without prefetch. Each begins at full
/// speed with nothing in memory. Views have 640 x 480 pixels and 90 degrees, the renderer and its streams
/// their default options. Errors: those of rendering; Stopped. Cost: views / 30 s for each walk.
std::vector<WalkRow> measureWalks(const std::shared_ptr<const render::Dataset>& dataset,
                                  const WalkOptions& options, ProgressSink& progress,
                                  const std::stop_token& stop);

/// The way from one end of that serpentine to the other.
double walkLengthM(const render::Dataset& dataset);

/// Looks all round at each photo, one after the other, at most so many; returns how many. Memory is at its
/// peak thereafter.
std::size_t lookAllRound(const std::shared_ptr<const render::Dataset>& dataset, std::size_t mostPhotos,
                         ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::measure
