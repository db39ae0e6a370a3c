// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/trajectory.h"

#include <filesystem>
#include <span>
#include <stop_token>

namespace spherewalk::practice {
class PracticeRoom;
} // namespace spherewalk::practice

namespace spherewalk::jobs {

/// Draws what a robot's camera sees along a path in a practice room: a PNG a pose, its depth beside it, and
/// pictures.csv, which measure and compare read. path: poses of the optical frame; times are ignored. folder:
/// it is made. Errors: InvalidInput for an empty path; Exists if the folder has anything in it; Io, Full.
/// Stop: Stopped, between two pictures; what was drawn stays.
void drawPracticePictures(const practice::PracticeRoom& room, const CameraModel& camera,
                          std::span<const TimedPose> path, const std::filesystem::path& folder,
                          ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::jobs
