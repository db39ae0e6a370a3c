# SPDX-License-Identifier: GPL-3.0-or-later
"""Hard surveys with rough positions, through the real command line: the table of resources/docs/testing.md.

    python3 hard_surveys.py CLI [--surveys N] [--first SEED] [--width PIXELS] [--jobs N] [--minutes N] [--unsaid]

Each seed carries a practice camera with the flaws of a real one through a practice room: 8 to 40 photos, steps of 0.2 to 1.5 m, a
camera that leans by up to 10 degrees (two standard deviations), and positions that are known to 3 cm. It imports the photos,
aligns them, and compares with the truth. A photo is wrong by more than 2 degrees; it is missed if nothing names it. It is right
within 0.1 degree, beside what all photos are turned by together. z is an error over its stated standard deviation.
"""

import argparse
import concurrent.futures
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from free_surveys import LENS_M, WAY, Camera, matrix, mean_square, product, transposed

WRONG_DEG = 2.0
RIGHT_DEG = 0.1
TAG_SIGMA_M = 0.03
ROOMS = {"lively": (5, 4), "bare": (5, 4), "flat": (8, 6)}
# Up and down a room in lines, in shares of its floor.
LINES = ((0.22, 0.27), (0.78, 0.27), (0.78, 0.43), (0.22, 0.43), (0.22, 0.58), (0.78, 0.58), (0.78, 0.73), (0.22, 0.73))


def places(dice, room, count, step):
    """Along the way and back, until there are enough. Nobody treads on the same spot twice."""
    size = ROOMS[room]
    corners = [(x * size[0], y * size[1]) for x, y in (WAY if room == "flat" else LINES)]
    corners += corners[-2:0:-1]
    found, at, leg = [], corners[0], 1
    while len(found) < count:
        found.append((at[0] + dice.uniform(-0.12, 0.12), at[1] + dice.uniform(-0.12, 0.12), LENS_M + dice.gauss(0, 0.02)))
        left = step * dice.uniform(0.8, 1.2)
        while left > 0:
            target = corners[leg % len(corners)]
            way = math.dist(at, target)
            share = min(1, left / way) if way > 0 else 1
            at = tuple(a + share * (b - a) for a, b in zip(at, target))
            left -= way
            leg += share == 1
    return found


def length(vector):
    return math.sqrt(sum(value * value for value in vector))


def turn_of(m):
    """The turn vector of a small or large rotation, degrees."""
    angle = math.acos(min(1, max(-1, (m[0][0] + m[1][1] + m[2][2] - 1) / 2)))
    axis = (m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1])
    size = length(axis)
    return [math.degrees(angle) * value / size if size > 0 else 0 for value in axis]


def median(values):
    return sorted(values)[len(values) // 2]


def turned(vector):
    """The rotation of a turn vector, degrees."""
    angle = math.radians(length(vector))
    half = math.sin(angle / 2) / angle if angle > 0 else 0.5
    return matrix(math.cos(angle / 2), *(math.radians(value) * half for value in vector))


def judged(report, truth):
    """What all photos are turned by together, degrees about x, y, z, and what each is turned by beside it."""
    photos = []
    for photo in report["photos"]:
        name = next(name for name in truth if photo["file"].startswith(name))
        q = photo["roomFromPhoto"]
        if q is not None:
            photos.append((name, photo, product(matrix(q["w"], q["x"], q["y"], q["z"]), transposed(truth[name]))))
    believed = [off for _, photo, off in photos if photo["status"] == "good"] or [off for _, _, off in photos]
    common = [median([turn_of(off)[k] for off in believed]) for k in range(3)] if believed else [0, 0, 0]
    back = transposed(turned(common))
    rows = []
    for name, photo, off in photos:
        own = turn_of(product(back, off))
        sigma = photo["sigma_deg"]
        rows.append({"file": name, "status": photo["status"], "flags": photo["flags"], "own_deg": length(own), "yaw_deg": own[2],
                     "off_deg": length(turn_of(off)), "yaw_sigma_deg": sigma and sigma["yaw"],
                     "own_sigma_deg": photo["sigma_own"] and photo["sigma_own"]["turn_deg"]})
    return common, rows


def survey(cli, seed, width, stated):
    dice = random.Random(seed)
    room = sorted(ROOMS)[seed % len(ROOMS)]
    step, count, lean = dice.uniform(0.2, 1.5), dice.randint(8, 40), dice.uniform(0.5, 5)
    with tempfile.TemporaryDirectory(prefix="hard-") as name:
        folder = pathlib.Path(name)
        (folder / "in").mkdir()
        camera = Camera(cli, folder, room, seed, width, lean, ["--real"])
        for i, at in enumerate(places(dice, room, count, step)):
            (folder / "in" / f"F{i:03}.JPG").write_bytes(camera.photo(*at))
        truth, tags = {}, ["file,x_m,y_m,z_m"]
        for i, line in enumerate(camera.end()):
            q = line["roomFromPhoto"]
            truth[f"F{i:03}"] = matrix(q["w"], q["x"], q["y"], q["z"])
            tags.append(f"F{i:03}.JPG," + ",".join(f"{value + dice.gauss(0, TAG_SIGMA_M):.4f}" for value in line["position_m"]))
        (folder / "tags.csv").write_text("\n".join(tags) + "\n")
        taken = folder / "s.spherewalk"
        size = ROOMS[room]
        for command in (["new", taken, "--rect", f"0,0,{size[0]},{size[1]}", "--ceiling", "2.6", "--step", "1", "--height", LENS_M],
                        ["import", taken, "--photos", folder / "in", "--positions", folder / "tags.csv", "--tolerance", "0"]):
            done = subprocess.run([cli, *map(str, command)], capture_output=True, text=True)
            if done.returncode != 0:
                raise RuntimeError(f"seed {seed}: {command[0]}: {done.stderr}")
        begin = time.monotonic()
        done = subprocess.run([cli, "align", str(taken), *stated, "--threads", "1", "--json"], capture_output=True, text=True)
        if not done.stdout:
            raise RuntimeError(f"seed {seed}: align: {done.stderr}")
    report = json.loads(done.stdout)
    common, rows = judged(report, truth)
    return {"seed": seed, "room": room, "step_m": step, "photos": count, "lean_deg": lean, "common_deg": common, "rows": rows,
            "seconds": time.monotonic() - begin,
            **{key: report[key] for key in ("sigma_common_lean_deg", "sigma_common_yaw_deg", "model", "warnings")}}


def is_right(row):
    return row["own_deg"] <= RIGHT_DEG


def printed(found):
    rows = found["rows"]
    good = [row for row in rows if row["status"] == "good"]
    right = [row for row in rows if is_right(row)]
    worst = f"{max(row['own_deg'] for row in good):.2f}" if good else "-"
    cells = [found["seed"], found["room"], f"{found['step_m']:.2f}", found["photos"], len(good), len(right),
             sum(row["status"] == "good" for row in right), worst, f"{found['common_deg'][2]:.2f}",
             f"{length(found['common_deg'][:2]):.2f}", f"{found['seconds']:.0f}",
             " ".join(row["file"] for row in good if row["off_deg"] > WRONG_DEG)]
    return "| " + " | ".join(map(str, cells)) + " |"


def share(part, whole):
    return f"{100 * part / whole:.1f} % of {whole}" if whole else "none"


def print_z(name, values):
    if values:
        print(f"z of {name}: {share(sum(abs(value) <= 1 for value in values), len(values))} within 1, "
              f"{share(sum(abs(value) <= 3 for value in values), len(values))} within 3, "
              f"worst {max(map(abs, values)):.1f}, RMS {math.sqrt(mean_square(values)):.2f}")


def summed(all_found):
    rows = [row for found in all_found for row in found["rows"]]
    good = [row for row in rows if row["status"] == "good"]
    right = [row for row in rows if is_right(row)]
    print(f"\nSurveys: {len(all_found)}. Photos: {sum(found['photos'] for found in all_found)}, good: {len(good)}.")
    print(f"Good of those right to {RIGHT_DEG} degree: {share(sum(row['status'] == 'good' for row in right), len(right))}.")
    print_z("own yaw, good photos", [row["yaw_deg"] / row["yaw_sigma_deg"] for row in good if row["yaw_sigma_deg"]])
    stated = [found for found in all_found if found["sigma_common_lean_deg"]]
    print_z("common lean, each axis", [found["common_deg"][k] / found["sigma_common_lean_deg"] for found in stated for k in (0, 1)])
    print_z("common yaw", [found["common_deg"][2] / found["sigma_common_yaw_deg"] for found in stated])
    missed = sum(row["off_deg"] > WRONG_DEG for row in good)
    print(f"Wrong: {sum(row['off_deg'] > WRONG_DEG for row in rows)}. Missed: {missed}.")
    return missed


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("cli")
    options.add_argument("--surveys", type=int, default=100)
    options.add_argument("--first", type=int, default=1)
    options.add_argument("--width", type=int, default=2048)
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--minutes", type=float, default=24 * 60, help="no survey begins later")
    options.add_argument("--unsaid", action="store_true", help="align is not told how well the positions are known")
    options.add_argument("--rows", type=pathlib.Path, help="JSON file for every photo's errors")
    given = options.parse_args()
    print("| seed | room | step m | photos | good | right | good of right | worst deg | common yaw | common lean | s | missed |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    end, all_found = time.monotonic() + 60 * given.minutes, []

    def one(seed):
        return survey(given.cli, seed, given.width, [] if given.unsaid else ["--position-sigma", str(TAG_SIGMA_M)]) if time.monotonic() < end else None

    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for done in concurrent.futures.as_completed(pool.submit(one, given.first + i) for i in range(given.surveys)):
            found = done.result()
            if found:
                all_found.append(found)
                print(printed(found), flush=True)
                if given.rows:
                    given.rows.write_text(json.dumps(all_found))
    return 1 if summed(all_found) else 0


if __name__ == "__main__":
    sys.exit(main())
