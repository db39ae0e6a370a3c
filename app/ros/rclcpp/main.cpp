// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera as a node of ROS 2; resources/docs/guide/ros.md says how it is used.
#include "rclcpp_node.h"

#include "spherewalk/base/error.h"

int main(int argc, char** argv) {
    rclcpp::init(argc, argv);
    int status = 0;
    try {
        rclcpp::spin(std::make_shared<spherewalk::ros::RclcppNode>());
    } catch (const spherewalk::Error& error) {
        RCLCPP_FATAL(rclcpp::get_logger("spherewalk"), "%s", error.sentence().c_str());
        status = 1;
    }
    rclcpp::shutdown();
    return status;
}
