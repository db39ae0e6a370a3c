# SPDX-License-Identifier: GPL-3.0-or-later
"""Spherical photos of a camera that turned while the shutter was open, or that was not moved between two photos."""

import io

import numpy as np
from PIL import Image
from scipy.ndimage import map_coordinates


def headers(jpeg):
    """The APP1 segments, which say how the camera leaned."""
    at, found = 2, b""
    while jpeg[at] == 0xFF and jpeg[at + 1] != 0xDA:
        size = 2 + int.from_bytes(jpeg[at + 2:at + 4], "big")
        found += jpeg[at:at + size] if jpeg[at + 1] == 0xE1 else b""
        at += size
    return found


def directions(height, width):
    azimuth = (0.5 - (np.arange(width) + 0.5) / width) * 2 * np.pi
    elevation = (0.5 - (np.arange(height) + 0.5) / height) * np.pi
    flat = np.cos(elevation)[:, None]
    return np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth),
                     np.broadcast_to(np.sin(elevation)[:, None], (height, width))])


def turn(axis, angle):
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def turned(planes, rays):
    """The picture's planes where the rays look."""
    height, width = planes[0].shape
    column = (0.5 - np.arctan2(rays[1], rays[0]) / (2 * np.pi)) * width - 0.5
    row = (0.5 - np.arcsin(np.clip(rays[2], -1, 1)) / np.pi) * height - 0.5
    at = [np.clip(row, 0, height - 1), column % width]
    return [map_coordinates(plane, at, order=1, mode="grid-wrap") for plane in planes]


def read(jpeg):
    return np.asarray(Image.open(io.BytesIO(jpeg)).convert("RGB"), np.float32)


def write(target, picture, jpeg):
    """With the metadata of that JPEG."""
    out = io.BytesIO()
    Image.fromarray(np.clip(np.rint(picture), 0, 255).astype(np.uint8)).save(out, "JPEG", quality=93)
    target.write_bytes(out.getvalue()[:2] + headers(jpeg) + out.getvalue()[2:])


def blurred(source, target, axis, length_px):
    """The camera turned about this axis of the photo by so many pixels of the equator, half before and half after its pose. That
    pose therefore stays the true one."""
    jpeg = source.read_bytes()
    picture = read(jpeg)
    planes = [np.ascontiguousarray(picture[..., plane]) for plane in range(3)]
    height, width = planes[0].shape
    rays = directions(height, width).reshape(3, -1)
    axis = np.asarray(axis) / np.linalg.norm(axis)
    steps = max(3, length_px // 2)
    total = np.zeros((3, height, width), np.float32)
    for step in range(steps):
        angle = ((step + 0.5) / steps - 0.5) * length_px / width * 2 * np.pi
        total += turned(planes, (turn(axis, angle) @ rays).reshape(3, height, width))
    write(target, np.moveaxis(total / steps, 0, -1), jpeg)


def darker(source, target, seed):
    """The same picture a little darker and with other noise, as a second shot from one place has it."""
    jpeg = source.read_bytes()
    picture = read(jpeg)
    write(target, picture - 5 + np.random.default_rng(seed).normal(0, 3, picture.shape), jpeg)
