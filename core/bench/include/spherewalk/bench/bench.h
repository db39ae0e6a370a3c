// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/bench/bench_report.h"
#include "spherewalk/render/dataset.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace spherewalk::bench {

struct BenchOptions {
    /// OpenCV and libjpeg-turbo are measured too, with the same work and in turns with ours.
    bool peers = false;
    bool quick = false; ///< Few repetitions take half a minute and give rough figures.
    /// The walk goes past this number of copies of the dataset's first photo, 20 cm apart. The copies are
    /// made in a temporary folder. With 0, the walk goes past the dataset's own photos. Range: 0 to 10000.
    int gridPhotos = 0;
    /// The errors of samplings are measured at these horizontal fields of view. Range: 1 to 170.
    std::vector<double> fieldsDeg{90, 57};

    /// Errors: InvalidInput.
    void validate() const;
};

/// Measures the render library on this machine with this dataset: times of views, decoding and cold cells;
/// errors of samplings and coordinates; walks in real time; memory. Every result is checked before it is
/// timed. Errors: those of options, dataset and photos; Internal if a check fails; Full, Io for the temporary
/// folder; Stopped. Cost: minutes; all processors.
BenchReport bench(const std::shared_ptr<const render::Dataset>& dataset, const BenchOptions& options,
                  ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::bench
