# SPDX-License-Identifier: GPL-3.0-or-later
# What the cameras for Gazebo and ROS are built with, each where it is found.
find_package(CLI11 2.1 QUIET)
add_feature_info(programs CLI11_FOUND "the command lines of the cameras for Gazebo and DDS (app/program)")
if(SPHEREWALK_GAZEBO AND CLI11_FOUND)
  include(SpherewalkGazebo)
endif()
add_feature_info(gazebo SPHEREWALK_WITH_GAZEBO "a camera beside Gazebo (app/gazebo)")
set(SPHEREWALK_WITH_GAZEBO_SYSTEM OFF)
if(TARGET spherewalk_gz_sim)
  set(SPHEREWALK_WITH_GAZEBO_SYSTEM ON)
endif()
add_feature_info(gazebo-system SPHEREWALK_WITH_GAZEBO_SYSTEM "a camera inside of Gazebo (app/gazebo)")

find_package(PkgConfig QUIET)
if(SPHEREWALK_ROS1 AND PKG_CONFIG_FOUND)
  # image_transport, which is linked by its name, has a .pc file that asks for one that Debian does not have.
  pkg_check_modules(spherewalk_ros1 roscpp diagnostic_msgs geometry_msgs sensor_msgs tf2_msgs)
  find_library(image_transport_LIBRARY image_transport)
endif()
if(NOT SPHEREWALK_ROS1 OR NOT image_transport_LIBRARY)
  set(spherewalk_ros1_FOUND FALSE) # which may be TRUE from a configuration before
endif()
add_feature_info(ros1 spherewalk_ros1_FOUND "the camera of ROS 1 (app/ros/ros1)")

if(SPHEREWALK_DDS AND CLI11_FOUND)
  find_package(CycloneDDS 0.10 QUIET)
endif()
add_feature_info(dds CycloneDDS_FOUND "the camera of ROS 2 that needs no ROS (app/ros/dds)")
if(SPHEREWALK_RCLCPP)
  find_package(rclcpp QUIET)
  if(rclcpp_FOUND) # Debian has packages of ROS 1 by the names of these
    foreach(package rclcpp_components diagnostic_msgs geometry_msgs sensor_msgs tf2_msgs vision_msgs image_transport)
      find_package(${package} QUIET)
    endforeach()
  endif()
endif()
add_feature_info(ros2 rclcpp_FOUND "the camera of ROS 2 (app/ros/rclcpp)")
