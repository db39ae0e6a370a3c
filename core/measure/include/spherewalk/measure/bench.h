// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"
#include "spherewalk/render/dataset.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace spherewalk::measure {

struct BenchOptions {
    bool peers =
        false; ///< OpenCV and libjpeg-turbo are measured too, on the same work and in turns with ours
    bool quick = false; ///< few repetitions: a look in half a minute, with rough figures
    /// The walk goes past so many copies of the dataset's first photo, 20 cm apart, made in a temporary
    /// folder; 0: past the dataset's own photos. Range: 0 to 10000.
    int gridPhotos = 0;
    /// Horizontal fields of view that the samplings' errors are measured at. Range: 1 to 170.
    std::vector<double> fieldsDeg{90, 57};

    /// Errors: InvalidInput.
    void validate() const;
};

/// What the render library does on this machine with this dataset: milliseconds of views, decoding and cold
/// cells; errors of samplings and coordinates; walks in real time; memory. Every result is checked before it
/// is timed. Errors: those of options, dataset and photos; Internal if a check fails; Full, Io for the
/// temporary folder; Stopped. Cost: minutes; all processors.
BenchReport bench(const std::shared_ptr<const render::Dataset>& dataset, const BenchOptions& options,
                  ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::measure
