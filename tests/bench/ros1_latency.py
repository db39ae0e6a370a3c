#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures spherewalk-ros1: how long from a transform to the picture that shows it, and whether the rate is held.

    tests/bench/ros1_latency.py NODE DATASET CAMERA.yaml [--seconds 30] [--rate 30] [--overlay] [--speed 1]
                                [--from X,Y,Z] [--length M]

The camera moves to and fro along the room's x axis at --speed, its transform is sent 100 times a second, and with
--overlay pictures of objects (colour, and depth as 32FC1) are sent with the stamp of a transform, --rate times a second.
Times are taken in this process: when a transform is sent, and when the picture with its stamp has arrived. Prints a line
of a table: frames, rate, latency (median, 99th percentile, worst) in ms.
"""
import argparse
import math
import os
import socket
import subprocess
import tempfile
import threading
import time

options = argparse.ArgumentParser(description="Measures spherewalk-ros1.")
options.add_argument("node")
options.add_argument("dataset")
options.add_argument("camera")
options.add_argument("--seconds", type=float, default=30)
options.add_argument("--rate", type=int, default=30)
options.add_argument("--overlay", action="store_true")
options.add_argument("--speed", type=float, default=1)
options.add_argument("--from", dest="start", default="1.2,2,1.2")
options.add_argument("--length", type=float, default=2)
given = options.parse_args()

with socket.socket() as free:
    free.bind(("127.0.0.1", 0))
    port = free.getsockname()[1]
scratch = tempfile.TemporaryDirectory(prefix="spherewalk-bench-")
os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_HOSTNAME="127.0.0.1", HOME=scratch.name,
                  ROS_HOME=scratch.name)

import rosgraph  # noqa: E402, as they look at the environment
import rospy  # noqa: E402
from geometry_msgs.msg import TransformStamped  # noqa: E402
from sensor_msgs.msg import Image  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402

TRANSFORMS_HZ = 100
sent, latencies, arrivals, sizes = {}, [], [], set()


def arrived(image):
    now = time.monotonic()
    stamp = image.header.stamp.to_nsec()
    if stamp in sent:
        latencies.append(1000 * (now - sent[stamp]))
        arrivals.append(now)
        sizes.add((image.width, image.height))


def place_at(seconds):
    x, y, z = map(float, given.start.split(","))
    along = given.speed * seconds % (2 * given.length)
    return x + min(along, 2 * given.length - along), y, z


def objects(width, height):
    """Colour and depth of a disc 0.8 m away."""
    colour, depth = bytearray(3 * width * height), bytearray(4 * width * height)
    near = memoryview(depth).cast("f")
    for v in range(height):
        for u in range(width):
            if math.hypot(u - width / 2, v - height / 2) < height / 5:
                colour[3 * (v * width + u)] = 255
                near[v * width + u] = 0.8
    return (Image(width=width, height=height, encoding="rgb8", step=3 * width, data=bytes(colour)),
            Image(width=width, height=height, encoding="32FC1", step=4 * width, data=bytes(depth)))


def run():
    tf = rospy.Publisher("/tf", TFMessage, queue_size=100, tcp_nodelay=True)
    publishers = [rospy.Publisher(topic, Image, queue_size=5, tcp_nodelay=True)
                  for topic in ("/overlay/image_raw", "/overlay/depth")]
    rospy.Subscriber("/camera/image_raw", Image, arrived, buff_size=2**24, tcp_nodelay=True)
    with open(given.camera) as file:
        numbers = {key: int(value) for key, _, value in (line.partition(":") for line in file) if key.startswith("image_")}
    pictures = objects(numbers["image_width"], numbers["image_height"]) if given.overlay else ()
    pending = threading.Semaphore(0)
    due = []

    def send_overlays():  # beside the transforms, as a simulator's camera is
        while True:
            pending.acquire()
            stamp = due.pop(0)
            if stamp is None:
                return
            for picture, publisher in zip(pictures, publishers):
                picture.header.stamp = stamp
                publisher.publish(picture)

    sender = threading.Thread(target=send_overlays)
    sender.start()
    while tf.get_num_connections() == 0:
        time.sleep(0.05)
    begin, tick, slot = time.monotonic(), 0, -1
    while tick < given.seconds * TRANSFORMS_HZ:
        time.sleep(max(0.0, begin + tick / TRANSFORMS_HZ - time.monotonic()))
        message = TransformStamped()
        stamp = message.header.stamp = rospy.Time.from_sec(1000 + tick / TRANSFORMS_HZ)
        message.header.frame_id, message.child_frame_id = "map", "camera_optical"
        t, r = message.transform.translation, message.transform.rotation
        t.x, t.y, t.z = place_at(tick / TRANSFORMS_HZ)
        r.x, r.y, r.z, r.w = -0.5, 0.5, -0.5, 0.5
        sent[stamp.to_nsec()] = time.monotonic()
        tf.publish([message])
        if tick * given.rate // TRANSFORMS_HZ > slot:
            slot = tick * given.rate // TRANSFORMS_HZ
            due.append(stamp)
            pending.release() if pictures else None
        tick += 1
    time.sleep(1)
    due[:] = [None]
    pending.release()
    sender.join()


programs = [subprocess.Popen(["/usr/bin/rosmaster", "--core", "-p", str(port)], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)]
try:
    while not rosgraph.is_master_online(os.environ["ROS_MASTER_URI"]):
        time.sleep(0.05)
    programs.append(subprocess.Popen([given.node, f"_dataset:={given.dataset}", f"_camera_info_url:={given.camera}",
                                      f"_rate:={given.rate}", f"_overlay:={'alone' if given.overlay else 'none'}"]))
    rospy.init_node("bench", disable_signals=True)
    run()
finally:
    rospy.signal_shutdown("done")
    for program in reversed(programs):
        program.terminate()
        program.wait()

steady = sorted(latencies[given.rate:])  # after the first second, in which photos are decoded
rate = (len(arrivals) - 1) / (arrivals[-1] - arrivals[0])
due = int(given.seconds * given.rate)
size = "x".join(map(str, sizes.pop()))
print("| picture | overlay | frames of those due | rate, Hz | median, ms | 99 %, ms | worst, ms |")
print(f"| {size} | {'yes' if given.overlay else 'no'} | {len(arrivals)} of {due} | {rate:.2f} | {steady[len(steady) // 2]:.1f} | "
      f"{steady[int(0.99 * len(steady))]:.1f} | {steady[-1]:.1f} |")
