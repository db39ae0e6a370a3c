// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subject.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"

#include <stop_token>
#include <vector>

namespace spherewalk::measure {

constexpr const char* kViewAlone = "view alone";

/// What more than a picture costs: level views of 90 degrees of the default sampling on one thread, with
/// depth, with trust, with an object that covers a quarter of the picture, and with the same object taken by
/// a wider camera with distortion. Rows "view.with_...", whose peer is the view alone in the same run: ratios
/// are below one. Depth and objects are left out for datasets without a scene model. Errors: Internal if the
/// object is not seen; Stopped.
std::vector<BenchRow> measureExtras(const Subject& subject, int rounds, ProgressSink& progress,
                                    const std::stop_token& stop);

} // namespace spherewalk::measure
