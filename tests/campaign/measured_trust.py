# SPDX-License-Identifier: GPL-3.0-or-later
"""What views say about their errors, beside what is true: the table of resources/docs/trust.md.

    python3 measured_trust.py ROBOT.yaml PICTURES.csv DATASET...

PICTURES.csv is the file that "measure --pictures" reads, with a column `depth`: a PNG of the true depth, z along the optical
axis in millimetres, 0 where it is not known.
"""

import csv
import pathlib
import sys

import numpy as np
import spherewalk
from PIL import Image

NAMES = ("dataset", "scene", "inside", "over", "ratio", "worse 0.5", "worse 1", "worse 2", "worse 5", "flagged of bad",
         "flagged")


def ranks(values):
    _, inverse, counts = np.unique(values, return_inverse=True, return_counts=True)
    return (np.cumsum(counts) - (counts - 1) / 2)[inverse]


def rank_correlation(a, b):
    ranks_a, ranks_b = ranks(a), ranks(b)
    return np.corrcoef(ranks_a, ranks_b)[0, 1] if ranks_a.std() > 0 and ranks_b.std() > 0 else 0


def projected(rays, k):
    return np.stack([rays[..., 0] / rays[..., 2] * k[0, 0], rays[..., 1] / rays[..., 2] * k[1, 1]], -1)


class Truth:
    """The pictures' poses and true distances, for a camera without distortion."""

    def __init__(self, camera, table):
        self.camera = camera
        columns, rows = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
        k = camera.K
        self.axis = np.stack([(columns - k[0, 2]) / k[0, 0], (rows - k[1, 2]) / k[1, 1], np.ones(columns.shape)], -1)
        self.length = np.linalg.norm(self.axis, axis=-1)
        self.rays = self.axis / self.length[..., None]
        self.pictures = []
        for line in csv.DictReader(open(table)):
            pose = [float(line[name]) for name in ("x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")]
            depth = np.array(Image.open(table.parent / line["depth"]), float) / 1000
            self.pictures.append((pose, np.where(depth > 0, 1 / np.maximum(depth, 1e-3) / self.length, np.nan)))

    def displacement(self, matrix, photo, inverse, truth):
        """Of the thing at its true distance, seen where the view has it; first order in the error of 1 / distance."""
        offset = matrix[:3, :3].T @ (matrix[:3, 3] - photo)
        across = offset - (self.rays @ offset)[..., None] * self.rays
        step = 1e-4
        moved = projected(self.rays + step * across, self.camera.K) - projected(self.axis, self.camera.K)
        return np.linalg.norm(moved, axis=-1) / step * np.abs(inverse - truth)


def line(renderer, places, truth, scene):
    stated, found, flagged, inside, of_views, found_of_views = [], [], [], [], [], []
    options = spherewalk.ViewOptions(scene=scene, sampling="bilinear", depth=True, trust=True)
    for pose, inverse_truth in truth.pictures:
        view = renderer.render(truth.camera, pose, options)
        inverse = 0 if view.depth is None else 1 / (view.depth.astype(float) * truth.length)
        off = truth.displacement(spherewalk.pose_matrix(pose), places[view.report.photo], inverse, inverse_truth)
        known = np.isfinite(inverse_truth)
        stated.append(view.error_px[known])
        found.append(off[known])
        flagged.append((view.flags[known] & (spherewalk.PixelFlag.FILLED | spherewalk.PixelFlag.UNSURE)) != 0)
        inside.append(rank_correlation(stated[-1][::7], found[-1][::7]))
        of_views.append(view.report.parallax_px)
        found_of_views.append(np.median(found[-1]))
    stated, found, flagged = (np.concatenate(values) for values in (stated, found, flagged))
    worse = [np.mean(found[stated < e] > 2 * e) if (stated < e).any() else 0 for e in (0.5, 1, 2, 5)]
    bad = found > 10
    return [np.mean(inside), rank_correlation(np.array(of_views), np.array(found_of_views)),
            np.median(stated / np.maximum(found, 1e-3)), *worse, np.mean(flagged[bad]) if bad.any() else 1, np.mean(flagged)]


def main():
    truth = Truth(spherewalk.Camera.read(sys.argv[1]), pathlib.Path(sys.argv[2]))
    print("| " + " | ".join(NAMES) + " |\n|" + "---|" * len(NAMES))
    for folder in sys.argv[3:]:
        dataset = spherewalk.Dataset.open(folder)
        renderer = spherewalk.Renderer(dataset)
        places = [photo.room_from_photo[:3, 3] for photo in dataset.photos]
        for scene in dataset.scenes:
            print(f"| {pathlib.Path(folder).stem} | {scene} | "
                  + " | ".join(f"{value:.2f}" for value in line(renderer, places, truth, scene)) + " |", flush=True)


if __name__ == "__main__":
    main()
