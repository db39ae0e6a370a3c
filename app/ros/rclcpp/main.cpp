// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera as a node of ROS 2 with a process of its own; resources/docs/guide/ros.md says how it is
// used.
#include "rclcpp_camera.h"

#include <exception>
#include <rclcpp/rclcpp.hpp>

int main(int argc, char** argv) {
    int status = 0;
    try {
        rclcpp::init(argc, argv);
        rclcpp::spin(spherewalk::ros::makeCamera(rclcpp::NodeOptions()));
    } catch (const std::exception& error) { // ours with its sentence, or one of rclcpp's
        RCLCPP_FATAL(rclcpp::get_logger("spherewalk"), "%s", error.what());
        status = 1;
    }
    rclcpp::shutdown();
    return status;
}
