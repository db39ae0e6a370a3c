# SPDX-License-Identifier: GPL-3.0-or-later
"""Surveys by hand without any position, through the real command line: the table of resources/docs/testing.md.

    python3 free_surveys.py CLI [--surveys N] [--first SEED] [--photos N] [--width PIXELS] [--unrelated FOLDER] [--real]

Each seed walks through the two rooms of the practice flat with steps of 0.3 to 1.5 m and a camera that leans in the hand, and adds
a tenth of photos of another place: those of FOLDER, else of another practice room. All practice rooms have the same furniture, so
that one is the harder test: only what stands around the furniture tells it from the flat. With --real the camera has a real one's
flaws, two lenses among them. It imports the photos without positions, aligns them with --positions free, and compares with
the truth after the best common motion and scale of the photos that nothing names: "deg" are turns after the motion that fits the
places best, "own deg" after the common turn that fits the turns best. A photo is wrong by more than 5 cm or 1 degree; it is missed
if nothing names it.
"""

import argparse
import json
import math
import pathlib
import random
import re
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request

WRONG_M = 0.05
WRONG_DEG = 1.0
LENS_M = 1.5
# Through both rooms and their doors, in shares of a flat of 7 x 5.5 m and above: (x, y).
WAY = ((0.12, 0.85), (0.38, 0.85), (0.38, 0.5), (0.12, 0.5), (0.25, 0.4), (0.25, 0.13), (0.75, 0.13), (0.75, 0.4), (0.62, 0.55),
       (0.62, 0.8), (0.85, 0.75), (0.85, 0.5))


class Camera:
    """A practice camera that is carried about."""

    def __init__(self, cli, folder, room, seed, width, tilt, more=()):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.truth = folder / f"{room}.jsonl"
        self.process = subprocess.Popen(
            [cli, "practice-camera", "--port", str(self.port), "--time-scale", "0", "--room", room, "--seed", str(seed), "--width",
             str(width), "--tilt", str(tilt), "--truth", str(self.truth), *more], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 60
        while not self.answers():
            if time.monotonic() > deadline or self.process.poll() is not None:
                raise RuntimeError("The practice camera does not answer.")

    def answers(self):
        try:
            self.ask("/practice/pose")
            return True
        except OSError:
            return False

    def ask(self, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", data, {"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            return answer.read()

    def photo(self, x, y, z):
        self.ask("/practice/pose", {"x": x, "y": y, "z": z})
        state = json.loads(self.ask("/osc/commands/execute", {"name": "camera.takePicture"}))
        while state["state"] == "inProgress":
            state = json.loads(self.ask("/osc/commands/status", {"id": state["id"]}))
        url = state["results"]["fileUrl"]
        return self.ask(url[url.index("/", 8):])

    def end(self):
        self.process.terminate()
        self.process.wait()
        return [json.loads(line) for line in self.truth.read_text().splitlines()]


def places(dice, size, count):
    """Along the way and back, until there are enough."""
    corners = [(x * size[0], y * size[1]) for x, y in WAY]
    corners += corners[-2:0:-1]
    found, at, leg = [], corners[0], 1
    while len(found) < count:
        found.append((at[0] + dice.gauss(0, 0.03), at[1] + dice.gauss(0, 0.03), LENS_M + dice.gauss(0, 0.02)))
        step = dice.uniform(0.3, 1.5)
        while step > 0:
            target = corners[leg % len(corners)]
            left = math.dist(at, target)
            share = min(1, step / left) if left > 0 else 1
            at = (at[0] + share * (target[0] - at[0]), at[1] + share * (target[1] - at[1]))
            step -= left
            leg += share == 1
    return found


def matrix(w, x, y, z):
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


def times(m, v):
    return [sum(m[i][k] * v[k] for k in range(len(v))) for i in range(len(m))]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def transposed(m):
    return [list(row) for row in zip(*m)]


def mean(points):
    return [sum(point[k] for point in points) / len(points) for k in range(3)]


def similarity(made, true):
    """Scale, turn and middles that bring made to true. Source: Horn 1987, closed form with quaternions."""
    mean_made, mean_true = mean(made), mean(true)
    a = [[p[k] - mean_made[k] for k in range(3)] for p in made]
    b = [[p[k] - mean_true[k] for k in range(3)] for p in true]
    s = [[sum(p[i] * q[j] for p, q in zip(a, b)) for j in range(3)] for i in range(3)]
    n = [[s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]],
         [s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]],
         [s[2][0] - s[0][2], s[0][1] + s[1][0], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]],
         [s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], s[2][2] - s[0][0] - s[1][1]]]
    shift = sum(abs(value) for row in n for value in row)
    q = [1.0, 0.3, 0.2, 0.1]
    for _ in range(5000):  # the eigenvector of the greatest eigenvalue, by powers
        q = [value + shift * old for value, old in zip(times(n, q), q)]
        length = math.sqrt(sum(value * value for value in q))
        q = [value / length for value in q]
    turn = matrix(*q)
    scale = sum(t * r for p, o in zip(a, b) for t, r in zip(times(turn, p), o)) / sum(v * v for p in a for v in p)
    return scale, turn, mean_made, mean_true


def name_before(file):
    """The name that a photo had before it was imported, which adds a part of its digest."""
    return re.sub(r"_[0-9a-f]{8}(?=\.)", "", file)


def turn_error(apart):
    return math.degrees(math.acos(min(1, max(-1, (apart[0][0] + apart[1][1] + apart[2][2] - 1) / 2))))


def about_their_mean(turns):
    """The small turns in degrees, without what all have in common."""
    vectors = [[math.degrees(t[k - 1][k - 2] - t[k - 2][k - 1]) / 2 for k in range(3)] for t in turns]
    common = mean(vectors)
    return [math.dist(vector, common) for vector in vectors]


def mean_square(values):
    return sum(value * value for value in values) / len(values)


def judged(report, truth, unrelated):
    """The errors of all photos of the place, and what was missed."""
    solved, named, errors = {}, set(), {}
    for photo in report["photos"]:
        name = name_before(photo["file"])
        if photo["status"] == "good":
            solved[name] = photo
        else:
            named.add(name)
            if photo["status"] == "doubtful":
                solved[name] = photo
    here = sorted(name for name in solved if name in truth)
    result = {"photos": len(truth), "placed": len(here), "named": len(named - unrelated), "unrelated": len(unrelated),
              "unrelated_missed": len(unrelated - named), "seconds": report["seconds"], "missed": [],
              "stated": report["places"]["scale_sigma"]}
    trusted = [name for name in here if name not in named]
    if len(trusted) < 3:
        return result
    scale, turn, mean_made, mean_true = similarity([solved[name]["position_m"] for name in trusted],
                                                   [truth[name][0] for name in trusted])
    for name in here:
        one, other = solved[name]["position_m"], truth[name][0]
        there = times(turn, [one[k] - mean_made[k] for k in range(3)])
        metres = math.dist([scale * value for value in there], [other[k] - mean_true[k] for k in range(3)])
        q = solved[name]["roomFromPhoto"]
        apart = product(product(turn, matrix(q["w"], q["x"], q["y"], q["z"])), transposed(truth[name][1]))
        degrees = turn_error(apart)
        errors[name] = (metres, degrees, apart)
        if (metres > WRONG_M or degrees > WRONG_DEG) and name not in named:
            result["missed"].append(name)
    off, turned, turns = zip(*(errors[name] for name in trusted))
    result.update(scale=scale, rms_mm=1000 * math.sqrt(mean_square(off)), worst_mm=1000 * max(off),
                  rms_deg=math.sqrt(mean_square(turned)), worst_deg=max(turned),
                  own_deg=math.sqrt(mean_square(about_their_mean(turns))))
    return result


def survey(cli, seed, count, width, foreign, flaws):
    dice = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="free-") as name:
        folder = pathlib.Path(name)
        (folder / "in").mkdir()
        truth, unrelated = {}, set()
        strangers = max(1, round(count / 10))
        flat = Camera(cli, folder, "flat", seed, width, 5, flaws)
        for at in places(dice, (8, 6), count - strangers):
            (folder / "in" / f"F{len(truth):03}.JPG").write_bytes(flat.photo(*at))
            truth[f"F{len(truth):03}.JPG"] = None
        for name, line in zip(sorted(truth), flat.end()):
            turned = line["roomFromPhoto"]
            truth[name] = (line["position_m"], matrix(*(turned[key] for key in "wxyz")))
        elsewhere = None if foreign else Camera(cli, folder, "bare" if seed % 2 else "lively", seed + 1000, width, 5, flaws)
        for i in range(strangers):
            name = f"E{i:03}.JPG"
            (folder / "in" / name).write_bytes(foreign[(seed + i) % len(foreign)].read_bytes() if foreign else
                                               elsewhere.photo(dice.uniform(1, 3), dice.uniform(1, 3), LENS_M))
            unrelated.add(name)
        if elsewhere:
            elsewhere.end()
        room = folder / "s.spherewalk"
        for command in (["new", room, "--rect", "0,0,8,6", "--ceiling", "2.6", "--step", "1", "--height", str(LENS_M)],
                        ["import", room, "--photos", folder / "in"]):
            subprocess.run([cli, *map(str, command)], check=True, capture_output=True)
        done = subprocess.run([cli, "align", str(room), "--positions", "free", "--json"], capture_output=True, text=True)
        return judged(json.loads(done.stdout), truth, unrelated)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("cli")
    options.add_argument("--surveys", type=int, default=100)
    options.add_argument("--first", type=int, default=1)
    options.add_argument("--photos", type=int, default=40)
    options.add_argument("--width", type=int, default=2048)
    options.add_argument("--unrelated", type=pathlib.Path)
    options.add_argument("--real", action="store_const", const=["--real"], default=[])
    given = options.parse_args()
    foreign = sorted(given.unrelated.glob("*.[jJ][pP]*[gG]")) if given.unrelated else []
    print("| seed | photos | placed | named | unrelated missed | RMS mm | worst mm | RMS deg | worst deg | own deg | scale | stated | s "
          "| missed |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    missed = 0
    for seed in range(given.first, given.first + given.surveys):
        row = survey(given.cli, seed, given.photos, given.width, foreign, given.real)
        missed += len(row["missed"]) + row["unrelated_missed"]
        cells = [seed, row["photos"], row["placed"], row["named"], row["unrelated_missed"]]
        figures = ("rms_mm", "worst_mm", "rms_deg", "worst_deg", "own_deg", "scale", "stated")
        cells += [f"{row[key]:.4g}" if key in row else "-" for key in figures]
        print("| " + " | ".join(map(str, cells + [f"{row['seconds']:.0f}", " ".join(row["missed"])])) + " |", flush=True)
    print(f"\nMissed: {missed}.")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
