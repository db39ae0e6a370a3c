# SPDX-License-Identifier: GPL-3.0-or-later
"""The interpreter's lock is free while views are made. No clock decides: threads do not take turns by themselves here
(the interval is longer than any test), so that whatever another thread does meanwhile, it does because a view let it."""

import sys
import threading
import time

import numpy as np
import pytest
import spherewalk
from conftest import BODY_POSE

SLOW = spherewalk.ViewOptions(exact=True, threads=1)
TRIES = 50


@pytest.fixture
def no_turns():
    interval = sys.getswitchinterval()
    sys.setswitchinterval(10_000)
    yield
    sys.setswitchinterval(interval)


@pytest.mark.parametrize("use", [
    lambda renderer, camera, stream: renderer.render(camera, BODY_POSE, SLOW),
    lambda renderer, camera, stream: renderer.render_many(camera, [BODY_POSE], SLOW),
    lambda renderer, camera, stream: stream.next(BODY_POSE, 0, SLOW),
])
def test_another_thread_goes_on_while_a_view_is_made(renderer, camera, no_turns, use):
    stream = spherewalk.ViewStream(renderer, camera)
    go, went_on = threading.Event(), threading.Event()

    def other():
        go.wait()
        went_on.set()

    thread = threading.Thread(target=other)
    thread.start()
    go.set()
    for _ in range(TRIES):
        use(renderer, camera, stream)
        if went_on.is_set():
            break
    assert went_on.is_set()
    thread.join()


def test_two_threads_make_views_at_the_same_time(renderer, camera, no_turns):
    expected = renderer.render(camera, BODY_POSE, SLOW).picture
    for _ in range(TRIES):
        spans, pictures = [], []

        def view():
            begin = time.monotonic()
            picture = renderer.render(camera, BODY_POSE, SLOW).picture
            spans.append((begin, time.monotonic()))
            pictures.append(picture)

        threads = [threading.Thread(target=view) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert all(np.array_equal(picture, expected) for picture in pictures)
        (begin_a, end_a), (begin_b, end_b) = spans
        if begin_a < end_b and begin_b < end_a:
            return
    pytest.fail("no two views were ever made at the same time")
