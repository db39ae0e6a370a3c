// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contest.h"
#include "subject.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"

#include <array>
#include <stop_token>
#include <vector>

namespace spherewalk::measure {

/// Cheap to exact, as render::Sampling lists them.
inline constexpr std::array kRungs{render::Sampling::Nearest, render::Sampling::Bilinear,
                                   render::Sampling::Reduced, render::Sampling::Footprint,
                                   render::Sampling::Bicubic};

/// "view.bilinear" at 90 degrees, level; ".57" and ".steep" follow where it is another field, or pitched.
std::string viewRowName(render::Sampling sampling, const ViewSetting& setting);

constexpr const char* kMapsAndRemap = "OpenCV maps + remap";
constexpr const char* kRemap = "OpenCV remap";                  ///< ready maps, another each time
constexpr const char* kRemapSameMap = "OpenCV remap, same map"; ///< the camera stands still
constexpr const char* kOneThread = "one thread";

/// Each rung with one thread and two, the camera turning by 7.3 degrees and moving every frame; from
/// Renderer::render() to the picture, with all of the photo in memory. Before anything is timed, bilinear
/// views are compared with exact ones and with OpenCV's, and those of two threads with those of one.
/// Errors: Internal if they differ; Stopped.
std::vector<BenchRow> measureViews(const Subject& subject, const ViewSetting& setting, bool peers, int rounds,
                                   ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::measure
