# SPDX-License-Identifier: GPL-3.0-or-later
"""A robot's camera in a scanned room.

    ros2 launch spherewalk camera.launch.py dataset:=$PWD/kitchen.dataset camera_info:=$PWD/robot.yaml
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

# Argument, parameter, type, default (None: must be given), description.
ARGUMENTS = (
    ("dataset", "dataset", str, None, "Folder of the dataset"),
    ("camera_info", "camera_info_url", str, "", "Camera-info YAML of the robot's camera"),
    ("rig", "rig", str, "", "YAML of a rig of cameras, in place of camera_info"),
    ("room_frame", "room_frame", str, "map", "Frame of the dataset's room"),
    ("camera_frame", "camera_frame", str, "camera_optical", "Optical frame of the camera"),
    ("rate", "rate", float, "30", "Frames a second; 0: one for each transform"),
    ("overlay", "overlay", str, "none", "none, labels, depth or alone"),
    ("sensor", "sensor", str, "", "YAML of a sensor that is not perfect"),
    ("depth", "depth", str, "none", "Depth images: none, 32FC1 or 16UC1"),
    ("use_sim_time", "use_sim_time", bool, "false", "Time is what /clock says"),
)


def generate_launch_description():
    declared = [DeclareLaunchArgument("ns", default_value="", description="Name space of the camera's topics")]
    parameters = {}
    for argument, parameter, kind, default, description in ARGUMENTS:
        declared.append(DeclareLaunchArgument(argument, default_value=default, description=description))
        parameters[parameter] = ParameterValue(LaunchConfiguration(argument), value_type=kind)
    node = Node(package="spherewalk", executable="spherewalk-ros2", name="spherewalk",
                namespace=LaunchConfiguration("ns"), output="screen", parameters=[parameters])
    return LaunchDescription([*declared, node])
