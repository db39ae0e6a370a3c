# SPDX-License-Identifier: GPL-3.0-or-later
"""Surveys with wrong position tags, through the real command line: the table of resources/docs/testing.md.

    python3 wrong_places.py CLI DATA [--surveys N] [--first SEED] [--kind KIND]

DATA is a folder with photos of a grid of 20 cm, and their true poses in truth.json. Each seed makes one survey of the photos
whose part is "dense" with one kind of fault, aligns and exports it, and compares the dataset with the truth.
"""

import argparse
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import motion_blur

KINDS = ("off", "swap", "scale", "stretch", "both", "mirror", "blur", "twice", "still", "bytes", "place", "mixed", "none")
OF_THE_WHOLE = ("scale", "stretch", "both", "mirror")
SOLVED_M = 0.015
WRONG_M = 0.030


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


class Survey:
    """The photos with one fault. tags: file to position; places: file to where it was truly taken."""

    def __init__(self, data, seed, kind, folder):
        self.seed, self.kind, self.folder = seed, kind, folder
        self.random = random.Random(seed)
        photos = [photo for photo in json.loads((data / "truth.json").read_text())["photos"] if photo["part"] == "dense"]
        self.truth = {pathlib.Path(photo["file"]).name: photo for photo in photos}
        self.files = sorted(self.truth)
        self.tags = {name: list(photo["nominal_position"]) for name, photo in self.truth.items()}
        self.wrong, self.blurred = set(), set()
        # Every second survey has no plan that fits: no station lies where a wrong photo was taken.
        self.rect, self.step = ([-0.3, -0.3, 1.1, 1.1], 0.2) if seed % 2 else ([5, 5, 7, 7], 0.5)
        (folder / "in").mkdir()
        for name in self.files:
            (folder / "in" / name).write_bytes((data / "photos" / name).read_bytes())
        getattr(self, "make_" + kind)(data)

    def pick(self, count):
        return self.random.sample(self.files, count)

    def make_none(self, data):
        pass

    def make_off(self, data):
        for name in self.pick(self.random.randint(1, 4)):
            angle, length = self.random.uniform(0, 2 * math.pi), self.random.uniform(0.05, 0.3)
            self.tags[name][0] += length * math.cos(angle)
            self.tags[name][1] += length * math.sin(angle)
            self.wrong.add(name)

    def make_swap(self, data):
        right = [name for name in self.files if name not in self.wrong]
        chosen = self.random.sample(right, 2 * self.random.randint(1, 2))
        for a, b in zip(chosen[::2], chosen[1::2]):
            self.tags[a], self.tags[b] = self.tags[b], self.tags[a]
        self.wrong.update(chosen)

    def scaled(self, x, y):
        for tag in self.tags.values():
            tag[0], tag[1] = tag[0] * x, tag[1] * y
        self.rect = [-0.3, -0.3, 0.3 + 0.8 * x, 0.3 + 0.8 * y]
        self.wrong.update(self.files)

    def factor(self):
        return self.random.uniform(0.8, 1.25)

    def make_scale(self, data):
        factor = self.factor()
        self.scaled(factor, factor)

    def make_stretch(self, data):
        factors = [self.factor(), 1]
        self.random.shuffle(factors)
        self.scaled(*factors)

    def make_both(self, data):
        self.scaled(self.factor(), self.factor())

    def make_mirror(self, data):
        way = self.random.choice(["x", "y", "swapped"])
        for tag in self.tags.values():
            if way == "swapped":
                tag[0], tag[1] = tag[1], tag[0]
            else:
                axis = "xy".index(way)
                tag[axis] = 0.8 - tag[axis]
        self.wrong.update(self.files)

    def make_blur(self, data, count=5):
        """The camera turned about any axis of its own while the shutter was open, or swung on its cart."""
        self.blurred = set(self.pick(count))
        for name in sorted(self.blurred):
            upright = self.random.random() < 0.5
            axis = [0, 0, 1] if upright else [self.random.gauss(0, 1) for _ in range(3)]
            motion_blur.blurred(data / "photos" / name, self.folder / "in" / name, axis, self.random.randint(15, 45))

    def beside(self):
        """Two photos of neighbouring stops; the second takes the first one's picture or place."""
        first = self.random.choice([name for name in self.files if self.truth[name]["grid"][0] < 4])
        i, j = self.truth[first]["grid"]
        return first, next(name for name in self.files if self.truth[name]["grid"] == [i + 1, j])

    def make_twice(self, data):
        """One picture under two names: its second file has other bytes, as two shots from one place have."""
        first, second = self.beside()
        jpeg = (data / "photos" / first).read_bytes()
        (self.folder / "in" / second).write_bytes(jpeg[:-2] + b"\xff\xfe\x00\x06seed" + jpeg[-2:])
        self.truth[second] = self.truth[first]
        self.pair = {first, second}
        self.wrong.add(second)

    def make_bytes(self, data):
        """One file under two names."""
        first, second = self.beside()
        (self.folder / "in" / second).write_bytes((data / "photos" / first).read_bytes())
        self.truth[second] = self.truth[first]
        self.pair = {first, second}
        self.wrong.update(self.pair)

    def make_place(self, data):
        """Two photos are tagged with one place."""
        first, second = self.beside()
        self.tags[second] = self.tags[first]
        self.pair = {first, second}
        self.wrong.update(self.pair)

    def make_mixed(self, data):
        self.make_off(data)
        self.make_swap(data)
        self.make_blur(data, 2)

    def make_still(self, data):
        """The cart was not moved: another picture of one place, a little darker and of other noise."""
        first, second = self.beside()
        motion_blur.darker(data / "photos" / first, self.folder / "in" / second, self.seed)
        self.truth[second] = self.truth[first]
        self.pair = {first, second}
        self.wrong.add(second)


def yaw_error_deg(quaternion, truth):
    """The yaw of found * truth^-1 about the vertical."""
    w, x, y, z = quaternion
    a, b, c, d = truth[0], -truth[1], -truth[2], -truth[3]
    turn = 2 * math.atan2(w * d + x * c - y * b + z * a, w * a - x * b - y * c - z * d)
    return math.degrees(math.remainder(turn, 2 * math.pi))


def own_errors(places):
    """How far each place is off along an axis, over its deviation. What all are moved, turned and scaled by together is fitted
    and taken off: a dataset's deviations do not hold it. places: (found, true, deviation) as complex numbers."""
    weights = [1 / sigma ** 2 for _, _, sigma in places]
    for _ in range(5):  # the few that are far off count less each time
        total = sum(weights)
        middle = sum(w * true for w, (_, true, _) in zip(weights, places)) / total
        mean = sum(w * found for w, (found, _, _) in zip(weights, places)) / total
        spread = sum(w * abs(true - middle) ** 2 for w, (_, true, _) in zip(weights, places))
        turn = sum(w * (found - mean) * (true - middle).conjugate() for w, (found, true, _) in zip(weights, places)) / spread
        errors = [abs(found - mean - turn * (true - middle)) / math.sqrt(2) / sigma for found, true, sigma in places]
        weights = [1 / sigma ** 2 / max(1, error / 2) for error, (_, _, sigma) in zip(errors, places)]
    return errors


class Outcome:
    """What align and export said and wrote of a survey."""

    def __init__(self, survey, cli, features):
        """features: a folder that keeps the features of photos which several surveys have."""
        self.survey, folder = survey, survey.folder
        rows = "".join(f"{name},{x:.4f},{y:.4f},{z:.4f}\n" for name, (x, y, z) in sorted(survey.tags.items()))
        (folder / "places.csv").write_text("file,x_m,y_m,z_m\n" + rows)
        where = folder / "s.spherewalk"
        self.expect(run(cli, "new", where, "--rect", ",".join(map(str, survey.rect)), "--step", survey.step, "--ceiling", 2.6))
        imported = run(cli, "import", where, "--photos", folder / "in", "--positions", folder / "places.csv")
        if survey.kind != "bytes":
            self.expect(imported)
        self.import_words = imported[2]
        (where / "align-cache").symlink_to(features)
        _, out, words = run(cli, "align", where, "--json")
        self.align = json.loads(out)
        self.align_words = " ".join(word for word in words.splitlines() if "%" not in word[-20:])
        _, _, self.export_words = run(cli, "export", where, folder / "d", "--scene", "sphere")
        file = folder / "d" / "dataset.json"
        self.dataset = json.loads(file.read_text()) if file.exists() else {"photos": []}

    @staticmethod
    def expect(done):
        if done[0] != 0:
            sys.exit(f"A command failed: {done[2]}")

    def name_of(self, file):
        return pathlib.Path(file).name.split("_")[0].split(".")[0] + ".JPG"

    def flags(self):
        return {self.name_of(photo["file"]): photo["flags"] for photo in self.align["photos"]}

    def whole(self):
        return [sentence for sentence in self.align["warnings"] if "scale" in sentence or "mirrored" in sentence]

    def exported(self):
        for photo in self.dataset["photos"]:
            yield self.name_of(photo["file"]), photo

    def judge(self):
        """Of each photo that is off: how far, and whether a sentence or its own deviation says so."""
        self.errors, self.z_place, self.z_yaw = {}, {}, {}
        yaws, places = {}, {}
        for name, photo in self.exported():
            truth = self.survey.truth[name]
            place = photo["position_m"]
            error = math.dist(place[:2], truth["position"][:2])
            sigma = (photo.get("position_sigma_m") or [0])[0]
            self.errors[name] = (error, sigma)
            if sigma:
                places[name] = (complex(*place[:2]), complex(*truth["position"][:2]), sigma)
            rotation = photo.get("rotation_sigma_deg")
            if rotation and photo["rotation_source"] == "aligned":
                q = photo["room_from_photo"] if "room_from_photo" in photo else photo["rotation"]
                q = [q[k] for k in ("w", "x", "y", "z")] if isinstance(q, dict) else q
                yaws[name] = (yaw_error_deg(q, truth["quaternion_wxyz"]), rotation["yaw"])
        if yaws:
            common = sorted(error for error, _ in yaws.values())[len(yaws) // 2]
            self.z_yaw = {name: (error - common) / sigma for name, (error, sigma) in yaws.items()}
        if self.survey.kind not in OF_THE_WHOLE and len(places) > 2:
            self.z_place = dict(zip(places, own_errors(list(places.values()))))
        return self

    def told(self, name):
        stem = name.split(".")[0]
        return bool(self.flags().get(name)) or bool(self.whole()) or stem in self.align_words

    def silent(self):
        """Photos of the dataset that are far off, with nothing in the export's words and no deviation that says so."""
        said = self.export_words
        whole = "mirrored" in said or "scale" in said
        return [name for name, (error, sigma) in self.errors.items()
                if error > WRONG_M and not whole and name.split(".")[0] not in said and 3 * sigma < error]

    def missed(self):
        """Wrong photos that are neither solved nor named."""
        kind = self.survey.kind
        if kind in ("twice", "still"):
            return [name for name in self.survey.pair if not self.flags().get(name)]
        if kind in ("bytes", "place"):
            said = self.import_words + self.align_words
            return [name for name in self.survey.pair if name.split(".")[0] not in said]
        if kind in OF_THE_WHOLE:
            return [] if self.whole() or max((error for error, _ in self.errors.values()), default=0) <= WRONG_M else ["the whole"]
        return [name for name in self.survey.wrong
                if not self.told(name) and self.errors.get(name, (1, 0))[0] > SOLVED_M]

    def accused(self):
        """Photos that are right, and are called wrong."""
        right = set(self.survey.files) - self.survey.wrong - getattr(self.survey, "pair", set())
        right -= self.survey.blurred
        return [name for name in right if self.flags().get(name)]


class Totals:
    """What became of all surveys: a row a kind, and how far poses are off in their own deviations."""

    COLUMNS = ("surveys", "wrong photos", "missed", "silently wrong", "right but named")

    def __init__(self):
        self.rows = {}
        self.z = {(what, is_blurred): [] for what in ("yaw", "place") for is_blurred in (False, True)}

    def add(self, survey, outcome):
        row = self.rows.setdefault(survey.kind, [0] * len(self.COLUMNS))
        counted = (1, len(survey.wrong), len(outcome.missed()), len(outcome.silent()), len(outcome.accused()))
        self.rows[survey.kind] = [a + b for a, b in zip(row, counted)]
        for what, zs in (("yaw", outcome.z_yaw), ("place", outcome.z_place)):
            for name, z in zs.items():
                self.z[what, name in survey.blurred].append(z)

    def tell(self):
        print("| kind | " + " | ".join(self.COLUMNS) + " |")
        print("|---" * (1 + len(self.COLUMNS)) + "|")
        whole = [sum(column) for column in zip(*self.rows.values())]
        for kind, row in [*sorted(self.rows.items()), ("all", whole)]:
            print(f"| {kind} | " + " | ".join(map(str, row)) + " |")
        for what in ("yaw", "place"):
            sharp, blurred = self.z[what, False], self.z[what, True]
            for which, zs in (("all", sharp + blurred), ("sharp", sharp), ("blurred", blurred)):
                if zs:
                    share = sum(abs(z) <= 3 for z in zs) / len(zs)
                    mean = math.sqrt(sum(z * z for z in zs) / len(zs))
                    print(f"z of {what}, {which}: {100 * share:.1f} % of {len(zs)} within 3, "
                          f"worst {max(map(abs, zs)):.1f}, RMS {mean:.2f}")


def worst(zs):
    return f"{max(map(abs, zs.values()), default=0):.1f}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cli", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--surveys", type=int, default=50)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--kind", choices=KINDS)
    parser.add_argument("--words", action="store_true", help="print what align and export said")
    options = parser.parse_args()
    totals = Totals()
    features = tempfile.TemporaryDirectory()
    for seed in range(options.first, options.first + options.surveys):
        kind = options.kind or KINDS[seed % len(KINDS)]
        with tempfile.TemporaryDirectory() as folder:
            survey = Survey(options.data, seed, kind, pathlib.Path(folder))
            outcome = Outcome(survey, options.cli.resolve(), features.name).judge()
        places = [error for error, _ in outcome.errors.values()]
        totals.add(survey, outcome)
        print(f"{seed} {kind}: {len(places)} exported, worst {1000 * max(places, default=0):.0f} mm, "
              f"worst z {worst(outcome.z_yaw)} yaw {worst(outcome.z_place)} place, "
              f"missed {outcome.missed()}, silent {outcome.silent()}, accused {outcome.accused()}", flush=True)
        if options.words:
            print("  wrong:", {name: [round(v, 3) for v in survey.tags[name]] for name in sorted(survey.wrong)[:4]})
            for name, (error, sigma) in sorted(outcome.errors.items()):
                if error > 0.01:
                    print(f"  {name} off {1000 * error:.0f} mm, sigma {1000 * sigma:.1f} mm")
            for name, flags in sorted(outcome.flags().items()):
                print("".join(f"  {name}: {flag}\n" for flag in flags), end="")
            print("".join(f"  align: {sentence}\n" for sentence in outcome.align["warnings"]), end="")
            print("".join(f"  export: {line}\n" for line in outcome.export_words.splitlines() if "%" not in line[:6]), end="")
    totals.tell()


if __name__ == "__main__":
    main()
