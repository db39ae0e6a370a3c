# SPDX-License-Identifier: GPL-3.0-or-later
import csv
import threading

import numpy as np
import pytest
import spherewalk
from conftest import BODY_POSE, DEMO, pixels


@pytest.mark.parametrize("prefetch_s", [0, 0.2])
def test_a_walk_has_the_frames_of_the_command_line(renderer, camera, prefetch_s):
    times, poses = spherewalk.read_tum(DEMO / "path.tum")
    with open(DEMO / "walk/index.csv", newline="") as file:
        index = list(csv.DictReader(file))
    assert len(times) == len(poses) == len(index) == 12
    stream = spherewalk.ViewStream(renderer, camera, prefetch_s=prefetch_s)
    for time_s, pose, line in zip(times, poses, index):
        view = stream.next(pose, time_s)
        assert view.report.file == line["photo"] and view.report.offset_m == float(line["offset_m"])
        assert np.array_equal(view.picture, pixels(DEMO / "walk" / line["frame"]))
    stream.wait_for_prefetch()
    counters = stream.counters
    assert counters.views == 12 and counters.coarse == counters.previous == 0


def test_a_stream_that_does_not_wait_says_so(dataset, camera):
    stream = spherewalk.ViewStream(spherewalk.Renderer(dataset), camera, late="coarse", prefetch_s=0)
    report = stream.next(BODY_POSE, 0).report
    assert report.late and report.origin == "thumbnail" and stream.counters.coarse == 1


def test_a_stream_keeps_what_it_needs(dataset, small):
    stream = spherewalk.ViewStream(spherewalk.Renderer(spherewalk.Dataset.open(DEMO / "dataset")), small)
    assert stream.next(BODY_POSE, 0).picture.any()


def test_a_second_thread_is_told_that_a_stream_is_busy(renderer, camera):
    stream = spherewalk.ViewStream(renderer, camera)
    slow = spherewalk.ViewOptions(exact=True, threads=1)
    seen = threading.Event()

    def use():
        while not seen.is_set():
            try:
                stream.next(BODY_POSE, 0, slow)
            except spherewalk.BusyError:
                seen.set()

    threads = [threading.Thread(target=use) for _ in range(2)]
    for thread in threads:
        thread.start()
    assert seen.wait(120)
    for thread in threads:
        thread.join()


def test_a_sensor_takes_frames(renderer, small):
    yaml = "{exposure: {time_s: 0.01}, noise: {full_well_e: 3000}, depth: {most_m: 0.01}}"
    times, poses = [1, 1.1], np.array([BODY_POSE, BODY_POSE], dtype=float)
    poses[1][0] += 0.05
    options = spherewalk.ViewOptions(scene="sphere", depth=True)

    def frame(sensor, number):
        return spherewalk.ViewStream(renderer, small).take(sensor, times, poses, 1.02, number, options, frame="body")

    first = frame(spherewalk.Sensor.parse(yaml, small), 1)
    assert np.array_equal(first.picture, frame(spherewalk.Sensor.parse(yaml, small), 1).picture)
    assert not np.array_equal(first.picture, frame(spherewalk.Sensor.parse(yaml, small), 2).picture)
    assert np.isinf(first.depth).all(), "beyond the range"
    plain = spherewalk.ViewStream(renderer, small).take(
        spherewalk.Sensor.parse("seed: 1", small), [1], [BODY_POSE], 1, 0, frame="body")
    assert np.array_equal(plain.picture, renderer.render(small, BODY_POSE, frame="body").picture)
    with pytest.raises(spherewalk.InvalidInputError, match="must ascend"):
        spherewalk.ViewStream(renderer, small).take(spherewalk.Sensor.parse("seed: 1", small), [1, 1], poses, 1, 0)
    with pytest.raises(spherewalk.InvalidInputError, match="as many times as poses"):
        spherewalk.ViewStream(renderer, small).take(spherewalk.Sensor.parse("seed: 1", small), [1], poses, 1, 0)
    with pytest.raises(spherewalk.InvalidInputError, match="unknown"):
        spherewalk.Sensor.parse("nose: {}", small)
