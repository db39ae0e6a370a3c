# SPDX-License-Identifier: GPL-3.0-or-later
# The node of ROS 1 among ROS's own: a master, transforms, rostopic and rosbag.
# Usage: python3 ros1_test.py CASE, with what the node and its dataset are in the environment.
import math
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

NODE = os.environ["SPHEREWALK_ROS1"]
CLI = os.environ["SPHEREWALK_CLI"]
DATASET = os.environ["SPHEREWALK_DATASET"] + "/dataset"
CAMERA = os.environ["SPHEREWALK_DATASET"] + "/camera.yaml"
PATIENCE_S = 60  # for what comes at once on a machine that is not busy

with socket.socket() as free:
    free.bind(("127.0.0.1", 0))
    PORT = free.getsockname()[1]
SCRATCH = tempfile.TemporaryDirectory(prefix="spherewalk-ros1-")
os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{PORT}", ROS_HOSTNAME="127.0.0.1", HOME=SCRATCH.name,
                  ROS_HOME=SCRATCH.name)
os.environ.pop("ROS_IP", None)

import rosbag  # noqa: E402, as they look at the environment
import rosgraph  # noqa: E402
import rospy  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray  # noqa: E402
from geometry_msgs.msg import PoseStamped, TransformStamped  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from sensor_msgs.msg import CameraInfo, Image  # noqa: E402
from sensor_msgs.srv import SetCameraInfo  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402


def wait_for(what, condition):
    end = time.monotonic() + PATIENCE_S
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"waited too long for {what}")
        time.sleep(0.02)


def transform(parent, child, stamp_ns, place, turn):
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id = parent, child
    message.header.stamp = rospy.Time(stamp_ns // 10**9, stamp_ns % 10**9)
    t, r = message.transform.translation, message.transform.rotation
    (t.x, t.y, t.z), (r.x, r.y, r.z, r.w) = place, turn
    return message


def pose_at(stamp_ns):
    """Of the base in the room: along a curve, turning; all numbers are exact in a file of text. The camera
    stays nearest to the photo at (2.5, 1.5): at a border a stream keeps its photo for 2 cm, and a single view
    does not."""
    seconds = stamp_ns / 1e9
    yaw = 0.3 * seconds
    return (2.5 + 0.3 * math.sin(seconds), 1.5, 1.2), (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))


class Ros1(unittest.TestCase):
    def setUp(self):
        self.programs = []
        self.start(["/usr/bin/rosmaster", "--core", "-p", str(PORT)])
        wait_for("the master", lambda: rosgraph.is_master_online(os.environ["ROS_MASTER_URI"]))
        rospy.init_node("witness", disable_signals=True)
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=1000)
        self.tf_static = rospy.Publisher("/tf_static", TFMessage, queue_size=10, latch=True)
        # The camera looks along the base's x axis, a little above it.
        self.tf_static.publish([transform("base", "camera_optical", 0, (0.1, 0, 0.05), (-0.5, 0.5, -0.5, 0.5))])
        self.now_ns = 1_000 * 10**9
        self.moved_at = set()  # stamps, nanoseconds
        self.images, self.infos, self.diagnostics = [], [], []
        rospy.Subscriber("/diagnostics", DiagnosticArray, self.diagnostics.append)

    def tearDown(self):
        rospy.signal_shutdown("done")
        for program in reversed(self.programs):
            if program.poll() is None:
                program.kill()
            program.wait()

    def start(self, command):
        log = open(os.path.join(SCRATCH.name, f"log{len(self.programs)}"), "wb")
        self.programs.append(subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log))
        self.programs[-1].log = log.name
        return self.programs[-1]

    def log_of(self, program):
        with open(program.log, errors="replace") as log:
            return log.read()

    def start_node(self, **parameters):
        given = {"dataset": DATASET, "camera_info_url": "file://" + CAMERA, "pace": "every", **parameters}
        return self.start([NODE, *(f"_{name}:={value}" for name, value in given.items())])

    def is_recorded(self, topic):
        _, subscribers, _ = rosgraph.Master("/witness").getSystemState()
        return any(node.startswith("/record_") for node in dict(subscribers).get(topic, []))

    def end(self, program):
        program.send_signal(signal.SIGINT)
        self.assertEqual(program.wait(PATIENCE_S), 0, self.log_of(program))

    def listen(self):
        rospy.Subscriber("/camera/camera_info", CameraInfo, self.infos.append, buff_size=2**24)
        return rospy.Subscriber("/camera/image_raw", Image, self.images.append, buff_size=2**24)

    def move(self, milliseconds):
        self.now_ns += milliseconds * 10**6
        self.moved_at.add(self.now_ns)
        self.tf.publish([transform("map", "base", self.now_ns, *pose_at(self.now_ns))])

    def move_until(self, what, condition):
        def moved():
            self.move(100)
            return condition()

        wait_for(what, moved)

    def wait_for_first_frame(self):
        self.move_until("a frame", lambda: self.images)

    def stamps_of(self, messages):
        return [message.header.stamp.to_nsec() for message in messages]

    def expect_what_the_walk_shows(self, images, camera=CAMERA):
        """The same pictures and calibrations as spherewalk-cli renders at the poses of the stamps."""
        folder = tempfile.mkdtemp(dir=SCRATCH.name)
        with open(folder + "/p.tum", "w") as path:
            for stamp in self.stamps_of(images):
                (x, y, z), (_, _, s, c) = pose_at(stamp)
                # base from optical: turned by yaw, then to the optical axes
                q = [(-0.5 * c - 0.5 * s), (0.5 * c - 0.5 * s), (-0.5 * c + 0.5 * s), (0.5 * c + 0.5 * s)]
                cos, sin = c * c - s * s, 2 * s * c
                place = (x + 0.1 * cos, y + 0.1 * sin, z + 0.05)
                print(f"{stamp // 10**9}.{stamp % 10**9:09d}", *map(repr, place), *map(repr, q), file=path)
        subprocess.run([CLI, "walk", DATASET, "--camera", camera, "--path", folder + "/p.tum", "--out", folder + "/w",
                        "--format", "rosbag"], check=True, capture_output=True)
        with rosbag.Bag(folder + "/w/walk.bag") as bag:
            walked = [message for _, message, _ in bag.read_messages("/camera/image_raw")]
            info = next(message for _, message, _ in bag.read_messages("/camera/camera_info"))
        self.assertEqual(len(walked), len(images))
        for image, expected in zip(images, walked):
            self.assertEqual(image.header.frame_id, "camera_optical")
            self.assertEqual((image.width, image.height, image.encoding, image.step),
                             (expected.width, expected.height, expected.encoding, expected.step))
            different = sum(abs(a - b) for a, b in zip(image.data, expected.data))
            self.assertLessEqual(different, 3, "quaternions are multiplied here and there in another order")
        return info

    def test_shows_each_transform_with_its_stamp(self):
        self.start_node(rate=0)
        self.listen()
        self.wait_for_first_frame()
        sent = []
        for _ in range(20):
            self.move(10)
            sent.append(self.now_ns)
        wait_for("frames", lambda: self.images and self.images[-1].header.stamp.to_nsec() == sent[-1])
        wait_for("calibrations", lambda: len(self.infos) >= len(self.images))
        stamps = self.stamps_of(self.images)
        self.assertEqual(stamps[-20:], sent)
        infos = {info.header.stamp.to_nsec(): info for info in self.infos}
        expected = self.expect_what_the_walk_shows(self.images[-20:])
        for stamp in sent:
            info = infos[stamp]
            self.assertEqual(info.header.frame_id, "camera_optical")
            for field in "distortion_model", "D", "K", "R", "P", "width", "height":
                self.assertEqual(getattr(info, field), getattr(expected, field), field)

    def test_a_rig_gives_pictures_of_all_its_cameras_with_equal_stamps(self):
        rig, pinhole = SCRATCH.name + "/rig.yaml", SCRATCH.name + "/pinhole.yaml"
        with open(pinhole, "w") as file:
            print("image_width: 160\nimage_height: 120\ncamera_matrix: {data: [120, 0, 79.5, 0, 120, 59.5, 0, 0, 1]}",
                  file=file)
        with open(rig, "w") as file:  # transforms say where the right camera is
            print("cameras:", f"  - {{name: left, camera_info: {pinhole}, rig_from_camera: [0, 0, 0, 0, 0, 0, 1]}}",
                  f"  - {{name: right, camera_info: {pinhole}}}", sep="\n", file=file)
        turn = (-0.5, 0.5, -0.5, 0.5)
        self.tf_static.publish([transform("base", "camera_optical", 0, (0.1, 0, 0.05), turn),
                                transform("base", "right_optical", 0, (0.1, -0.12, 0.05), turn)])
        self.start_node(rate=0, camera_info_url="", rig=rig, depth="16UC1", scene="sphere")
        came = {}
        for topic in ("left/image_raw", "right/image_raw", "left/depth/image_raw", "right/depth/image_raw"):
            kept = came[topic] = {}
            rospy.Subscriber("/" + topic, Image, lambda m, kept=kept: kept.__setitem__(m.header.stamp.to_nsec(), m),
                             buff_size=2**24)
        rospy.Subscriber("/right/camera_info", CameraInfo, self.infos.append, buff_size=2**24)

        def whole():
            return set.intersection(*(set(kept) for kept in came.values()))

        self.move_until("both cameras with depth", lambda: len(whole()) > 3 and self.infos)
        stamp = max(whole())
        self.assertEqual(came["left/image_raw"][stamp].header.frame_id, "left_optical")
        self.assertEqual(came["right/image_raw"][stamp].header.frame_id, "right_optical")
        self.assertNotEqual(came["left/image_raw"][stamp].data, came["right/image_raw"][stamp].data)
        self.assertEqual(came["right/depth/image_raw"][stamp].encoding, "16UC1")
        info = self.infos[-1]
        self.assertAlmostEqual(info.P[3], -0.12 * info.K[0], 5)

    def test_keeps_the_rate_of_simulation_time(self):
        rospy.set_param("/use_sim_time", True)
        clock = rospy.Publisher("/clock", Clock, queue_size=10, latch=True)
        clock.publish(Clock(rospy.Time(1000)))
        self.start_node(rate=30)
        self.listen()
        self.wait_for_first_frame()
        self.now_ns = 2_000 * 10**9 - 10 * 10**6
        for _ in range(60):
            self.move(10)
        last = 2_000 * 10**9 + 570 * 10**6  # the first at or after 17/30 s
        wait_for("frames", lambda: self.images[-1].header.stamp.to_nsec() == last)
        stamps = [stamp for stamp in self.stamps_of(self.images) if stamp >= 2_000 * 10**9]
        first_of_slot = {}
        for tick in range(60):
            first_of_slot.setdefault(tick * 30 // 100, 2_000 * 10**9 + tick * 10**7)
        self.assertEqual(stamps, list(first_of_slot.values()))

    def test_rosbag_and_rostopic_see_it(self):
        self.start_node(rate=30)
        bag = SCRATCH.name + "/recorded.bag"
        topics = ["/camera/image_raw", "/camera/camera_info", "/tf"]
        record = self.start(["rosbag", "record", "-O", bag, *topics])
        wait_for("the recorder", lambda: all(self.is_recorded(topic) for topic in topics))
        rate = self.start(["/usr/bin/env", "PYTHONUNBUFFERED=1", "rostopic", "hz", "/camera/image_raw"])
        self.listen()
        self.move_until("rostopic", lambda: "average rate" in self.log_of(rate))
        self.move_until("more frames", lambda: len(self.images) > 20)
        self.end(record)
        self.assertIn("/camera/image_raw", subprocess.run(["rosbag", "info", bag], check=True, text=True,
                                                          capture_output=True).stdout)
        subprocess.run(["rosbag", "check", bag], check=True, capture_output=True)
        with rosbag.Bag(bag) as recorded:
            images = [message for _, message, _ in recorded.read_messages("/camera/image_raw")]
            transforms = [t for _, message, _ in recorded.read_messages("/tf") for t in message.transforms]
        # Each topic is recorded for itself, so a picture at either end may stand there without its transform.
        for messages in images, transforms:
            self.assertTrue(messages)
            self.assertLessEqual(set(self.stamps_of(messages)), self.moved_at)
        self.expect_what_the_walk_shows(images)

    def test_renders_only_while_somebody_listens(self):
        node = self.start_node(rate=0)
        wait_for("the node", lambda: self.diagnostics)
        for _ in range(50):
            self.move(10)
        self.move_until("diagnostics", lambda: "nobody listens" in self.diagnostics[-1].status[0].message)
        frames = [value.value for message in self.diagnostics for value in message.status[0].values
                  if value.key == "frames"]
        self.assertEqual(set(frames), {"0"})
        listening = self.listen()
        self.wait_for_first_frame()
        listening.unregister()
        self.end(node)

    def test_garbage_does_no_harm_and_is_reported(self):
        node = self.start_node(rate=0, overlay="labels", overlay_wait=0)
        self.listen()
        self.wait_for_first_frame()
        nan, none = float("nan"), (0, 0, 0, 1)
        for place, turn in (((nan, 0, 0), none), ((0, 0, 0), (nan, 0, 0, 1)), ((0, 0, 0), (0, 0, 0, 0)),
                            ((1e300, 0, 0), none)):
            self.tf.publish([transform("map", "base", self.now_ns + 1, place, turn)])
        self.tf.publish([transform("", "base", self.now_ns, (0, 0, 0), none),
                         transform("base", "base", self.now_ns, (0, 0, 0), none),
                         transform("base", "map", self.now_ns, (0, 0, 0), none)])  # a ring
        self.tf.publish([transform("nowhere", "base", self.now_ns, (0, 0, 0), none)])
        pose = PoseStamped()
        pose.header.frame_id = "elsewhere"
        pose.pose.orientation.w = 1
        poses = rospy.Publisher("/camera/pose", PoseStamped, queue_size=10)
        wait_for("the node", lambda: poses.get_num_connections() > 0)
        poses.publish(pose)
        overlay = rospy.Publisher("/overlay/image_raw", Image, queue_size=10)
        depth = rospy.Publisher("/overlay/depth", Image, queue_size=10)
        wait_for("the node", lambda: overlay.get_num_connections() > 0 and depth.get_num_connections() > 0)
        for width, height, encoding, step, size in ((160, 120, "rgb8", 480, 10), (2**32 - 1, 2**32 - 1, "rgb8", 0, 0),
                                                    (160, 120, "yuv422", 320, 38400), (0, 0, "", 0, 0),
                                                    (160, 120, "rgb8", 2**32 - 1, 57600)):
            picture = Image(width=width, height=height, encoding=encoding, step=step, data=bytes(size))
            picture.header.stamp = rospy.Time.from_sec(self.now_ns / 1e9)
            overlay.publish(picture)
            depth.publish(picture)

        def refused(kind):
            return any(value.key == "refused so far: " + kind and int(value.value) > 0
                       for message in self.diagnostics for value in message.status[0].values)

        for kind in "place", "rotation", "frame_id", "size", "encoding":
            self.move_until(f"a report of {kind}", lambda: refused(kind))
        self.assertIsNone(node.poll(), self.log_of(node))
        self.assertIn("was not used", self.log_of(node))
        self.tf.publish([transform("map", "base", self.now_ns, *pose_at(self.now_ns))])
        before = len(self.images)
        self.move_until("frames after it", lambda: len(self.images) > before + 2)
        self.expect_what_the_walk_shows(self.images[-1:])
        self.end(node)

    def test_takes_another_camera_while_it_runs(self):
        self.start_node(rate=0)
        self.listen()
        self.wait_for_first_frame()
        rospy.wait_for_service("/camera/set_camera_info", PATIENCE_S)
        switch = rospy.ServiceProxy("/camera/set_camera_info", SetCameraInfo)
        camera = CameraInfo(width=64, height=48, distortion_model="equidistant", D=[0.01, 0.0, 0.0, 0.0],
                            K=[40, 0, 31.5, 0, 40, 23.5, 0, 0, 1])
        answer = switch(camera)
        self.assertTrue(answer.success, answer.status_message)
        self.move_until("a frame of the new camera", lambda: self.images[-1].width == 64)
        wait_for("its calibration", lambda: self.infos[-1].width == 64)
        self.assertEqual(self.infos[-1].D, (0.01, 0.0, 0.0, 0.0))
        with open(SCRATCH.name + "/fisheye.yaml", "w") as file:
            file.write("image_width: 64\nimage_height: 48\ndistortion_model: equidistant\n"
                       "camera_matrix: {data: [40, 0, 31.5, 0, 40, 23.5, 0, 0, 1]}\n"
                       "distortion_coefficients: {data: [0.01, 0, 0, 0]}\n")
        self.expect_what_the_walk_shows(self.images[-1:], file.name)
        for bad in CameraInfo(), CameraInfo(width=2**31, height=1, K=[float("nan")] * 9):
            answer = switch(bad)
            self.assertFalse(answer.success)
            self.assertTrue(answer.status_message)

    def test_a_killed_node_comes_back(self):
        node = self.start_node(rate=0)
        self.listen()
        self.wait_for_first_frame()
        node.kill()
        node.wait()
        self.images.clear()
        self.start_node(rate=0)
        self.wait_for_first_frame()
        self.expect_what_the_walk_shows(self.images[-1:])

    def test_lays_a_simulators_objects_in(self):
        self.start_node(rate=50, overlay="alone", overlay_wait=10)
        self.listen()
        publishers = [rospy.Publisher(topic, Image, queue_size=10) for topic in ("/overlay/image_raw", "/overlay/depth")]
        for publisher in publishers:
            wait_for("the node", lambda: publisher.get_num_connections() > 0)

        def objects_between_transforms():
            self.move(10)
            stamp_ns = self.now_ns + 5 * 10**6
            stamp = rospy.Time(stamp_ns // 10**9, stamp_ns % 10**9)
            colour = Image(width=160, height=120, encoding="rgb8", step=480, data=bytes([255, 0, 0]) * 160 * 120)
            near = b"\x64\0" * 80 + b"\0\0" * 80  # 100 mm in the left half, none in the right
            depth = Image(width=160, height=120, encoding="16UC1", step=320, data=near * 120)
            for picture, publisher in zip((colour, depth), publishers):
                picture.header.stamp = stamp
                publisher.publish(picture)
            self.move(10)
            return self.images

        wait_for("a frame", objects_between_transforms)
        frame = self.images[-1]
        self.assertEqual(frame.header.stamp.to_nsec() % 10**7, 5 * 10**6, "that of the overlay")
        rows = [frame.data[480 * y:480 * (y + 1)] for y in range(120)]
        for row in rows:
            self.assertEqual(row[:3 * 78], bytes([255, 0, 0]) * 78)
            self.assertNotIn(bytes([255, 0, 0]), [row[3 * x:3 * x + 3] for x in range(83, 160)])

    def test_a_camera_that_stands_still_takes_ros_time(self):
        self.tf_static.publish([transform("map", "base", 0, *pose_at(0)),
                                transform("base", "camera_optical", 0, (0.1, 0, 0.05), (-0.5, 0.5, -0.5, 0.5))])
        self.start_node(rate=30)
        self.listen()
        wait_for("frames", lambda: len(self.images) > 2)
        self.assertLess(abs((rospy.Time.now() - self.images[-1].header.stamp).to_sec()), PATIENCE_S)

    def test_refuses_in_a_sentence(self):
        for wrong, said in (({"dataset": "/nowhere"}, "/nowhere"), ({"scene": "cubist"}, "cubist"),
                            ({"room_frame": "camera_optical"}, "frames of the room and of the camera"),
                            ({"rig": "/nowhere.yaml"}, "both set"), ({"camera_info_url": "", "rig": ""}, "or rig"),
                            ({"camera_info_url": "", "rig": "/nowhere.yaml"}, "/nowhere.yaml"),
                            ({"rate": "often"}, "of another type")):
            node = self.start_node(**wrong)
            self.assertEqual(node.wait(PATIENCE_S), 1, self.log_of(node))
            self.assertIn(said, self.log_of(node))

    def test_roslaunch_needs_no_workspace(self):
        os.environ["ROS_PACKAGE_PATH"] = os.path.dirname(os.path.dirname(NODE)) + ":/usr/share"
        launch = self.start(["roslaunch", "spherewalk", "camera.launch", f"dataset:={DATASET}",
                             f"camera_info:={CAMERA}", "rate:=0"])
        self.listen()
        self.wait_for_first_frame()
        self.expect_what_the_walk_shows(self.images[-1:])
        self.end(launch)  # and with it the node, which is in a session of its own


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *("Ros1." + case for case in sys.argv[1:])])
