// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/dataset/ros_messages.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/photo/picture_file.h"

#include <memory>

namespace spherewalk::jobs {

namespace {

constexpr EnumNames<BagPictures, 2> kBagPictures{{{BagPictures::Raw, "raw"}, {BagPictures::Png, "png"}}};
constexpr const char* kRoomFrame = "map"; // REP 105
constexpr const char* kCameraFrame = "camera_optical";

} // namespace

BagPictures bagPictures(std::string_view name) {
    return valueOf(kBagPictures, "The kind of a bag's pictures", name);
}

void writeWalkBag(dataset::BagFormat format, BagPictures pictures, const CameraIntrinsics& camera,
                  const std::vector<TimedPose>& path, const WalkPictures& files,
                  const std::filesystem::path& file) {
    using dataset::RosType;
    const dataset::Ros ros = messagesOf(format);
    const bool isRaw = pictures == BagPictures::Raw;
    const Calibration calibrated = calibration(camera);
    const std::unique_ptr<dataset::Bag> bag = makeBag(format, file);
    const std::size_t picture = isRaw
                                    ? bag->addTopic("/camera/image_raw", RosType::Image)
                                    : bag->addTopic("/camera/image_raw/compressed", RosType::CompressedImage);
    const std::size_t cameraInfo = bag->addTopic("/camera/camera_info", RosType::CameraInfo);
    const std::size_t pose = bag->addTopic("/camera/pose", RosType::PoseStamped);
    const std::size_t tf = bag->addTopic("/tf", RosType::TfMessage);
    const bool hasDepth = !files.depths.empty();
    const std::size_t depth = hasDepth ? bag->addTopic("/camera/depth/image_raw", RosType::Image) : 0;
    const std::size_t depthInfo =
        hasDepth ? bag->addTopic("/camera/depth/camera_info", RosType::CameraInfo) : 0;
    const bool hasLabels = !files.labels.empty();
    const std::size_t label = hasLabels ? bag->addTopic("/camera/labels/image_raw", RosType::Image) : 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const std::int64_t stampNs = dataset::rosStampNs(path[i].timeS);
        const dataset::RosHeader inCamera{static_cast<std::uint32_t>(i), stampNs, kCameraFrame};
        const dataset::RosHeader inRoom{static_cast<std::uint32_t>(i), stampNs, kRoomFrame};
        const Rigid3& roomFromCamera = path[i].roomFromCamera;
        bag->write(tf, stampNs, tfMessage(ros, inRoom, kCameraFrame, roomFromCamera));
        bag->write(pose, stampNs, poseMessage(ros, inRoom, roomFromCamera));
        bag->write(cameraInfo, stampNs, cameraInfoMessage(ros, inCamera, calibrated));
        bag->write(picture, stampNs,
                   isRaw ? imageMessage(ros, inCamera, photo::readPicture(files.frames[i]))
                         : pngMessage(ros, inCamera, readFile(files.frames[i])));
        if (hasDepth) {
            bag->write(depthInfo, stampNs, cameraInfoMessage(ros, inCamera, calibrated));
            bag->write(depth, stampNs, imageMessage(ros, inCamera, photo::readPng16(files.depths[i])));
        }
        if (hasLabels) {
            bag->write(label, stampNs, imageMessage(ros, inCamera, photo::readPng16(files.labels[i])));
        }
    }
    bag->finish();
}

Json toJson(const render::ViewReport& report) {
    return {{"photo", report.file},
            {"offset_m", report.offsetM},
            {"scene", name(report.scene)},
            {"sampling", name(report.sampling)},
            {"origin", name(report.origin)},
            {"late", report.isLate},
            {"trust", report.trust},
            {"outside", report.isOutside},
            {"sees_place", report.seesPlace},
            {"seen_share", report.seenShare},
            {"filled_share", report.filledShare},
            {"parallax_px", report.parallaxPx},
            {"blur_px", report.blurPx},
            {"decode_ms", report.decodeMs},
            {"decoded_tiles", report.decodedTiles},
            {"whole_decode", report.isWholeDecode},
            {"verified", report.isVerified},
            {"render_ms", report.renderMs}};
}

Json toJson(const render::LoadCounters& counters) {
    return {{"hits", counters.hits},
            {"late", counters.late},
            {"waits", counters.waits},
            {"decoded_tiles", counters.decodedTiles},
            {"prefetched_tiles", counters.prefetchedTiles},
            {"dropped_tiles", counters.droppedTiles},
            {"whole_decodes", counters.wholeDecodes},
            {"prefetch_errors", counters.prefetchErrors},
            {"decode_ms", counters.decodeMs},
            {"prefetch_ms", counters.prefetchMs},
            {"resident_bytes", counters.residentBytes}};
}

Json toJson(const WalkReport& report) {
    return {{"frames", report.frames},
            {"reused_frames", report.reused},
            {"complete", report.isComplete},
            {"photos_used", report.photosUsed},
            {"median_render_ms", report.medianRenderMs},
            {"median_decode_ms", report.medianDecodeMs},
            {"worst_offset_m", report.worstOffsetM},
            {"least_trust", report.leastTrust},
            {"outside", report.outside},
            {"late", report.stream.late},
            {"waited", report.stream.waited},
            {"coarse", report.stream.coarse},
            {"previous", report.stream.previous},
            {"load", toJson(report.load)}};
}

} // namespace spherewalk::jobs
