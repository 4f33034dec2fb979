"""What the tests of the Python module share: the program, made images, scratch folders."""

import functools
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import striate

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["STRIATE_PROGRAM"]
SHORT = SOURCE / "config" / "worlds" / "short.yaml"
MISSION = SOURCE / "examples" / "08_a_mission_from_code"
# Figures of the result that the wall's clock makes.
WALL_CLOCK = ("mean_cycle_ms", "realtime_factor")


class InScratchFolder(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path


def program(*words, code=0):
    """Runs `striate`; its standard output, and standard error behind it."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != code:
        raise AssertionError(f"striate {words} ends with {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout, done.stderr


@functools.cache
def looks():
    """Senses of the simulated robot 2 m before a box: the last of a few steps."""
    world = striate.Simulator(SHORT, seed=5, start=striate.Pose(3.5, 0.0, 0.0))
    for _ in range(12):
        senses = world.step()
    return senses


def pair():
    """A pair of images with its camera: (left, right, options)."""
    senses = looks()
    return senses.left, senses.right, {"focal_px": senses.focal_px, "baseline_m": senses.baseline_m}


def write_ppm(path, bgr):
    """A picture file that holds the array, byte for byte."""
    height, width = bgr.shape[:2]
    path.write_bytes(b"P6\n%d %d\n255\n" % (width, height) + np.ascontiguousarray(bgr[:, :, ::-1]).tobytes())
    return path


def read_pfm(path):
    """The floats of a PFM file, upper row first."""
    with open(path, "rb") as file:
        assert file.readline() == b"Pf\n"
        width, height = map(int, file.readline().split())
        assert float(file.readline()) < 0.0
        values = np.frombuffer(file.read(), "<f4")
    return values.reshape(height, width)[::-1]


def without_clock(result):
    """A result without what the wall's clock made of it."""
    if isinstance(result, (str, pathlib.Path)):
        result = json.loads(pathlib.Path(result).read_text())
    return {key: value for key, value in result.items() if key not in WALL_CLOCK}
