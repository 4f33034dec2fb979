"""What is public says what it is: stubs, docstrings, version."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys
import unittest

import striate
from striate import _striate
from support import SOURCE, is_public, members_in, tree_of_stub


def members_of(cls):
    """Public names that a class has beside those of Python's own classes."""
    names = {name for base in cls.__mro__ if base.__module__.startswith("striate") for name in vars(base)}
    for made in (striate.Problem("file", 1, 1, "message"), striate.Argument(1.0)):
        if type(made) is cls:
            names |= set(vars(made))
    return {name for name in names if is_public(name)}


def told_in_stub(node):
    """(name, whether it may be left away) of each parameter, "*" before those by name alone."""
    told = []
    positional = node.args.posonlyargs + node.args.args
    for k, one in enumerate(positional):
        told.append((one.arg, k >= len(positional) - len(node.args.defaults)))
    if node.args.kwonlyargs:
        told.append(("*", False))
    told += [(one.arg, default is not None) for one, default in zip(node.args.kwonlyargs, node.args.kw_defaults)]
    return told


def told_by_python(function):
    told = []
    for one in inspect.signature(function).parameters.values():
        if one.kind is one.KEYWORD_ONLY and ("*", False) not in told:
            told.append(("*", False))
        told.append((one.name, one.default is not one.empty))
    return told


def parts(text):
    """The text cut at its commas, but not within brackets."""
    cut, depth = [""], 0
    for letter in text:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            cut.append("")
        else:
            cut[-1] += letter
    return [one.strip() for one in cut if one.strip()]


def told_by_docstring(function):
    """What pybind11 writes there: `see(self: ..., left: object, right: object = None, **kwargs) -> ...`."""
    line = function.__doc__.splitlines()[0]
    told = []
    for part in parts(re.match(r"\w+\((.*)\) -> ", line)[1]):
        if part == "**kwargs":
            if ("*", False) not in told:
                told.append(("*", False))
            told += [(name, True) for name in _striate._PERCEIVE_OPTIONS]
        else:
            told.append((part.partition(":")[0], " = " in part))
    return told


def told_by(function):
    return told_by_python(function) if inspect.isfunction(function) else told_by_docstring(function)


class Interface(unittest.TestCase):
    def setUp(self):
        self.stub = {name: node for name, node in tree_of_stub().items() if is_public(name)}

    def test_stub_and_module_name_the_same(self):
        self.assertEqual(sorted(self.stub), sorted(striate.__all__))
        for name in striate.__all__:
            self.assertTrue(hasattr(striate, name), name)
        for name, node in self.stub.items():
            cls = getattr(striate, name)
            # What records hold stands in no class: test_memories compares it.
            if inspect.isclass(cls) and not issubclass(cls, striate.Record):
                with self.subTest(cls=name):
                    self.assertEqual(members_of(cls), members_in(node))

    def test_functions_take_what_the_stub_says(self):
        compared = 0
        for name, node in self.stub.items():
            functions = [(getattr(striate, name), node)] if isinstance(node, ast.FunctionDef) else []
            if isinstance(node, ast.ClassDef):
                functions = [(getattr(getattr(striate, name), one.name), one) for one in node.body
                             if isinstance(one, ast.FunctionDef) and (is_public(one.name) or one.name == "__init__")]
            for function, told in functions:
                compared += 1
                with self.subTest(of=name, name=told.name):
                    self.assertEqual(told_by(function), told_in_stub(told))
        self.assertGreater(compared, 40)

    def test_everything_public_has_a_docstring(self):
        bare = []
        for name in striate.__all__:
            value = getattr(striate, name)
            if not callable(value):
                continue
            if not inspect.getdoc(value) or inspect.getdoc(value) == inspect.getdoc(object):
                bare.append(name)
            if not inspect.isclass(value):
                continue
            for member, inner in vars(value).items():
                if member.startswith("_") or not (callable(inner) or isinstance(inner, property)):
                    continue
                doc = inspect.getdoc(inner) or ""
                # A quantity whose name says unit and meaning needs no more.
                if not doc and not re.search(r"_(m|s|px|rad|m_s|rad_s|m_s2|v)$|^(id|name|seed|gain|software|file)$", member):
                    bare.append(f"{name}.{member}")
        self.assertEqual(bare, [])

    def test_version_is_the_programs(self):
        said = subprocess.run([os.environ["STRIATE_PROGRAM"], "--version"], capture_output=True, text=True, check=True)
        self.assertEqual(said.stdout.strip(), f"striate {striate.__version__}")

    def test_a_type_checker_accepts_the_stub_and_code_that_uses_it(self):
        use = pathlib.Path(__file__).with_name("typed_use.py")
        checked = subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", "--no-incremental", "--cache-dir", os.devnull, str(use)],
            capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(SOURCE / "python")}, check=False)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)

    def test_importing_it_brings_nothing_else(self):
        code = "import sys; import striate; print('cv2' in sys.modules, 'matplotlib' in sys.modules)"
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(said.stdout.split(), ["False", "False"])


if __name__ == "__main__":
    unittest.main()
