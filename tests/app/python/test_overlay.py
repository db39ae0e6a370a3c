# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np
import pytest
import spherewalk
from conftest import BODY_POSE
from spherewalk import Overlay, ViewOptions

SHAPE = (48, 64)
BOX = np.s_[16:32, 20:40]
INSIDE = np.s_[18:30, 22:38]  # away from edges that are soft


def square(distance_m, dtype=np.float32):
    """A red square, as a simulator would render it over black."""
    picture = np.zeros((*SHAPE, 3), np.uint8)
    picture[BOX] = [200, 30, 10]
    depth = np.full(SHAPE, np.inf, dtype)
    depth[BOX] = distance_m
    return picture, depth


def shown(renderer, camera, *overlays, **options):
    return renderer.render(camera, BODY_POSE, ViewOptions(**options), overlays=overlays, frame="body")


@pytest.fixture
def empty(renderer, small):
    return renderer.render(small, BODY_POSE, frame="body").picture


def test_a_near_object_hides_the_room_and_a_far_one_is_hidden(renderer, small, empty):
    near = shown(renderer, small, Overlay(*square(0.3)))
    assert (near.picture[INSIDE] == [200, 30, 10]).all() and (near.overlaid[INSIDE] == 255).all()
    outside = near.overlaid == 0
    assert outside.sum() >= 48 * 64 - 18 * 22 and np.array_equal(near.picture[outside], empty[outside])
    far = shown(renderer, small, Overlay(*square(50.0)))
    assert np.array_equal(far.picture, empty) and not far.overlaid.any()


def test_the_nearer_of_two_is_in_front(renderer, small):
    picture, depth = square(0.3)
    green = np.full((*SHAPE, 3), [0, 255, 0], np.uint8)
    behind = Overlay(green, np.full(SHAPE, 0.4, np.float32))
    both = shown(renderer, small, behind, Overlay(picture, depth))
    assert (both.picture[INSIDE] == [200, 30, 10]).all() and (both.picture[2, 2] == [0, 255, 0]).all()


def test_the_simulators_own_room_hides_too(renderer, small, empty):
    picture, depth = square(0.3)
    room = np.full(SHAPE, 0.2, np.float32)
    room[:, 30:] = 5
    half = shown(renderer, small, Overlay(picture, depth, room_depth=room), overlay_edges="hard").overlaid
    assert not half[:, :30].any() and (half[BOX][:, 10:] == 255).all()


def test_a_shadow_darkens_the_photo_and_no_object(renderer, small, empty):
    picture, depth = square(0.3)
    shadow = np.ones(SHAPE, np.float32)
    shadow[:, :30] = 51 / 255
    half = shown(renderer, small, Overlay(picture, depth, shadow=shadow)).picture
    assert (half[INSIDE] == [200, 30, 10]).all()
    assert np.array_equal(half[40:, 30:], empty[40:, 30:])
    light = ((empty[40:, :30] / 255 + 0.055) / 1.055) ** 2.4 * 0.2
    stored = 255 * np.where(light > 0.0031308, 1.055 * light ** (1 / 2.4) - 0.055, 12.92 * light)
    assert np.abs(half[40:, :30] - stored)[empty[40:, :30] > 10].max() < 0.6
    as_bytes = Overlay(picture, depth, shadow=np.round(255 * shadow).astype(np.uint8))
    assert np.array_equal(shown(renderer, small, as_bytes).picture, half)


@pytest.mark.parametrize("share", [np.nan, -0.1, 1.1])
def test_a_shadow_that_is_none_is_refused(renderer, small, share):
    with pytest.raises(spherewalk.InvalidInputError, match="shadow"):
        shown(renderer, small, Overlay(*square(0.3), shadow=np.full(SHAPE, share, np.float32)))
    with pytest.raises(spherewalk.InvalidInputError, match="shadow"):
        Overlay(*square(0.3), shadow=np.zeros(SHAPE, np.int32))


@pytest.mark.parametrize("nothing", [np.nan, np.inf, -np.inf, 0, -1])
def test_a_depth_that_is_none_shows_nothing(renderer, small, empty, nothing):
    picture, depth = square(0.3)
    depth[BOX] = nothing
    assert np.array_equal(shown(renderer, small, Overlay(picture, depth)).picture, empty)


def test_any_layout_of_an_array_is_the_same_object(renderer, small):
    picture, depth = square(0.3)
    rgba = np.dstack([picture, np.where(np.isfinite(depth), 255, 0).astype(np.uint8)])
    expected = shown(renderer, small, Overlay(picture, depth)).picture
    upside_down = (np.ascontiguousarray(picture[::-1])[::-1], np.ascontiguousarray(depth[::-1])[::-1])
    for overlay in (Overlay(rgba, depth), Overlay(rgba, depth, alpha="premultiplied"), Overlay(*upside_down),
                    Overlay(np.asfortranarray(picture), depth.astype(np.float64)), Overlay(picture, depth, small)):
        assert np.array_equal(shown(renderer, small, overlay).picture, expected)


def test_the_arrays_are_copied(renderer, small):
    picture, depth = square(0.3)
    overlay = Overlay(picture, depth)
    expected = shown(renderer, small, overlay).picture
    picture[:] = 0
    depth[:] = np.inf
    assert np.array_equal(shown(renderer, small, overlay).picture, expected)


@pytest.mark.parametrize("picture, depth, words", [
    (np.zeros((*SHAPE, 3), np.float32), None, "uint8; it is float32"),
    (np.zeros((*SHAPE, 2), np.uint8), None, r"shape \(48, 64, 2\)"),
    (np.zeros(SHAPE, np.uint8), None, r"shape \(48, 64\)"),
    (np.zeros((48, 63, 3), np.uint8), None, r"its depth \(48, 64\)"),
    (np.zeros((0, 64, 3), np.uint8), None, "must be 1 to"),
    ([[1]], None, "it is a list"),
    (None, np.zeros((48, 64, 1), np.float32), r"must be \(height, width\)"),
    (None, np.zeros(SHAPE, np.uint16), "float32 or float64; it is uint16"),
    (None, np.zeros((1, 40000), np.float32), "must be 1 to"),
])
def test_arrays_that_are_no_pictures_are_refused(picture, depth, words):
    good = square(0.3)
    with pytest.raises(ValueError, match=words):
        Overlay(good[0] if picture is None else picture, good[1] if depth is None else depth)


def test_an_overlay_of_another_camera_must_say_so(renderer, small, empty):
    other = spherewalk.Camera.pinhole(128, 96, 1.2)
    picture = np.full((96, 128, 3), [9, 8, 7], np.uint8)
    depth = np.full((96, 128), 0.3, np.float32)
    with pytest.raises(spherewalk.InvalidInputError, match="128 x 96 pixels, the camera 64 x 48"):
        shown(renderer, small, Overlay(picture, depth))
    assert (shown(renderer, small, Overlay(picture, depth, other)).picture[INSIDE] == [9, 8, 7]).all()
    with pytest.raises(spherewalk.InvalidInputError, match="room's depth has 64 x 48"):
        shown(renderer, small, Overlay(picture, depth, other, room_depth=np.ones(SHAPE, np.float32)))
