// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters that nodes of ROS 1 and ROS 2 have. C++17, as camera_node.h.
#pragma once

#include "camera_node.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace spherewalk::ros {

/// The value of a parameter as a person gave it; std::monostate for a kind that no parameter of ours has.
using GivenValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::int64_t>>;

// Each function sets a parameter's value. A whole number is taken for a number with a fraction. name: of the
// parameter, for sentences. Errors: InvalidInput, naming the parameter, for a value of another kind, and for
// whole numbers that are too large.

void assign(const std::string& name, const GivenValue& given, std::string& value);
void assign(const std::string& name, const GivenValue& given, double& value);
void assign(const std::string& name, const GivenValue& given, int& value);
void assign(const std::string& name, const GivenValue& given, std::vector<int>& value);

/// Calls visit(name, description, value) for each parameter; value is the member that holds it.
template <class Visit>
void visitParameters(NodeOptions& options, const Visit& visit) {
    visit("dataset", "Folder of the dataset", options.dataset);
    visit("camera_info_url",
          "Camera-info YAML of the robot's camera: a path, or file:// or package:// as camera_info_manager "
          "reads them",
          options.cameraInfoUrl);
    visit("rig", "YAML of a rig of cameras, in place of camera_info_url", options.rig);
    visit("room_frame", "Frame of the dataset's room", options.roomFrame);
    visit("camera_frame", "Optical frame of the camera: z forward, x right, y down; of a rig, its own frame",
          options.cameraFrame);
    visit("rate", "Frames a second of the transforms' time; 0: one for each pose", options.rate);
    visit("scene", "none, sphere, room, depth, blend, or auto", options.scene);
    visit("sampling", "nearest, bilinear, reduced, footprint, bicubic, best, or auto", options.sampling);
    visit("late", "What shows a photo that is not decoded yet: wait, coarse, or previous", options.late);
    visit("pace", "Frames whose turn has passed: newest leaves them out, every renders all", options.pace);
    visit("overlay", "How a simulator's objects are told from its room: labels, depth, or alone; or none",
          options.overlay);
    visit("room_labels", "With labels: those of the room, which show the photo", options.roomLabels);
    visit("overlay_wait", "Seconds that a frame waits for its overlay", options.overlayWait);
    visit("threads", "Threads to render with; 0: all", options.threads);
    visit("cache_mb", "Megabytes of decoded photos", options.cacheMb);
    visit("sensor", "YAML of a sensor that is not perfect: noise, exposure, shutter; empty: none",
          options.sensor);
    visit("depth", "Depth images beside the pictures: 32FC1 (metres), 16UC1 (millimetres), or none",
          options.depth);
}

} // namespace spherewalk::ros
