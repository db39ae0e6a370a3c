# SPDX-License-Identifier: GPL-3.0-or-later
"""The package of ROS 2, without ROS 2: what it says agrees with the program and with CMake.

    package_test.py PROJECT_SOURCE_DIR VERSION
"""
import pathlib
import re
import runpy
import sys
import types
import unittest
import xml.etree.ElementTree

ROOT, VERSION = pathlib.Path(sys.argv[1]), sys.argv[2]
PACKAGE = ROOT / "app/ros/rclcpp"


class Recorded:
    """Stands for any class of ROS's launch: keeps what it was made with."""

    def __init__(self, *given, **named):
        self.given, self.named = given, named


def launch_description():
    names = {"launch": ["LaunchDescription"], "launch.actions": ["DeclareLaunchArgument"],
             "launch.substitutions": ["LaunchConfiguration"], "launch_ros": [], "launch_ros.actions": ["Node"],
             "launch_ros.parameter_descriptions": ["ParameterValue"]}
    for name, classes in names.items():
        module = types.ModuleType(name)
        for one in classes:
            setattr(module, one, type(one, (Recorded,), {}))
        sys.modules[name] = module
    return runpy.run_path(str(PACKAGE / "launch/camera.launch.py"))["generate_launch_description"]().given[0]


def parameters_of_the_program():
    return set(re.findall(r'visit\("(\w+)"', (ROOT / "app/ros/camera/node_parameters.h").read_text()))


class Package(unittest.TestCase):
    def test_is_one_that_colcon_takes(self):
        package = xml.etree.ElementTree.parse(PACKAGE / "package.xml").getroot()
        self.assertEqual(package.get("format"), "3")
        self.assertEqual(package.findtext("name"), "spherewalk")
        self.assertEqual(package.findtext("version"), VERSION)
        self.assertEqual(package.findtext("export/build_type"), "ament_cmake")
        self.assertRegex(package.find("maintainer").get("email"), r"^[\w.-]+@[\w-]+(\.[\w-]+)*\.[a-z]{2,}$")

    def test_depends_on_all_that_it_includes(self):
        package = xml.etree.ElementTree.parse(PACKAGE / "package.xml").getroot()
        known = {one.text for one in package.findall("depend")}
        included = set(re.findall(r"#include <(\w+)/(?:msg|srv)/", (PACKAGE / "main.cpp").read_text()))
        # What rclcpp brings itself.
        self.assertEqual(included - {"builtin_interfaces", "rcl_interfaces"}, known - {"rclcpp"})

    def test_launches_the_program_with_parameters_that_it_has(self):
        description = launch_description()
        node = description[-1]
        self.assertEqual((node.named["package"], node.named["executable"]), ("spherewalk", "spherewalk-ros2"))
        parameters = set(node.named["parameters"][0])
        self.assertLessEqual(parameters - {"use_sim_time"}, parameters_of_the_program())
        declared = {one.given[0]: one.named for one in description[:-1]}
        self.assertIsNone(declared["dataset"]["default_value"])
        self.assertTrue(all(one["description"] for one in declared.values()))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
