# SPDX-License-Identifier: GPL-3.0-or-later
"""Surveys of a room with AprilTags, through the real command line.

    python3 tagged_surveys.py CLI [--surveys N] [--first SEED] [--photos N] [--tags N] [--width PIXELS] [--focal PIXELS]

Each seed carries a camera with the flaws of a real one through the practice room on two days, and aligns both days without
positions. The second day takes over the frame of the first by the tags. Pictures of a robot that stands two metres from a tag are
then compared with the dataset of the first day, without their poses. All errors are against the truth, and nothing is scaled. The
frame of the first day is the rigid motion that brings the truth to it best.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

from free_surveys import LENS_M, Camera, matrix, mean_square, name_before, product, similarity, times, transposed

ROOM_M = (5, 4)
TAG_M = 0.16
AWAY_M = 2
ASIDE_DEG = (-50, -35, -20, 0, 20, 35, 50)
BODY_FROM_OPTICAL = [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]


def command(cli, *words):
    done = subprocess.run([cli, *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, words))}: {done.stderr}")
    return done.stdout


def matrix_of(q):
    return matrix(q["w"], q["x"], q["y"], q["z"])


def day(given, folder, name, seed, more):
    """Carries the camera about and aligns its photos. Returns the report, and the true poses of its photos."""
    dice = random.Random(seed)
    (folder / name).mkdir()
    camera = Camera(given.cli, folder, "lively", seed, given.width, 5, ["--real", *tags_of(given), "--tags-truth",
                                                                              str(folder / "tags.json")])
    for i in range(given.photos):
        across, along = i % 4 + dice.uniform(0.2, 0.8), i // 4 + dice.uniform(0.2, 0.8)
        at = (1.2 + 2.6 * across / 4, 1.1 + 1.8 * along / math.ceil(given.photos / 4), LENS_M + dice.gauss(0, 0.02))
        (folder / name / f"F{i:03}.JPG").write_bytes(camera.photo(*at))
    truth = {f"F{i:03}.JPG": (line["position_m"], matrix_of(line["roomFromPhoto"])) for i, line in enumerate(camera.end())}
    camera.truth.unlink()
    survey = folder / f"{name}.spherewalk"
    command(given.cli, "new", survey, "--rect", f"0,0,{ROOM_M[0]},{ROOM_M[1]}", "--ceiling", "2.6", "--step", "1", "--height", LENS_M)
    command(given.cli, "import", survey, "--photos", folder / name)
    report = command(given.cli, "align", survey, "--positions", "free", "--tag-size", TAG_M, "--json", *more)
    return survey, json.loads(report), truth


def tags_of(given):
    return ["--tags", str(given.tags), "--tag-size", str(TAG_M)]


def places(report, truth):
    good = [photo for photo in report["photos"] if photo["status"] in ("good", "doubtful")]
    return [photo["position_m"] for photo in good], [truth[name_before(photo["file"])][0] for photo in good]


def frame(report, truth):
    """The rigid motion from the true room to the report's frame, and true lengths over the report's."""
    made, true = places(report, truth)
    scale = similarity(made, true)[0]
    _, turn, mean_true, mean_made = similarity(true, made)
    return (lambda p: [a + b for a, b in zip(times(turn, [p[k] - mean_true[k] for k in range(3)]), mean_made)]), turn, scale


def stands(given, tags):
    """Where a robot stands, and how it looks: position, matrix of its body, the tag's number, and the angle aside."""
    found = []
    for tag in tags:
        corners = tag["corners_m"]
        centre = [sum(corner[k] for corner in corners) / 4 for k in range(3)]
        across = [corners[1][k] - corners[0][k] for k in range(3)]
        facing = math.atan2(-across[0], across[1])
        for aside in ASIDE_DEG:
            heading = facing + math.radians(aside)
            at = [centre[0] + AWAY_M * math.cos(heading), centre[1] + AWAY_M * math.sin(heading), centre[2] - 0.2]
            if all(0.4 < at[k] < ROOM_M[k] - 0.4 for k in range(2)):
                yaw = heading + math.pi + 0.12
                found.append((at, yaw, tag["number"], aside))
    return found


def registered(given, folder, survey, to_frame, turn):
    """The errors of a robot's pictures by their tags: aside, number of tags, millimetres, degrees."""
    width, height = round(given.focal * 16 / 13), round(given.focal * 12 / 13)
    (folder / "robot.yaml").write_text(f"image_width: {width}\nimage_height: {height}\ncamera_matrix: {{data: [{given.focal}, 0, "
                                       f"{(width - 1) / 2}, 0, {given.focal}, {(height - 1) / 2}, 0, 0, 1]}}\n")
    robots = stands(given, json.loads((folder / "tags.json").read_text()))
    (folder / "path.tum").write_text("".join(f"{i} {x} {y} {z} 0 0 {math.sin(yaw / 2)} {math.cos(yaw / 2)}\n"
                                             for i, ((x, y, z), yaw, _, _) in enumerate(robots)))
    command(given.cli, "practice-pictures", folder / "robot", "--camera", folder / "robot.yaml", "--path", folder / "path.tum",
            "--frame", "body", "--room", "lively", *tags_of(given))
    names = [line.split(",")[0] for line in (folder / "robot/pictures.csv").read_text().splitlines()[1:]]
    (folder / "robot/bare.csv").write_text("file\n" + "".join(name + "\n" for name in names))
    command(given.cli, "export", survey, folder / "dataset", "--scene", "sphere")
    report = json.loads(command(given.cli, "compare", folder / "dataset", "--camera", folder / "robot.yaml", "--pictures",
                                folder / "robot/bare.csv", "--json"))
    rows = []
    for (at, yaw, number, aside), one in zip(robots, report["registered"]):
        if one["why"]:
            rows.append((aside, 0, None, None))
            continue
        body = matrix(math.cos(yaw / 2), 0, 0, math.sin(yaw / 2))
        true = product(turn, product(body, BODY_FROM_OPTICAL))
        apart = product(matrix_of(one["pose"]["room_from_camera"]), transposed(true))
        degrees = math.degrees(math.acos(min(1, max(-1, (apart[0][0] + apart[1][1] + apart[2][2] - 1) / 2))))
        rows.append((aside, len(one["tags"]), 1000 * math.dist(one["pose"]["position_m"], to_frame(at)), degrees))
    return rows


def survey(given, seed):
    with tempfile.TemporaryDirectory(prefix="tagged-") as name:
        folder = pathlib.Path(name)
        first, one, truth = day(given, folder, "one", seed, [])
        to_frame, turn, scale = frame(one, truth)
        _, two, truth_two = day(given, folder, "two", seed + 1000, ["--tags-of", first])
        made, true = places(two, truth_two)
        off = [1000 * math.dist(m, to_frame(t)) for m, t in zip(made, true)]
        rows = registered(given, folder, first, to_frame, turn)
    made_one, true_one = places(one, truth)
    return {"tags": len(one["april_tags"]), "scale": 100 * (scale - 1), "stated": 100 * one["places"]["scale_sigma"],
            "rms_one": math.sqrt(mean_square([1000 * math.dist(m, to_frame(t)) for m, t in zip(made_one, true_one)])),
            "placed": len(made), "rms_two": math.sqrt(mean_square(off)), "worst_two": max(off), "rows": rows,
            "warnings": one["warnings"] + two["warnings"]}


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("cli")
    options.add_argument("--surveys", type=int, default=5)
    options.add_argument("--first", type=int, default=1)
    options.add_argument("--photos", type=int, default=12)
    options.add_argument("--tags", type=int, default=6)
    options.add_argument("--width", type=int, default=2048)
    options.add_argument("--focal", type=int, default=520)
    given = options.parse_args()
    print("| seed | tags placed | scale error % | stated % | first day, rigid, RMS mm | second day RMS mm | worst mm |")
    print("|---|---|---|---|---|---|---|")
    pictures = []
    for seed in range(given.first, given.first + given.surveys):
        found = survey(given, seed)
        pictures += found["rows"]
        print(f"| {seed} | {found['tags']} | {found['scale']:.2f} | {found['stated']:.2f} | {found['rms_one']:.1f} | "
              f"{found['rms_two']:.1f} | {found['worst_two']:.1f} |", flush=True)
        for warning in found["warnings"]:
            print(f"  {warning}", file=sys.stderr)
    print("\n| tags seen | degrees aside | pictures | median mm | worst mm | median deg | worst deg | within 10 mm and 0.3 deg |")
    print("|---|---|---|---|---|---|---|---|")
    for key in sorted({(row[1] > 1, abs(row[0])) for row in pictures if row[1]}):
        rows = [row for row in pictures if row[1] and (row[1] > 1, abs(row[0])) == key]
        metres, degrees = (sorted(row[k] for row in rows) for k in (2, 3))
        good = sum(row[2] <= 10 and row[3] <= 0.3 for row in rows)
        print(f"| {'more' if key[0] else 'one'} | {key[1]} | {len(rows)} | {metres[len(rows) // 2]:.1f} | {metres[-1]:.1f} | "
              f"{degrees[len(rows) // 2]:.2f} | {degrees[-1]:.2f} | {good} |")
    print(f"\nNot registered: {sum(not row[1] for row in pictures)} of {len(pictures)} pictures.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
