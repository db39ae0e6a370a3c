# SPDX-License-Identifier: GPL-3.0-or-later
import json
import os
import shutil
import signal

import numpy as np
import pytest
import spherewalk
from conftest import BODY_POSE, DEMO
from spherewalk import Camera, Dataset, ViewOptions

GOOD = np.eye(4)


def changed(row, column, value):
    matrix = np.eye(4)
    matrix[row, column] = value
    return matrix


@pytest.mark.parametrize("pose, words", [
    (changed(0, 3, np.nan), "not finite"),
    (changed(1, 1, np.inf), "not finite"),
    ([np.nan, 0, 0, 0, 0, 0, 1], "not finite"),
    ([0, 0, 0, 0, 0, 0, 2], "not a unit quaternion"),
    ([0, 0, 0, 0, 0, 0, 0], "not a unit quaternion"),
    (2 * GOOD, "scaled"),
    (changed(0, 0, -1), "mirrored"),
    (changed(3, 0, 1), "transposed"),
    (GOOD[:3], r"shape \(3, 4\)"),
    ([1, 2, 3], r"shape \(3,\)"),
    (GOOD.astype(complex), "real numbers; it is complex128"),
    (GOOD.astype(str), "real numbers"),
    ([[1, 2], [3]], "real numbers"),
    (None, "real numbers"),
    ("1 2 3 0 0 0 1", "real numbers"),
])
def test_poses_that_are_none_are_refused(renderer, small, pose, words):
    with pytest.raises(spherewalk.InvalidInputError, match=words):
        renderer.render(small, pose)
    with pytest.raises(ValueError):
        renderer.render_many(small, [GOOD, pose])
    with pytest.raises(ValueError):
        spherewalk.ViewStream(renderer, small).next(pose, 0)


def test_one_pose_is_not_many(renderer, small):
    with pytest.raises(ValueError, match=r"shape \(1, 4, 4\)"):
        renderer.render(small, [GOOD])
    with pytest.raises(ValueError, match=r"shape \(4, 4\)"):
        renderer.render_many(small, GOOD)


@pytest.mark.parametrize("arguments, words", [
    ((0, 480, np.eye(3)), "1 to 32768"),
    ((640, 40000, np.eye(3)), "1 to 32768"),
    ((640, 480, np.eye(4)), r"must be \(3, 3\)"),
    ((640, 480, np.full((3, 3), np.nan)), "not finite"),
    ((640, 480, [[500, 1, 320], [0, 500, 240], [0, 0, 1]]), "no skew"),
    ((640, 480, np.diag([-500, 500, 1])), "focal"),
    ((640, 480, np.diag([500, 500, 1]), [0.1, 0.2]), "0 parameters|0 distortion|has 0"),
    ((640, 480, np.diag([500, 500, 1]), [0.1], "barrel"), "none, plumb_bob, rational_polynomial and equidistant"),
    ((640, 480, np.diag([500, 500, 1]), [np.inf, 0, 0, 0, 0], "plumb_bob"), "not finite"),
])
def test_cameras_that_are_none_are_refused(arguments, words):
    with pytest.raises(spherewalk.InvalidInputError, match=words):
        Camera(*arguments)


def test_words_that_are_unknown_are_refused_with_those_that_are(renderer, small, dataset):
    for options, words in [({"scene": "sphere "}, "none, sphere, room, depth and blend"),
                           ({"sampling": "finest"}, "nearest, bilinear"),
                           ({"overlay_edges": "round"}, "soft and hard"),
                           ({"threads": -1}, "0 \\(all\\) to"),
                           ({"tolerance_db": np.nan}, "finite tolerance_db")]:
        with pytest.raises(spherewalk.InvalidInputError, match=words):
            ViewOptions(**options)
    with pytest.raises(spherewalk.InvalidInputError, match="optical and body"):
        renderer.render(small, GOOD, frame="base_link")
    with pytest.raises(spherewalk.InvalidInputError, match="wait, coarse and previous"):
        spherewalk.ViewStream(renderer, small, late="never")
    with pytest.raises(spherewalk.InvalidInputError, match="has no depth scene model"):
        renderer.render(small, GOOD, ViewOptions(scene="depth"))
    with pytest.raises(TypeError):
        ViewOptions(scenes="none")
    with pytest.raises(TypeError, match="not int"):
        renderer.render(small, GOOD, overlays=[1])
    with pytest.raises(TypeError, match="not iterable"):
        renderer.render(small, GOOD, overlays=spherewalk.Overlay(np.zeros((1, 1, 3), np.uint8), np.ones((1, 1))))


def test_errors_are_python_s_own_kinds_besides(tmp_path):
    assert issubclass(spherewalk.InvalidInputError, ValueError) and issubclass(spherewalk.CorruptError, ValueError)
    assert issubclass(spherewalk.NotFoundError, FileNotFoundError) and issubclass(spherewalk.ReadError, OSError)
    for error in (spherewalk.InvalidInputError, spherewalk.NotFoundError, spherewalk.BusyError):
        assert issubclass(error, spherewalk.Error)
    with pytest.raises(FileNotFoundError, match=str(tmp_path)) as raised:
        Dataset.open(tmp_path / "none")
    assert raised.value.kind == "not_found" and isinstance(raised.value, spherewalk.Error)
    with pytest.raises(FileNotFoundError):
        Camera.read(tmp_path / "none.yaml")
    with pytest.raises(FileNotFoundError):
        spherewalk.read_tum(tmp_path / "none.tum")


def test_a_damaged_dataset_is_refused(small, tmp_path):
    shutil.copytree(DEMO / "dataset", tmp_path / "d")
    description = tmp_path / "d/dataset.json"
    good = json.loads(description.read_text())
    photo = tmp_path / "d" / good["photos"][0]["file"]
    bytes_of_photo = bytearray(photo.read_bytes())
    bytes_of_photo[-100] ^= 1
    photo.write_bytes(bytes_of_photo)
    with pytest.raises(spherewalk.CorruptError, match=photo.name):
        Dataset.open(tmp_path / "d", verify="hashes")
    renderer = spherewalk.Renderer(Dataset.open(tmp_path / "d"))
    position = Dataset.open(tmp_path / "d").photos[0].room_from_photo[:3, 3]
    with pytest.raises(spherewalk.CorruptError, match=photo.name):
        renderer.render(small, [*position, 0, 0, 0, 1])
    photo.unlink()
    with pytest.raises(spherewalk.Error, match=photo.name):
        Dataset.open(tmp_path / "d")
    description.write_text(json.dumps({**good, "version": 99}))
    with pytest.raises(spherewalk.UnsupportedError, match="99"):
        Dataset.open(tmp_path / "d")
    description.write_text("{")
    with pytest.raises(spherewalk.CorruptError):
        Dataset.open(tmp_path / "d")


def test_what_a_progress_function_raises_ends_the_call():
    fractions = []

    def stop(fraction, activity):
        fractions.append(fraction)
        raise KeyError(activity)

    with pytest.raises(KeyError):
        Dataset.open(DEMO / "dataset", verify="hashes", progress=stop)
    assert len(fractions) == 1
    seen = []
    Dataset.open(DEMO / "dataset", verify="hashes", progress=lambda fraction, activity: seen.append(fraction))
    assert seen == sorted(seen) and seen[-1] == 1


def test_ctrl_c_ends_many_views(renderer, camera):
    poses = np.tile(BODY_POSE, (100_000, 1))  # a list would be interrupted while it is read
    previous = signal.signal(signal.SIGALRM, signal.default_int_handler)  # as Ctrl-C does
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(KeyboardInterrupt):
            renderer.render_many(camera, poses)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)


def test_ctrl_c_while_poses_are_read_is_no_wrong_input(renderer, camera):
    class Poses:
        def __array__(self, *_, **__):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        renderer.render_many(camera, Poses())


def test_a_forked_process_makes_its_own_renderer(renderer, small, dataset):
    stream = spherewalk.ViewStream(renderer, small)
    child = os.fork()
    if child == 0:  # whose end must not be pytest's
        refused = 0
        for use in (lambda: renderer.render(small, BODY_POSE), lambda: renderer.render_many(small, [BODY_POSE]),
                    lambda: stream.next(BODY_POSE, 0), lambda: spherewalk.ViewStream(renderer, small)):
            try:
                use()
            except spherewalk.BusyError:
                refused += 1
        own = spherewalk.Renderer(dataset).render(small, BODY_POSE).picture.any()
        os._exit(refused if own else 99)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 4
    assert renderer.render(small, BODY_POSE).picture.any()
