# SPDX-License-Identifier: GPL-3.0-or-later
"""How views jump where a camera crosses from one photo's cell into the next: the table of resources/docs/figures.md.

    python3 borders.py ROBOT.yaml DATASET SCENE...

Each border lies half way between two neighbouring photos. The camera stands up to 0.3 steps beside their line and looks in any
direction. "motion" compares two views of one cell 4 mm apart. "border" compares what two single views show of one place, from
the photo before the border and from the one beyond. "stream" is the first frame after a stream has changed its photo, 2 cm
beyond the border and 4 mm after its last frame, beside what the photo before shows of the same place. `blend` mixes both photos
there, so that there is no such row.
"""

import pathlib
import sys

import numpy as np
import spherewalk
from scipy.ndimage import gaussian_filter, map_coordinates, uniform_filter

MOST_BORDERS = 24


def psnr(a, b):
    square = np.mean((a.astype(float) - b) ** 2)
    return 99 if square == 0 else 10 * np.log10(255 ** 2 / square)


def flow(a, b):
    """By how many pixels things move, where there is enough to see (Lucas and Kanade 1981, windows of 15 pixels)."""
    a, b = (gaussian_filter(picture.mean(-1), 1) for picture in (a, b))
    down, right = np.gradient(a)
    xx, xy, yy = (uniform_filter(product, 15) for product in (right * right, right * down, down * down))
    determinant = np.maximum(xx * yy - xy * xy, 1e-6)
    rows, columns = np.indices(a.shape, float)
    u = v = np.zeros(a.shape)
    for _ in range(4):
        apart = a - map_coordinates(b, [rows + v, columns + u], order=1, mode="nearest")
        x, y = uniform_filter(right * apart, 15), uniform_filter(down * apart, 15)
        u, v = u + (yy * x - xy * y) / determinant, v + (xx * y - xy * x) / determinant
    least = (xx + yy) / 2 - np.sqrt((xx - yy) ** 2 / 4 + xy ** 2)
    return np.hypot(u, v)[least > 2]


def turn(yaw, pitch):
    """From the optical frame of a level camera to the room."""
    forward = np.array([np.cos(yaw) * np.cos(pitch), np.sin(yaw) * np.cos(pitch), -np.sin(pitch)])
    right = np.array([np.sin(yaw), -np.cos(yaw), 0])
    return np.stack([right, np.cross(forward, right), forward], 1)


class Border:
    def __init__(self, a, b, step, random):
        self.along = (b - a) / np.linalg.norm(b - a)
        self.middle = (a + b) / 2 + random.uniform(-0.3, 0.3) * step * np.cross([0, 0, 1], self.along)
        self.turn = turn(random.uniform(-np.pi, np.pi), random.uniform(-0.2, 0.2))

    def pose(self, beyond):
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = self.turn, self.middle + beyond * self.along
        return matrix


def borders_of(dataset):
    places = [photo.room_from_photo[:3, 3] for photo in dataset.photos]
    pairs = [(np.linalg.norm(a - b), a, b) for i, a in enumerate(places) for b in places[i + 1:]]
    step = min(pair[0] for pair in pairs)
    near = [pair[1:] for pair in pairs if pair[0] < 1.15 * step]
    random = np.random.default_rng(5)
    chosen = random.permutation(len(near))[:MOST_BORDERS]
    return [Border(*near[i], step, random) for i in chosen]


def streamed(renderer, camera, border, scene):
    """The frame in which the photo changes, and the same place as the photo before shows it."""
    stream = spherewalk.ViewStream(renderer, camera)
    options = spherewalk.ViewOptions(scene=scene, sampling="bilinear")
    for time, beyond in enumerate((-0.05, -0.02, 0, 0.01, 0.015, 0.019, 0.023)):
        view = stream.next(border.pose(beyond), time, options)
    options = spherewalk.ViewOptions(scene=scene, sampling="bilinear", without=view.report.photo)
    return view.picture, renderer.render(camera, border.pose(0.023), options).picture.copy()


def main():
    camera = spherewalk.Camera.read(sys.argv[1])
    dataset = spherewalk.Dataset.open(sys.argv[2])
    renderer = spherewalk.Renderer(dataset)
    borders = borders_of(dataset)
    print("| dataset | scene | what | PSNR (worst) | moved: median, 95th percentile |\n|---|---|---|---|---|")
    for scene in sys.argv[3:]:
        options = spherewalk.ViewOptions(scene=scene, sampling="bilinear")
        single = lambda border, beyond: renderer.render(camera, border.pose(beyond), options).picture.copy()
        pairs = {"motion": lambda border: (single(border, -0.022), single(border, -0.018)),
                 "border": lambda border: (single(border, -1e-4), single(border, 1e-4)),
                 "stream": lambda border: streamed(renderer, camera, border, scene)}
        if scene == "blend":
            del pairs["stream"]
        for what, views in pairs.items():
            likeness, moved = [], []
            for border in borders:
                a, b = views(border)
                likeness.append(psnr(a, b))
                moved.append(np.quantile(flow(a, b), (0.5, 0.95)))
            median, most = np.mean(moved, 0)
            print(f"| {pathlib.Path(sys.argv[2]).stem} | `{scene}` | {what} | {np.mean(likeness):.1f} dB "
                  f"({np.min(likeness):.1f}) | {median:.2f}, {most:.2f} px |", flush=True)


if __name__ == "__main__":
    main()
