// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros1_node.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::ros {

namespace {

/// Leaves the value as it is where there is no such parameter.
template <class Value>
void read(const ::ros::NodeHandle& handle, const std::string& name, Value& value) {
    if (handle.hasParam(name) && !handle.getParam(name, value)) {
        throw Error(ErrorKind::InvalidInput, text("The parameter ", handle.resolveName(name),
                                                  " is of another type than it should be."));
    }
}

} // namespace

NodeOptions readParameters(const ::ros::NodeHandle& handle) {
    NodeOptions options;
    read(handle, "dataset", options.dataset);
    read(handle, "camera_info_url", options.cameraInfoUrl);
    read(handle, "room_frame", options.roomFrame);
    read(handle, "camera_frame", options.cameraFrame);
    read(handle, "rate", options.rate);
    read(handle, "scene", options.scene);
    read(handle, "sampling", options.sampling);
    read(handle, "late", options.late);
    read(handle, "pace", options.pace);
    read(handle, "overlay", options.overlay);
    read(handle, "room_labels", options.roomLabels);
    read(handle, "overlay_wait", options.overlayWait);
    read(handle, "threads", options.threads);
    read(handle, "cache_mb", options.cacheMb);
    return options;
}

} // namespace spherewalk::ros
