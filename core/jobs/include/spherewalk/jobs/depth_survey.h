// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/room_shape.h"
#include "spherewalk/scene/depth_sweep.h"

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// In a survey's folder, unless told otherwise.
constexpr const char* kDepthCacheFolder = "depth-cache";

struct DepthOptions {
    scene::SweepOptions sweep;
    int agreeing = 4; ///< neighbours whose depths are compared with a photo's
    /// Where depths are kept, so that a run that was stopped goes on where it was.
    std::filesystem::path cacheFolder = {};
    Polygon drawnOutline = {}; ///< of the room, as far as it was drawn
};

struct DepthInput {
    std::filesystem::path file; ///< a JPEG
    std::string sha256;
    Rigid3 roomFromPhoto;
};

struct DepthReport {
    std::size_t photos = 0; ///< that have a depth
    std::size_t reused = 0; ///< of them, from an earlier run
    double seconds = 0;
};

/// Depths of photos as files in the cache, as render::DepthMap reads them.
struct SurveyDepth {
    std::vector<std::filesystem::path> files; ///< one a photo; empty where no other photo is near enough
    std::optional<double> radiusM;            ///< of the sphere that stands best for them
    std::optional<render::RoomShape> room;    ///< as scene::fittedRoom() found it
    DepthReport report;
};

/// Estimates the depth of each photo, and has neighbours agree on it. Cost: about two seconds a photo on two
/// cores, and 600 MB. Errors: those of reading and decoding the photos, and of scene::sweptDepth(); Stopped.
SurveyDepth surveyDepth(std::span<const DepthInput> photos, const DepthOptions& options,
                        ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::jobs
