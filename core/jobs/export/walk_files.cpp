// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/ros_messages.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/photo/picture_file.h"

#include <memory>
#include <optional>
#include <string>

namespace spherewalk::jobs {

namespace {

constexpr EnumNames<BagPictures, 2> kBagPictures{{{BagPictures::Raw, "raw"}, {BagPictures::Png, "png"}}};
constexpr const char* kRoomFrame = "map"; // REP 105

} // namespace

BagPictures bagPictures(std::string_view name) {
    return valueOf(kBagPictures, "The kind of a bag's pictures", name);
}

std::vector<WalkCamera> walkCameras(const std::vector<render::RigCamera>& rig,
                                    const std::vector<TimedPose>& roomFromRig, std::string_view what) {
    const std::vector<Rigid3> places = render::placesOnRig(rig, what);
    std::vector<WalkCamera> cameras;
    for (std::size_t i = 0; i < rig.size(); ++i) {
        cameras.push_back({rig[i].name, rig[i].frameId, rig[i].camera, roomFromRig});
        for (TimedPose& pose : cameras.back().path) {
            pose.roomFromCamera = pose.roomFromCamera * places[i];
        }
    }
    return cameras;
}

WalkReport walk(const render::Renderer& renderer, const CameraModel& camera,
                const std::vector<TimedPose>& path, const WalkOptions& options,
                const std::filesystem::path& folder, ProgressSink& progress, const std::stop_token& stop) {
    WalkCamera only;
    only.intrinsics = camera.intrinsics();
    only.path = path;
    return walk(renderer, std::vector{only}, options, folder, progress, stop);
}

namespace {

/// Writes the messages of one camera.
class CameraTopics {
  public:
    /// Owner: the camera and the files must outlive the topics.
    CameraTopics(dataset::Bag& bag, dataset::Ros ros, BagPictures pictures, const WalkCamera& camera,
                 const WalkPictures& files, double baselineM)
        : m_bag(bag),
          m_ros(ros),
          m_isRaw(pictures == BagPictures::Raw),
          m_camera(camera),
          m_files(files),
          m_calibration(render::stereoCalibration(camera.intrinsics, baselineM)) {
        using dataset::RosType;
        const std::string prefix = text("/", camera.name.empty() ? "camera" : camera.name);
        m_picture = m_isRaw ? bag.addTopic(prefix + "/image_raw", RosType::Image)
                            : bag.addTopic(prefix + "/image_raw/compressed", RosType::CompressedImage);
        m_info = bag.addTopic(prefix + "/camera_info", RosType::CameraInfo);
        m_pose = bag.addTopic(prefix + "/pose", RosType::PoseStamped);
        if (!files.depths.empty()) {
            m_depth = bag.addTopic(prefix + "/depth/image_raw", RosType::Image);
            m_depthInfo = bag.addTopic(prefix + "/depth/camera_info", RosType::CameraInfo);
        }
        if (!files.labels.empty()) {
            m_labels = bag.addTopic(prefix + "/labels/image_raw", RosType::Image);
        }
    }

    /// tf: the topic of transforms.
    void write(std::size_t i, std::size_t tf) {
        const TimedPose& pose = m_camera.path[i];
        const std::int64_t stampNs = dataset::rosStampNs(pose.timeS);
        const dataset::RosHeader inCamera{static_cast<std::uint32_t>(i), stampNs, m_camera.frameId};
        const dataset::RosHeader inRoom{static_cast<std::uint32_t>(i), stampNs, kRoomFrame};
        m_bag.write(tf, stampNs, tfMessage(m_ros, inRoom, m_camera.frameId, pose.roomFromCamera));
        m_bag.write(m_pose, stampNs, poseMessage(m_ros, inRoom, pose.roomFromCamera));
        m_bag.write(m_info, stampNs, cameraInfoMessage(m_ros, inCamera, m_calibration));
        m_bag.write(m_picture, stampNs,
                    m_isRaw ? imageMessage(m_ros, inCamera, photo::readPicture(m_files.frames[i]))
                            : pngMessage(m_ros, inCamera, readFile(m_files.frames[i])));
        if (m_depth) {
            m_bag.write(*m_depthInfo, stampNs, cameraInfoMessage(m_ros, inCamera, m_calibration));
            m_bag.write(*m_depth, stampNs,
                        imageMessage(m_ros, inCamera, photo::readPng16(m_files.depths[i])));
        }
        if (m_labels) {
            m_bag.write(*m_labels, stampNs,
                        imageMessage(m_ros, inCamera, photo::readPng16(m_files.labels[i])));
        }
    }

  private:
    dataset::Bag& m_bag;
    dataset::Ros m_ros;
    bool m_isRaw;
    const WalkCamera& m_camera;
    const WalkPictures& m_files;
    Calibration m_calibration;
    std::size_t m_picture = 0;
    std::size_t m_info = 0;
    std::size_t m_pose = 0;
    std::optional<std::size_t> m_depth; ///< of kinds that are wanted
    std::optional<std::size_t> m_depthInfo;
    std::optional<std::size_t> m_labels;
};

} // namespace

void writeWalkBag(dataset::BagFormat format, BagPictures pictures, const std::vector<WalkCamera>& cameras,
                  const std::vector<WalkPictures>& files, const std::filesystem::path& file) {
    const std::unique_ptr<dataset::Bag> bag = makeBag(format, file);
    const std::size_t tf = bag->addTopic("/tf", dataset::RosType::TfMessage);
    const WalkCamera& first = cameras.front();
    std::vector<CameraTopics> topics;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const Rigid3 firstFromThis =
            first.path.front().roomFromCamera.inverse() * cameras[i].path.front().roomFromCamera;
        topics.emplace_back(*bag, messagesOf(format), pictures, cameras[i], files[i],
                            render::stereoBaselineM(first.intrinsics, cameras[i].intrinsics, firstFromThis));
    }
    for (std::size_t frame = 0; frame < first.path.size(); ++frame) {
        for (CameraTopics& camera : topics) {
            camera.write(frame, tf);
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
