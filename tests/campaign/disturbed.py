# SPDX-License-Identifier: GPL-3.0-or-later
"""A robot's pictures with wrong poses and wrong colours, and how well `compare` mends the poses: the tables of
resources/docs/figures.md, "Against the robot's pictures".

    python3 disturbed.py make TRUE.csv FOLDER [--seed SEED]
    python3 disturbed.py errors TRUE.csv POSES.csv

"make" writes FOLDER/disturbed.csv and FOLDER/cast.csv. In the first, each pose is turned by 2 degrees and moved by 5 cm, about
and along random directions. In the second, the poses are true, and the pictures have a cast. "errors" compares the poses that
`compare --refine-poses --poses POSES.csv` wrote with the true ones, picture by picture.
"""

import argparse
import csv
import pathlib

import numpy as np
from PIL import Image

TURN_DEG = 2
MOVE_M = 0.05
MIX = np.array([[0.72, 0.1, 0], [0.04, 0.85, 0.05], [0, 0.08, 0.98]])
POWER = 1.25
NOISE = 0.5  # of a level


def read(file):
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def write(file, rows):
    with open(file, "w", newline="") as lines:
        writer = csv.DictWriter(lines, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def position(row):
    return np.array([float(row[name]) for name in ("x_m", "y_m", "z_m")])


def quaternion(row):
    return np.array([float(row[name]) for name in ("qw", "qx", "qy", "qz")])


def product(a, b):
    w, v = a[0] * b[0] - a[1:] @ b[1:], a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])
    return np.array([w, *v])


def direction(rng):
    way = rng.normal(size=3)
    return way / np.linalg.norm(way)


def disturbed(row, rng):
    half = np.radians(TURN_DEG) / 2
    turned = product(np.array([np.cos(half), *(np.sin(half) * direction(rng))]), quaternion(row))
    moved = position(row) + MOVE_M * direction(rng)
    return row | dict(zip(("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"), (*moved, *turned)))


def cast(picture, rng):
    values = np.clip((picture / 255) @ MIX.T, 0, 1) ** POWER * 255
    return np.clip(np.round(values + NOISE * rng.normal(size=values.shape)), 0, 255).astype(np.uint8)


def make(options):
    source = options.true.parent
    options.folder.mkdir(parents=True)
    rows = [row | {"file": str((source / row["file"]).resolve())} for row in read(options.true)]
    for row in rows:
        row.pop("depth", None)  # which `compare` does not need
    rng = np.random.default_rng(options.seed)
    write(options.folder / "disturbed.csv", [disturbed(row, rng) for row in rows])
    for row in rows:
        name = pathlib.Path(row["file"]).stem + ".png"
        picture = np.asarray(Image.open(row["file"]).convert("RGB"))
        Image.fromarray(cast(picture, rng)).save(options.folder / name)
        row["file"] = name
    write(options.folder / "cast.csv", rows)


def angle_deg(a, b):
    return np.degrees(2 * np.arccos(min(1, abs(quaternion(a) @ quaternion(b)))))


def errors(options):
    true = {pathlib.Path(row["file"]).name: row for row in read(options.true)}
    found = {pathlib.Path(row["file"]).name: row for row in read(options.poses)}
    for what, unit, of in (("position", "mm", lambda a, b: 1000 * np.linalg.norm(position(a) - position(b))),
                           ("rotation", "degrees", angle_deg)):
        off = [of(true[name], row) for name, row in found.items()]
        print(f"{what}: median {np.median(off):.3g}, 9 in 10 {np.quantile(off, 0.9):.3g}, worst {max(off):.3g} {unit} "
              f"of {len(off)} pictures")


def main():
    parser = argparse.ArgumentParser()
    commands = parser.add_subparsers(required=True)
    making = commands.add_parser("make")
    making.add_argument("true", type=pathlib.Path)
    making.add_argument("folder", type=pathlib.Path)
    making.add_argument("--seed", type=int, default=5)
    making.set_defaults(run=make)
    comparing = commands.add_parser("errors")
    comparing.add_argument("true", type=pathlib.Path)
    comparing.add_argument("poses", type=pathlib.Path)
    comparing.set_defaults(run=errors)
    options = parser.parse_args()
    options.run(options)


if __name__ == "__main__":
    main()
