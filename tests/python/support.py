"""What the tests of the Python module share: the program, made images, scratch folders."""

import ast
import functools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import striate

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["STRIATE_PROGRAM"]
PLUGINS = pathlib.Path(os.environ["STRIATE_TEST_PLUGINS"])
SHORT = SOURCE / "config" / "worlds" / "short.yaml"
STUB = SOURCE / "python" / "striate" / "__init__.pyi"
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


def script(text, *words):
    """Starts Python code of its own, whose lines can be read from its stdout."""
    return subprocess.Popen([sys.executable, "-B", "-c", text, *map(str, words)], text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def tree_of_stub():
    return {node.name if isinstance(node, (ast.ClassDef, ast.FunctionDef)) else node.target.id: node
            for node in ast.parse(STUB.read_text()).body
            if isinstance(node, (ast.ClassDef, ast.FunctionDef, ast.AnnAssign))}


def is_public(name):
    return not name.startswith("_") or name == "__version__"


def members_in(cls):
    """Public names that a class of the stub has."""
    return {node.name if isinstance(node, ast.FunctionDef) else node.target.id for node in cls.body
            if isinstance(node, (ast.FunctionDef, ast.AnnAssign))
            and is_public(node.name if isinstance(node, ast.FunctionDef) else node.target.id)}


def noted_robot(folder):
    """A robot without a camera, in real time: its file, and the file that each stop adds a line to."""
    file, notes = folder / "robot.yaml", folder / "notes"
    file.write_text(f"plugins: [{PLUGINS / 'noted_post.so'}]\nbody: {{noted_post: {{notes: {notes}}}}}\n")
    return file, notes


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
