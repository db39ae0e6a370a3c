# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a bag with one picture by ROS's own library: write_rosbag.py FILE.

The picture's definition has no comments. It is the same definition with the same checksum, but not the same text.
"""

import sys

import rosbag
import rospy
from sensor_msgs.msg import Image

lines = (line.split("#")[0].rstrip() for line in Image._full_text.splitlines())
Image._full_text = "\n".join(line for line in lines if line) + "\n"
with rosbag.Bag(sys.argv[1], "w") as bag:
    bag.write("/picture", Image(height=1, width=1, encoding="rgb8", step=3, data=bytes(3)), rospy.Time(1))
