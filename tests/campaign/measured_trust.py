# SPDX-License-Identifier: GPL-3.0-or-later
"""What views say about their errors, beside what is true: the table of resources/docs/trust.md.

    python3 measured_trust.py [--photos TRUE.csv] ROBOT.yaml PICTURES.csv DATASET...

PICTURES.csv is the file that "measure --pictures" reads, with a column `depth`: a PNG of the true depth, z along the optical
axis in millimetres, 0 where it is not known. TRUE.csv is a positions file with the true poses of the photos, for datasets whose
poses were solved; without it the dataset's poses are the true ones. A second row of each scene model then leaves out what all
photos are turned, moved and scaled by together, which no photo knows.
"""

import argparse
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
            self.pictures.append((spherewalk.pose_matrix(pose), np.where(depth > 0, 1 / np.maximum(depth, 1e-3) / self.length, np.nan)))

    def moved(self, matrix, shift):
        """By how many pixels things at a distance of 1 move with this shift in the room; first order."""
        inCamera = shift @ matrix[:3, :3]
        across = inCamera - np.sum(self.rays * inCamera, -1, keepdims=True) * self.rays
        step = 1e-4
        return (projected(self.rays + step * across, self.camera.K) - projected(self.axis, self.camera.K)) / step

    def displacement(self, matrix, photo, true_photo, inverse, truth):
        """Of the thing at its true distance, seen where the view has it; first order in the error of 1 / distance."""
        place = matrix[:3, 3]
        things = place + (self.rays / truth[..., None]) @ matrix[:3, :3].T
        turn = photo[:3, :3] @ true_photo[:3, :3].T
        shown = photo[:3, 3] + (things - true_photo[:3, 3]) @ turn.T
        moved = (inverse - truth)[..., None] * self.moved(matrix, place - photo[:3, 3])
        return np.linalg.norm(moved + self.moved(matrix, (shown - things) * truth[..., None]), axis=-1)


class Together:
    """What the poses are turned, moved and scaled by together, which no photo knows."""

    def __init__(self, poses, true_poses):
        u, _, v = np.linalg.svd(sum(pose[:3, :3] @ truth[:3, :3].T for pose, truth in zip(poses, true_poses)))
        self.turn = u @ v
        places, true_places = (np.array([pose[:3, 3] for pose in all_poses]) for all_poses in (poses, true_poses))
        self.middle, self.true_middle = places.mean(0), true_places.mean(0)
        spread = (true_places - self.true_middle) @ self.turn.T
        self.growth = np.sum(spread * (places - self.middle)) / np.sum(spread * spread)

    def __call__(self, true_pose):
        pose = np.eye(4)
        pose[:3, :3] = self.turn @ true_pose[:3, :3]
        pose[:3, 3] = self.middle + self.growth * self.turn @ (true_pose[:3, 3] - self.true_middle)
        return pose


def line(renderer, poses, true_poses, pictures, truth, scene):
    stated, found, flagged, inside, of_views, found_of_views = [], [], [], [], [], []
    options = spherewalk.ViewOptions(scene=scene, sampling="bilinear", depth=True, trust=True)
    for pose, inverse_truth in pictures:
        view = renderer.render(truth.camera, pose, options)
        inverse = 0 if view.depth is None else 1 / (view.depth.astype(float) * truth.length)
        photo = view.report.photo
        off = truth.displacement(pose, poses[photo], true_poses[photo], inverse, inverse_truth)
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


def poses_of(table, photos):
    lines = {pathlib.PurePath(line["file"]).stem: line for line in csv.DictReader(open(table))}
    names = ("x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")
    return [spherewalk.pose_matrix([float(lines[pathlib.PurePath(photo.file).stem][name]) for name in names])
            for photo in photos]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--photos")
    parser.add_argument("robot")
    parser.add_argument("pictures", type=pathlib.Path)
    parser.add_argument("datasets", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    truth = Truth(spherewalk.Camera.read(arguments.robot), arguments.pictures)
    print("| " + " | ".join(NAMES) + " |\n|" + "---|" * len(NAMES))
    for folder in arguments.datasets:
        dataset = spherewalk.Dataset.open(folder)
        renderer = spherewalk.Renderer(dataset)
        poses = [photo.room_from_photo for photo in dataset.photos]
        rows = {"": (poses, truth.pictures)}
        if arguments.photos:
            true_poses = poses_of(arguments.photos, dataset.photos)
            moved = Together(poses, true_poses)
            rows[""] = (true_poses, truth.pictures)
            rows[", together"] = ([moved(pose) for pose in true_poses],
                                  [(moved(pose), inverse / moved.growth) for pose, inverse in truth.pictures])
        for scene in dataset.scenes:
            for what, (true_poses, pictures) in rows.items():
                row = line(renderer, poses, true_poses, pictures, truth, scene)
                print(f"| {folder.stem} | {scene}{what} | " + " | ".join(f"{value:.2f}" for value in row) + " |", flush=True)


if __name__ == "__main__":
    main()
