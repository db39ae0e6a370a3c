// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <rclcpp/node.hpp>
#include <rclcpp/node_options.hpp>

namespace spherewalk::ros {

/// The node, as containers load it by the name of spherewalk::ros::Camera. Errors: Error for parameters and
/// files that are of no use, and exceptions of rclcpp.
std::shared_ptr<rclcpp::Node> makeCamera(const rclcpp::NodeOptions& options);

} // namespace spherewalk::ros
