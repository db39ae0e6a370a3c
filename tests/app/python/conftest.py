# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of `import spherewalk` have in common. SPHEREWALK_CLI: the program that views are compared with;
SPHEREWALK_DEMO: what `spherewalk-cli demo` left."""

import json
import os
import pathlib
import subprocess

import numpy as np
import pytest
import spherewalk
from PIL import Image

DEMO = pathlib.Path(os.environ["SPHEREWALK_DEMO"])
BODY_POSE = [2.5, 2.0, 1.2, 0.0, 0.0, 0.0, 1.0]  # between photos, in the middle of the room


def cli(*arguments):
    """What the program prints with --json."""
    done = subprocess.run([os.environ["SPHEREWALK_CLI"], *map(str, arguments), "--json"], check=True, text=True,
                          stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def pixels(file):
    return np.asarray(Image.open(file).convert("RGB"))


@pytest.fixture(scope="session")
def dataset():
    return spherewalk.Dataset.open(DEMO / "dataset")


@pytest.fixture(scope="session")
def camera():
    return spherewalk.Camera.read(DEMO / "robot.yaml")


@pytest.fixture(scope="session")
def renderer(dataset):
    return spherewalk.Renderer(dataset)


@pytest.fixture
def small():
    """A camera that takes no time."""
    return spherewalk.Camera.pinhole(64, 48, 1.2)
