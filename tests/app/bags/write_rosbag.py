# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a bag with one picture by ROS's own library: write_rosbag.py FILE."""

import sys

import rosbag
import rospy
from sensor_msgs.msg import Image

picture = Image(height=1, width=1, encoding="rgb8", step=3, data=bytes(3))
with rosbag.Bag(sys.argv[1], "w") as bag:
    bag.write("/picture", picture, rospy.Time(1))
