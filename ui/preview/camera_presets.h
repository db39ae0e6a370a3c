// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"

#include <QString>

#include <vector>

namespace spherewalk::ui {

/// A camera to choose from.
struct CameraPreset {
    QString name;
    CameraIntrinsics intrinsics;
};

/// Cameras that robots often have, from their makers' data sheets: fields of view, not calibrations.
std::vector<CameraPreset> cameraPresets();

/// The one of them to begin with.
constexpr int kUsualCamera = 2;

} // namespace spherewalk::ui
