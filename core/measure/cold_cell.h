// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"
#include "spherewalk/render/renderer.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace spherewalk::measure {

constexpr const char* kWholeAndRender = "whole decode + render";

struct ColdCells {
    std::vector<BenchRow> rows; ///< "cold_cell", "cold_cell.unverified", "cold_cell.disk"
    bool filesDropped = true;   ///< for the last, each file was read from the disk indeed
};

/// The first view of a photo that nobody decoded ahead: level, 90 degrees, the default sampling, all threads;
/// from Renderer::render() to the picture. In turns with what it replaces: reading the file, decoding all of
/// it on one thread by libjpeg-turbo, and a view. Both hash the file, or ("unverified") do not. The file is
/// in the system's cache, as after its first use, or ("disk") is not. Photos are taken in turns; when all
/// have been seen, a new renderer begins anew. Errors: those of rendering; Stopped.
ColdCells measureColdCells(const std::shared_ptr<const render::Dataset>& dataset, int views,
                           ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::measure
