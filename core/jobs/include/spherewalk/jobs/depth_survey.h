// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/room_shape.h"
#include "spherewalk/scene/depth_sweep.h"

#include <cstdint>
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
    /// Depths of a dozen photos only, spread evenly: enough for the same radius and room.
    bool onlyForScene = false;
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
    /// One a photo; empty where no other photo is near enough, and where it was not wanted.
    std::vector<std::filesystem::path> files;
    std::optional<double> radiusM;         ///< of the sphere that stands best for them
    std::optional<render::RoomShape> room; ///< as scene::fittedRoom() found it
    DepthReport report;
};

/// Estimates the depth of each photo, and has neighbours agree on it. Cost: about two seconds a photo on two
/// cores, and 600 MB. Errors: those of reading and decoding the photos, and of scene::sweptDepth(); Stopped.
SurveyDepth surveyDepth(std::span<const DepthInput> photos, const DepthOptions& options,
                        ProgressSink& progress, const std::stop_token& stop);

/// What surveyDepth() would take.
struct DepthForecast {
    std::size_t photos = 0;  ///< whose depth is wanted
    std::size_t missing = 0; ///< that must be swept first; the others are known from an earlier run
    std::uint64_t bytes = 0; ///< of the files
    std::optional<double> secondsAPhoto; ///< about, on this machine, of one that is missing; if it was tried

    double seconds() const { return secondsAPhoto.value_or(0) * static_cast<double>(missing); }
};

/// With a trial, sweeps one photo that is missing, times it, and keeps it in the cache. Errors: those of
/// surveyDepth().
DepthForecast depthForecast(std::span<const DepthInput> photos, const DepthOptions& options, bool withTrial,
                            const std::stop_token& stop);

} // namespace spherewalk::jobs
