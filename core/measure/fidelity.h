// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subject.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/measure/bench_report.h"

#include <stop_token>
#include <vector>

namespace spherewalk::measure {

struct FidelityOptions {
    int directions = 40; ///< pitches evenly over +-80 degrees, yaws by the golden angle
    int pixelStep = 1;   ///< every so many pixels along each axis are compared
};

/// Peak signal to noise ratio of each rung against the mean of 8 x 8 samples a pixel, each bilinear and in
/// double precision, of the photo as libjpeg-turbo decodes it. Errors: Stopped. Cost: seconds a direction.
std::vector<RungFidelity> measureFidelity(const Subject& subject, double fieldDeg,
                                          const FidelityOptions& options, ProgressSink& progress,
                                          const std::stop_token& stop);

/// In decibels, of values in [0, 255]; 100 for pictures that are equal. expected: of every pixelStep-th pixel
/// along each axis, from (0, 0), row after row.
double psnrDb(const std::vector<Eigen::Vector3d>& expected, const RgbImage& picture, int pixelStep);

} // namespace spherewalk::measure
