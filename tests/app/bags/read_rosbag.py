# SPDX-License-Identifier: GPL-3.0-or-later
# Reads a bag with ROS's own library, by the definitions in the bag. Prints a JSON object a message.
# Usage: python3 read_rosbag.py FILE
import base64
import json
import sys

import genpy
import rosbag


def plain(value):
    if isinstance(value, genpy.Time):
        return {"sec": value.secs, "nsec": value.nsecs}
    if isinstance(value, genpy.Message):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    if isinstance(value, bytes):
        return base64.b64encode(value).decode()
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return value


with rosbag.Bag(sys.argv[1]) as bag:
    for topic, message, time in bag.read_messages():
        print(json.dumps({"topic": topic, "type": message._type, "time_ns": time.to_nsec(), "message": plain(message)}))
