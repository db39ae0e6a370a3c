# SPDX-License-Identifier: GPL-3.0-or-later
"""Surveys whose position tags are rough, through the real command line: the table of resources/docs/figures.md.

    python3 rough_tags.py CLI [--surveys N] [--first SEED] [--photos N] [--width PIXELS] [--real]

Each seed walks through the practice flat as free_surveys.py does. The tags are off by 0.1, 0.3 and 0.5 m (one standard deviation
along x and along y), and `--position-sigma` says so. Turns are compared with the truth after the best common turn of the photos
that nothing names. A photo is wrong by more than 0.5 degrees; it is missed if nothing names it.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import free_surveys

OFF_M = (0.1, 0.3, 0.5)
WRONG_DEG = 0.5


def taken(cli, folder, seed, count, width, flaws):
    """Photos of the flat, and the true position and rotation of each."""
    dice = random.Random(seed)
    camera = free_surveys.Camera(cli, folder, "flat", seed, width, 5, flaws)
    names = [f"F{i:03}.JPG" for i in range(count)]
    for name, at in zip(names, free_surveys.places(dice, (8, 6), count)):
        (folder / "in" / name).write_bytes(camera.photo(*at))
    return {name: (line["position_m"], free_surveys.matrix(*(line["roomFromPhoto"][key] for key in "wxyz")))
            for name, line in zip(names, camera.end())}


def aligned(cli, folder, truth, off_m, dice):
    room = folder / f"{off_m}.spherewalk"
    tags = folder / "tags.csv"
    rows = [f"{name},{x + dice.gauss(0, off_m)},{y + dice.gauss(0, off_m)},{z}" for name, ((x, y, z), _) in truth.items()]
    tags.write_text("\n".join(["file,x_m,y_m,z_m", *rows]) + "\n")
    for command in (["new", room, "--rect=-2,-2,10,8", "--ceiling", "2.6", "--step", "9", "--height", str(free_surveys.LENS_M)],
                    ["import", room, "--photos", folder / "in", "--positions", tags, "--move"]):
        subprocess.run([cli, *map(str, command)], check=True, capture_output=True)
    done = subprocess.run([cli, "align", str(room), "--position-sigma", str(off_m), "--json"], capture_output=True, text=True)
    return json.loads(done.stdout)


def turn_errors(report, truth):
    """Degrees by which each aligned photo is turned wrong, after the best common turn of the good ones."""
    solved = {free_surveys.name_before(photo["file"]): (photo["status"], free_surveys.matrix(*(photo["roomFromPhoto"][key] for key in "wxyz")))
              for photo in report["photos"] if photo["status"] != "failed"}
    trusted = [name for name, (status, _) in solved.items() if status == "good"] or list(solved)

    def ends(turned):  # of the axes, on both sides, so that their mean is zero
        return [[sign * row[axis] for row in turned] for axis in range(3) for sign in (1, -1)]

    _, turn, _, _ = free_surveys.similarity([end for name in trusted for end in ends(solved[name][1])],
                                            [end for name in trusted for end in ends(truth[name][1])])
    errors = {}
    for name, (_, turned) in solved.items():
        apart = free_surveys.product(free_surveys.product(turn, turned), free_surveys.transposed(truth[name][1]))
        errors[name] = math.degrees(math.acos(min(1, max(-1, (apart[0][0] + apart[1][1] + apart[2][2] - 1) / 2))))
    return {name: errors[name] for name in trusted if solved[name][0] == "good"}, errors


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("cli")
    options.add_argument("--surveys", type=int, default=3)
    options.add_argument("--first", type=int, default=1)
    options.add_argument("--photos", type=int, default=36)
    options.add_argument("--width", type=int, default=2048)
    options.add_argument("--real", action="store_const", const=["--real"], default=[])
    given = options.parse_args()
    print("| seed | tags off by | good | doubtful | failed | RMS deg | worst deg | of all | missed |\n|---|---|---|---|---|---|---|---|---|")
    missed = 0
    for seed in range(given.first, given.first + given.surveys):
        with tempfile.TemporaryDirectory(prefix="rough-") as name:
            folder = pathlib.Path(name)
            (folder / "in").mkdir()
            truth = taken(given.cli, folder, seed, given.photos, given.width, given.real)
            for off_m in OFF_M:
                report = aligned(given.cli, folder, truth, off_m, random.Random(seed + 1000))
                stands = [photo["status"] for photo in report["photos"]]
                good, errors = turn_errors(report, truth)
                wrong = sorted(name for name in good if good[name] > WRONG_DEG)
                missed += len(wrong)
                cells = [seed, f"{off_m} m", *(stands.count(status) for status in ("good", "doubtful", "failed"))]
                cells += [f"{value:.2g}" for value in (math.sqrt(free_surveys.mean_square(good.values() or [0])),
                                                       max(good.values(), default=0), max(errors.values()))]
                print("| " + " | ".join(map(str, cells + [" ".join(wrong)])) + " |", flush=True)
    print(f"\nMissed: {missed}.")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
