# SPDX-License-Identifier: GPL-3.0-or-later
"""A robot's camera in a scanned room.

    ros2 launch spherewalk camera.launch.py dataset:=$PWD/kitchen.dataset camera_info:=$PWD/robot.yaml
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import LoadComposableNodes, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.parameter_descriptions import ParameterValue

# Argument, parameter, type, default (None: must be given), description.
ARGUMENTS = (
    ("dataset", "dataset", str, None, "Folder of the dataset"),
    ("camera_info", "camera_info_url", str, "", "Camera-info YAML of the robot's camera: path, file:// or package://"),
    ("rig", "rig", str, "", "YAML of a rig of cameras, in place of camera_info"),
    ("room_frame", "room_frame", str, "map", "Frame of the dataset's room"),
    ("camera_frame", "camera_frame", str, "camera_optical", "Optical frame of the camera"),
    ("rate", "rate", float, "30", "Frames a second; 0: one for each transform"),
    ("overlay", "overlay", str, "none", "none, labels, depth or alone"),
    ("sensor", "sensor", str, "", "YAML of a sensor that is not perfect"),
    ("depth", "depth", str, "none", "Depth images: none, 32FC1 or 16UC1"),
    ("use_sim_time", "use_sim_time", bool, "false", "Time is what /clock says"),
)

# Argument, topic that is its default, description.
TOPICS = (
    ("overlay_image", "overlay/image_raw", "Topic of the simulator's pictures, for one camera"),
    ("overlay_depth", "overlay/depth", "Topic of the simulator's depth images, for one camera"),
    ("overlay_labels", "overlay/labels", "Topic of the simulator's labels, for one camera"),
)


def generate_launch_description():
    declared = [DeclareLaunchArgument("ns", default_value="", description="Name space of the camera's topics"),
                DeclareLaunchArgument("container", default_value="", description="Name of the running component "
                                      "container that loads the node; empty: a process of its own")]
    parameters = {}
    for argument, parameter, kind, default, description in ARGUMENTS:
        declared.append(DeclareLaunchArgument(argument, default_value=default, description=description))
        parameters[parameter] = ParameterValue(LaunchConfiguration(argument), value_type=kind)
    remappings = []
    for argument, topic, description in TOPICS:
        declared.append(DeclareLaunchArgument(argument, default_value=topic, description=description))
        remappings.append((topic, LaunchConfiguration(argument)))
    container = LaunchConfiguration("container")
    common = {"package": "spherewalk", "name": "spherewalk", "namespace": LaunchConfiguration("ns"),
              "parameters": [parameters], "remappings": remappings}
    process = Node(executable="spherewalk-ros2", output="screen",
                   condition=IfCondition(PythonExpression(["'", container, "' == ''"])), **common)
    component = ComposableNode(plugin="spherewalk::ros::Camera",
                               extra_arguments=[{"use_intra_process_comms": True}], **common)
    load = LoadComposableNodes(target_container=container, composable_node_descriptions=[component],
                               condition=IfCondition(PythonExpression(["'", container, "' != ''"])))
    return LaunchDescription([*declared, process, load])
