// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/walk_bag.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/file.h"
#include "spherewalk/photo/picture_file.h"

namespace spherewalk::jobs {

namespace {

constexpr EnumNames<BagPictures, 2> kPictures{{{BagPictures::Raw, "raw"}, {BagPictures::Png, "png"}}};
constexpr const char* kRoomFrame = "map"; // REP 105
constexpr const char* kCameraFrame = "camera_optical";

} // namespace

BagPictures bagPictures(std::string_view name) {
    return valueOf(kPictures, "The kind of a bag's pictures", name);
}

void requireRosTimes(const std::vector<TimedPose>& path) {
    for (const TimedPose& pose : path) {
        dataset::rosStampNs(pose.timeS);
    }
}

void writeWalkBag(dataset::BagFormat format, BagPictures pictures, const CameraIntrinsics& camera,
                  const std::vector<TimedPose>& path, const std::vector<std::filesystem::path>& frames,
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
    for (std::size_t i = 0; i < path.size(); ++i) {
        const std::int64_t stampNs = dataset::rosStampNs(path[i].timeS);
        const dataset::RosHeader inCamera{static_cast<std::uint32_t>(i), stampNs, kCameraFrame};
        const dataset::RosHeader inRoom{static_cast<std::uint32_t>(i), stampNs, kRoomFrame};
        const Rigid3& roomFromCamera = path[i].roomFromCamera;
        bag->write(tf, stampNs, tfMessage(ros, inRoom, kCameraFrame, roomFromCamera));
        bag->write(pose, stampNs, poseMessage(ros, inRoom, roomFromCamera));
        bag->write(cameraInfo, stampNs, cameraInfoMessage(ros, inCamera, calibrated));
        bag->write(picture, stampNs,
                   isRaw ? imageMessage(ros, inCamera, photo::readPicture(frames[i]))
                         : pngMessage(ros, inCamera, readFile(frames[i])));
    }
    bag->finish();
}

} // namespace spherewalk::jobs
