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
             "launch.conditions": ["IfCondition"], "launch.substitutions": ["LaunchConfiguration", "PythonExpression"],
             "launch_ros": [], "launch_ros.actions": ["LoadComposableNodes", "Node"],
             "launch_ros.descriptions": ["ComposableNode"], "launch_ros.parameter_descriptions": ["ParameterValue"]}
    for name, classes in names.items():
        module = types.ModuleType(name)
        for one in classes:
            setattr(module, one, type(one, (Recorded,), {}))
        sys.modules[name] = module
    return runpy.run_path(str(PACKAGE / "launch/camera.launch.py"))["generate_launch_description"]().given[0]


def all_sources():
    return "".join(file.read_text() for file in sorted(PACKAGE.glob("*.[ch]*")))


def parameters_of_the_program():
    return set(re.findall(r'visit\(\s*"(\w+)"', (ROOT / "app/ros/camera/node_parameters.h").read_text()))


class Package(unittest.TestCase):
    def test_is_one_that_colcon_takes(self):
        package = xml.etree.ElementTree.parse(PACKAGE / "package.xml").getroot()
        self.assertEqual(package.get("format"), "3")
        self.assertEqual(package.findtext("name"), "spherewalk")
        self.assertEqual(package.findtext("version"), VERSION)
        self.assertEqual(package.findtext("export/build_type"), "ament_cmake")
        self.assertRegex(package.find("maintainer").get("email"), r"^[\w.-]+@[\w-]+(\.[\w-]+)*\.[a-z]{2,}$")

    def test_asks_rosdep_for_what_it_knows(self):
        package = xml.etree.ElementTree.parse(PACKAGE / "package.xml").getroot()
        keys = {"eigen", "libjpeg", "libssl-dev", "nlohmann-json-dev", "yaml-cpp"}  # Highway has none
        self.assertEqual({one.text for one in package.findall("build_depend")}, keys)

    def test_depends_on_all_that_it_includes(self):
        package = xml.etree.ElementTree.parse(PACKAGE / "package.xml").getroot()
        known = {one.text for one in package.findall("depend")}
        included = set(re.findall(r"#include <(\w+)/", all_sources()))
        # What rclcpp brings itself.
        self.assertEqual(included - {"builtin_interfaces", "rcl_interfaces"}, known)
        adapters = (ROOT / "packaging/cmake/SpherewalkAdapters.cmake").read_text()
        found = set(re.search(r"foreach\(package ([\w ]+)\)", adapters).group(1).split()) | {"rclcpp"}
        self.assertEqual(found, known)

    def test_launches_the_program_or_its_component_with_parameters_that_it_has(self):
        *declared, process, load = launch_description()
        component = load.named["composable_node_descriptions"][0]
        self.assertEqual((process.named["package"], process.named["executable"]), ("spherewalk", "spherewalk-ros2"))
        self.assertEqual(component.named["package"], "spherewalk")
        declared = {one.given[0]: one.named for one in declared}
        self.assertIsNone(declared["dataset"]["default_value"])
        self.assertTrue(all(one["description"] for one in declared.values()))
        self.assertEqual(declared["container"]["default_value"], "")
        conditions = ["".join(piece if isinstance(piece, str) else "" for piece in one.named["condition"].given[0].given[0])
                      for one in (process, load)]
        self.assertEqual(conditions, ["'' == ''", "'' != ''"])  # where no container is named
        for node in (process, component):
            parameters = set(node.named["parameters"][0])
            self.assertLessEqual(parameters - {"use_sim_time"}, parameters_of_the_program())
            for topic, argument in node.named["remappings"]:
                self.assertEqual(declared[argument.given[0]]["default_value"], topic)

    def test_remaps_the_topics_that_the_program_takes(self):
        source = (ROOT / "app/ros/camera/camera_node.cpp").read_text()
        taken = set(re.findall(r'return "(overlay/\w+)"', source))
        self.assertEqual({topic for topic, _ in launch_description()[-2].named["remappings"]}, taken)

    def test_has_a_component_of_the_name_that_containers_are_told(self):
        registered = re.search(r"RCLCPP_COMPONENTS_REGISTER_NODE\(([\w:]+)\)", all_sources()).group(1)
        cmake = (PACKAGE / "CMakeLists.txt").read_text()
        self.assertEqual(re.search(r'CONTENT "([\w:]+);lib/', cmake).group(1), registered)
        component = launch_description()[-1].named["composable_node_descriptions"][0]
        self.assertEqual(component.named["plugin"], registered)
        guide = (ROOT / "resources/docs/guide/ros.md").read_text()
        self.assertTrue(f"spherewalk {registered}" in guide, "The guide loads another component.")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
