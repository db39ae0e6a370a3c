// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/bag.h"
#include "spherewalk/dataset/pose_formats.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jobs/object_overlay.h"
#include "spherewalk/jobs/shard.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/sensor.h"
#include "spherewalk/render/view_stream.h"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

/// How a bag holds the frames.
enum class BagPictures {
    Raw, ///< Topic /camera/image_raw, sensor_msgs/Image.
    Png, ///< Topic /camera/image_raw/compressed, sensor_msgs/CompressedImage with the frames' own files.
};

/// The kind that "raw" or "png" names. Errors: InvalidInput, whose sentence lists the names.
BagPictures bagPictures(std::string_view name);

/// A camera that walks.
struct WalkCamera {
    /// Of a camera of a rig: its files are in a folder of this name, its topics begin with it. Empty for the
    /// only one.
    std::string name;
    std::string frameId = "camera_optical"; ///< Of its optical frame, in a bag.
    CameraIntrinsics intrinsics;
    std::vector<TimedPose> path; ///< Of its optical frame.
};

/// The cameras of a rig, whose frame follows the path. Errors: those of render::placesOnRig(). what: the rig,
/// for sentences.
std::vector<WalkCamera> walkCameras(const std::vector<render::RigCamera>& rig,
                                    const std::vector<TimedPose>& roomFromRig, std::string_view what);

struct WalkOptions {
    render::ViewOptions view;
    /// How frames arrive. The poses' times tell how the camera moves; nothing waits for them.
    render::StreamOptions stream;
    std::vector<Ball> balls = {};                  ///< Balls that are laid into each frame.
    std::vector<dataset::PoseFormat> formats = {}; ///< Pose files to write besides.
    std::vector<dataset::BagFormat> bags = {};     ///< Bags to write besides: walk.bag, walk.mcap.
    BagPictures bagPictures = BagPictures::Raw;
    Shard shard = {}; ///< The part of the frames to render.
    /// The sensor that takes the frames: without it, frames are the views. Frames before a part are rendered,
    /// too, where exposure or white balance is automatic.
    std::optional<render::SensorModel> sensor = {};
    bool writesDepth = false;            ///< Whether depth/000000.png ... are written, with what is laid in.
    bool writesLabels = false;           ///< Whether annotations.json and labels/000000.png ... are written.
    std::vector<PlacedMesh> meshes = {}; ///< Meshes that are laid into each frame.
    bool lightsBalls = false;            ///< Whether balls are lit as by litBallOverlay(), and cast shadows.
};

/// Counts and times are those of this part, and of the frames that were not there before.
struct WalkReport {
    std::size_t frames = 0;     ///< Frames of this part, of all cameras.
    std::size_t reused = 0;     ///< Frames of this part that were there before.
    bool isComplete = false;    ///< Whether the frames of all parts are there.
    std::size_t photosUsed = 0; ///< Number of different photos.
    double medianRenderMs = 0;
    double medianDecodeMs = 0; ///< Over the frames that waited for a photo; 0 if none did.
    render::StreamCounters stream;
    render::LoadCounters load;
    double worstOffsetM = 0;
    double leastTrust = 1;
    std::size_t outside = 0; ///< Frames of this part from outside of what was scanned.
};

/// Renders a view at each pose and writes 000000.png, 000001.png, ... into the folder, which is made if need
/// be. Frames of the same walk that are there are kept: a walk that was stopped goes on, and several
/// processes may render parts at once.
///
/// The last part also writes index.csv (a line for each frame), times.csv, contact-sheet.png, the bags, and
/// the pose files, for which the room is the world. Files of these names are replaced. With LatePolicy::Wait
/// all files but times.csv are the same in every run, whatever the parts.
///
/// With WalkOptions::writesDepth, depth/000000.png, ... hold millimetres along the optical axis in 16 bits, 0
/// for none (REP 118), and a bag has them as /camera/depth/image_raw. With a sensor, index.csv has the
/// columns exposure_time_s and gain_db. The path between the poses is straight, and turns evenly; see
/// poseAt().
///
/// With WalkOptions::writesLabels, labels/000000.png, ... hold in 16 bits which object each pixel shows: 1
/// for the first ball, the numbers after those of balls for meshes, 0 for the room. annotations.json has
/// masks, boxes and visible shares as COCO has them, see dataset::cocoJson(). With a sensor, labels are those
/// of the view at the frame's time, without the sensor's blur. A bag has them as /camera/labels/image_raw.
///
/// A bag holds the picture and /camera/camera_info in the frame camera_optical, and the true pose of
/// camera_optical in the frame map, which is the room: /camera/pose (geometry_msgs/PoseStamped) and /tf. The
/// four messages of a frame have its time.
///
/// Frames: the poses are those of the optical frame.
/// Errors: those of rendering and writing; InvalidInput before anything is rendered, if a bag is wanted and
/// ROS cannot hold a pose's time, labels are wanted without an object, or a sensor is given and the path's
/// times do not ascend. InvalidInput for depth and labels, where the scene model knows no depth. Stop:
/// Stopped, with the frames so far kept.
WalkReport walk(const render::Renderer& renderer, const CameraModel& camera,
                const std::vector<TimedPose>& path, const WalkOptions& options,
                const std::filesystem::path& folder, ProgressSink& progress, const std::stop_token& stop);

/// The same for cameras that a robot carries together, with the same times: each camera's files are in a
/// folder of its name, and the bags have the topics of all, /left/image_raw and so on, with equal stamps.
/// The frames of a time are rendered one after the other from the same photos in memory. The noise of a
/// sensor differs from camera to camera. Range: one camera or more, whose paths have the same times.
WalkReport walk(const render::Renderer& renderer, const std::vector<WalkCamera>& cameras,
                const WalkOptions& options, const std::filesystem::path& folder, ProgressSink& progress,
                const std::stop_token& stop);

/// The files of a camera's pictures, one of each kind a pose. Kinds that were not wanted are empty.
struct WalkPictures {
    std::vector<std::filesystem::path> frames;
    std::vector<std::filesystem::path> depths;
    std::vector<std::filesystem::path> labels;
};

/// Writes frames and poses as a bag; walk() says what is in it. Errors: those of reading the pictures and of
/// writing; InvalidInput for a time that ROS cannot hold.
void writeWalkBag(dataset::BagFormat format, BagPictures pictures, const std::vector<WalkCamera>& cameras,
                  const std::vector<WalkPictures>& files, const std::filesystem::path& file);

Json toJson(const render::ViewReport& report);
Json toJson(const render::LoadCounters& counters);
Json toJson(const WalkReport& report);

} // namespace spherewalk::jobs
