// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/pose_formats.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jobs/ball_overlay.h"
#include "spherewalk/jobs/shard.h"
#include "spherewalk/jobs/walk_bag.h"
#include "spherewalk/render/view_stream.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

namespace spherewalk::jobs {

struct WalkOptions {
    render::ViewOptions view;
    render::StreamOptions
        stream; ///< the poses' times tell how the camera moves; frames are not paced by them
    std::optional<Ball> ball = {};                 ///< laid into each frame
    std::vector<dataset::PoseFormat> formats = {}; ///< whose files are written besides
    std::vector<dataset::BagFormat> bags = {};     ///< walk.bag and walk.mcap
    BagPictures bagPictures = BagPictures::Raw;
    Shard shard = {}; ///< this part of the frames only
};

struct WalkReport {
    std::size_t frames = 0;     ///< of this part
    std::size_t reused = 0;     ///< of them, that were there; what follows is of the others
    bool isComplete = false;    ///< all parts are there
    std::size_t photosUsed = 0; ///< different ones
    double medianRenderMs = 0;
    double medianDecodeMs = 0; ///< of the frames that had to wait for a photo; 0 if none had
    render::StreamCounters stream;
    render::LoadCounters load;
    double worstOffsetM = 0;
    double leastTrust = 1;
};

/// Renders a view at each pose and writes 000000.png ... into the folder, which is made if need be. Frames of
/// the same walk that are there are kept: a walk that was stopped goes on, and parts may be rendered by
/// several processes at once. Once all are there, also index.csv (a line a frame, with its pose and what it
/// was made from), times.csv, contact-sheet.png, the bags, and the files of the formats, for which the room
/// is the world. Files of these names are replaced. With LatePolicy::Wait all but times.csv is the same in
/// every run, whatever the parts. Frames: the poses are of the optical frame. Errors: those of rendering and
/// writing, of bags before anything is rendered; Stopped, with the frames so far kept.
WalkReport walk(const render::Renderer& renderer, const CameraModel& camera,
                const std::vector<TimedPose>& path, const WalkOptions& options,
                const std::filesystem::path& folder, ProgressSink& progress, const std::stop_token& stop);

Json toJson(const render::ViewReport& report);
Json toJson(const render::LoadCounters& counters);
Json toJson(const WalkReport& report);

} // namespace spherewalk::jobs
