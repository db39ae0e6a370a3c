// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/dataset/world_file.h"

#include <filesystem>

namespace spherewalk::jobs {

/// The room of a survey or of a dataset, whichever the folder is; the robot's camera begins at the photo, or,
/// while there is none, at the station that is nearest to the middle of them all. Errors: those of opening
/// it; InvalidInput for a folder without photos or stations.
dataset::WorldRoom worldRoomOf(const std::filesystem::path& folder);

/// Writes world.sdf and camera.yaml, the camera that it is for, into a new folder. Errors: Exists, Full, Io;
/// those of dataset::sdfWorld(). After an error nothing is left.
void exportWorld(const dataset::WorldRoom& room, const CameraIntrinsics& camera,
                 const std::filesystem::path& folder);

} // namespace spherewalk::jobs
