// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/sampling.h"
#include "spherewalk/render/scene_model.h"

#include <string>
#include <string_view>

namespace spherewalk::render {

/// What a dataset's views are to be made with, as it was measured on the dataset itself against a tolerance:
/// what "auto" stands for.
struct ViewChoice {
    SceneKind scene = SceneKind::None;
    Sampling sampling = Sampling::Footprint; ///< never Auto
    double tolerancePx = 0;                  ///< that was asked for
    double errorPx = 0; ///< measured; 95 of 100 places of a view are displaced by no more
    double focalPx = 0; ///< of the camera that it was measured for, the longer of fx and fy
    std::string reason; ///< sentences for people

    bool operator==(const ViewChoice&) const = default;

    bool isWithin() const { return errorPx <= tolerancePx; }

    /// Whether it says anything about this camera: the same error is more pixels of a longer focal length.
    bool isFor(const CameraIntrinsics& camera) const;
};

/// The scene model that a member names. Errors: Corrupt, naming the place.
SceneKind sceneKind(const JsonReader& reader, std::string_view key);

Json toJson(const ViewChoice& choice);

/// Errors: Corrupt, naming the place, for names that are unknown and numbers that cannot be.
ViewChoice parseViewChoice(const JsonReader& reader);

} // namespace spherewalk::render
