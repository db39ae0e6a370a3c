// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_options.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::ros {

namespace {

simulator::OverlayOptions overlayOptions(const NodeOptions& options) {
    simulator::OverlayOptions overlay;
    overlay.by = simulator::objectsBy(options.overlay);
    overlay.roomLabels.clear();
    for (const int label : options.roomLabels) {
        if (label < 0 || label > 255) {
            throw Error(ErrorKind::InvalidInput,
                        text("A label of the room is ", label, "; there are 0 to 255."));
        }
        overlay.roomLabels.push_back(static_cast<std::uint8_t>(label));
    }
    if (!(options.overlayWait >= 0 && options.overlayWait <= 10)) {
        throw Error(ErrorKind::InvalidInput, "A frame can wait 0 to 10 s for its overlay.");
    }
    overlay.wait = std::chrono::duration_cast<Stamp>(std::chrono::duration<double>(options.overlayWait));
    overlay.interpolatesPoses = true; // as tf does for the stamp of a picture
    return overlay;
}

constexpr EnumNames<DepthEncoding, 3> kDepthEncodings{
    {{DepthEncoding::None, "none"}, {DepthEncoding::Metres, "32FC1"}, {DepthEncoding::Millimetres, "16UC1"}}};

} // namespace

DepthEncoding depthEncoding(std::string_view name) {
    return valueOf(kDepthEncodings, "The encoding of depth images", name);
}

simulator::CameraOptions cameraOptions(const NodeOptions& options) {
    if (options.roomFrame.empty() || options.cameraFrame.empty() ||
        options.roomFrame == options.cameraFrame) {
        throw Error(ErrorKind::InvalidInput,
                    "The frames of the room and of the camera need names, and not the same one.");
    }
    if (options.threads < 0 || options.cacheMb < 1) {
        throw Error(ErrorKind::InvalidInput, "The number of threads is 0 or more, the cache 1 MB or more.");
    }
    simulator::CameraOptions camera;
    if (options.scene != "auto") {
        camera.view.scene = render::sceneKind(options.scene);
    }
    camera.view.sampling = render::sampling(options.sampling);
    camera.view.threads = options.threads;
    camera.stream.late = render::latePolicy(options.late);
    camera.mounting.axes = simulator::CameraAxes::Optical;
    camera.rateHz = options.rate;
    camera.pace = simulator::pace(options.pace);
    if (options.overlay != "none") {
        camera.overlay = overlayOptions(options);
        camera.wantsLabels = true;
    }
    camera.wantsDepth = depthEncoding(options.depth) != DepthEncoding::None;
    if (!options.sensor.empty()) {
        camera.sensor = render::readSensor(options.sensor);
    }
    camera.validate();
    return camera;
}

} // namespace spherewalk::ros
