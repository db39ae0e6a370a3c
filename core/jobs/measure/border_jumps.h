// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/render/renderer.h"

#include <stop_token>
#include <vector>

namespace spherewalk::jobs {

/// How much views change at borders of cells, for each scene model. Some borders are taken, spread over the
/// dataset: those half way between a photo and its nearest neighbour. A level camera looks at each from both
/// sides, in a direction of its own. The cache folder keeps what was compared. Nothing if no photo has a
/// neighbour. Errors: those of rendering and of the cache folder. Stop: Stopped, between two views.
std::vector<BorderJump> borderJumps(const render::Renderer& renderer, const CameraModel& camera,
                                    const MeasureOptions& options,
                                    const std::vector<render::SceneKind>& scenes, ProgressSink& progress,
                                    const std::stop_token& stop);

} // namespace spherewalk::jobs
