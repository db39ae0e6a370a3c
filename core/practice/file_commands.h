// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_storage.h"
#include "osc_error.h"

#include <string>

namespace spherewalk::practice {

// The commands about files, over the camera's storage. Errors: OscError.

/// The results of camera.listFiles. baseUrl: "http://host:port", with which file URLs begin.
Json listedFiles(const CameraStorage& storage, const Json& parameters, const std::string& baseUrl);
/// The results of camera.listImages of API level 1.
Json listedImages(const CameraStorage& storage, const Json& parameters);
/// camera.delete: all of the files or none.
void deleteFiles(CameraStorage& storage, const Json& parameters);

} // namespace spherewalk::practice
