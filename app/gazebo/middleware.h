// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>

// Gazebo's transport and messages by one name: gz-transport and gz-msgs, or ignition-transport and
// ignition-msgs, as they were called up to Fortress.
#ifdef SPHEREWALK_IGNITION
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/param.pb.h>
#include <ignition/msgs/pose.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/transport/Node.hh>

namespace spherewalk::gazebo {
namespace msgs = ignition::msgs;
namespace transport = ignition::transport;
} // namespace spherewalk::gazebo
#else
#include <gz/msgs/camera_info.pb.h>
#include <gz/msgs/image.pb.h>
#include <gz/msgs/param.pb.h>
#include <gz/msgs/pose.pb.h>
#include <gz/msgs/pose_v.pb.h>
#include <gz/transport/Node.hh>

namespace spherewalk::gazebo {
namespace msgs = gz::msgs;
namespace transport = gz::transport;
} // namespace spherewalk::gazebo
#endif

namespace spherewalk::gazebo {

/// Ends a program that used the transport. Its thread of discovery is never joined, so static objects must
/// not be destroyed under it.
[[noreturn]] inline void endProgram(int status) {
    std::fflush(nullptr);
    std::_Exit(status);
}

} // namespace spherewalk::gazebo
