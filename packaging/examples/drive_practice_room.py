#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives a robot that carries the camera through all stations of a survey.

The robot is a stand-in: it sends each station's position as if it had just arrived there, waits until the
exposure is over, and goes on. Replace move_to() by a call that moves a real one and returns the position
that it reached. Ends with status 0 if every station has a photo that is not failed.

    spherewalk-cli practice-camera --port 8080 &
    drive_practice_room.py room.spherewalk --camera 127.0.0.1:8080 --practice
"""

import argparse
import collections
import json
import subprocess
import sys
import time


def move_to(station, seconds):
    """Moves the robot; where it stands then, metres in the room frame."""
    time.sleep(seconds)
    return station["position_m"]


def follower(arguments):
    command = [arguments.cli, "capture", arguments.survey, "--follow", "--json", "--camera", arguments.camera]
    command += ["--time-scale", str(arguments.time_scale)]
    command += ["--practice"] if arguments.practice else []
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def drive(arguments, stations):
    """The verdicts, by station, and the report at the end."""
    capture = follower(arguments)
    verdicts = {}

    def next_event():
        line = capture.stdout.readline()
        if not line:
            raise SystemExit(f"spherewalk-cli ended with status {capture.wait()}")
        event = json.loads(line)
        if event.get("event") == "verdict":
            verdicts[event["station"]] = event
        if event.get("sentence"):
            print(f"{event.get('station', '')}: {event['sentence']}", file=sys.stderr)
        return event

    for station in stations:
        x, y, z = move_to(station, arguments.move_time)
        capture.stdin.write(json.dumps({"x": x, "y": y, "z": z}) + "\n")
        capture.stdin.flush()
        while True:  # verdicts on earlier photos arrive meanwhile
            event = next_event()
            is_answer = event["event"] in ("exposed", "verdict", "missed") and event["station"] == station["name"]
            if is_answer or event["event"] == "refused":
                break
    capture.stdin.close()
    event = next_event()
    while "event" in event:
        event = next_event()
    capture.wait()
    return verdicts, event


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("survey")
    parser.add_argument("--cli", default="spherewalk-cli", help="the program")
    parser.add_argument("--camera", default="192.168.1.1")
    parser.add_argument("--time-scale", type=float, default=1.0, help="of a practice camera")
    parser.add_argument("--practice", action="store_true", help="the camera is a practice camera")
    parser.add_argument("--move-time", type=float, default=0.0, help="seconds from station to station")
    arguments = parser.parse_args()

    plan = subprocess.run([arguments.cli, "plan", arguments.survey, "--json"], check=True, text=True,
                          stdout=subprocess.PIPE)
    stations = json.loads(plan.stdout)["station_list"]
    verdicts, report = drive(arguments, stations)
    counts = collections.Counter(event["verdict"] for event in verdicts.values())
    print(f"{len(verdicts)} of {len(stations)} stations have a photo: {counts['good']} good, "
          f"{counts['doubtful']} doubtful, {counts['failed']} failed; "
          f"{report['photos_per_minute']:.1f} photos a minute, "
          f"{report['software_seconds_per_photo']:.2f} s of the software's own a photo")
    return 0 if len(verdicts) == len(stations) and counts["failed"] == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
