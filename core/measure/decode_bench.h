// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subject.h"

#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/region.h"
#include "spherewalk/measure/bench_report.h"

#include <stop_token>
#include <vector>

namespace spherewalk::measure {

constexpr const char* kLibjpegWhole = "libjpeg-turbo, whole photo";

/// The least rectangle of whole MCUs (16 pixels) that a view straight ahead shows of a photo of this size.
jpeg::PixelRect regionAhead(const CameraModel& camera, const EquirectSize& photo);

/// decode.whole, .region (of a level view of 90 degrees), .reduced (the region at half its size), .thumbnail,
/// and .whole.planes and .region.planes (samples as the JPEG stores them), with one thread and two. A photo
/// without restart markers has but decode.whole and .thumbnail. Before it is timed, each part is compared
/// with the whole, byte by byte. Errors: Internal if they differ; those of reading and decoding; Stopped.
std::vector<BenchRow> measureDecoding(const Subject& subject, bool peers, int rounds, ProgressSink& progress,
                                      const std::stop_token& stop);

} // namespace spherewalk::measure
