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
from support import SOURCE

STUB = SOURCE / "python" / "striate" / "__init__.pyi"


def names_in(body):
    """Public names that a stub defines or assigns, with the names of classes' members."""
    names = {}
    for node in body:
        if isinstance(node, ast.ClassDef):
            names[node.name] = names_in(node.body)
        elif isinstance(node, ast.FunctionDef):
            names[node.name] = {}
        elif isinstance(node, ast.AnnAssign):
            names[node.target.id] = {}
    return {name: inner for name, inner in names.items() if not name.startswith("_") or name == "__version__"}


def members_of(cls):
    return {name for name in vars(cls) if not name.startswith("_")}


class Interface(unittest.TestCase):
    def setUp(self):
        self.stub = names_in(ast.parse(STUB.read_text()).body)

    def test_stub_and_module_name_the_same(self):
        self.assertEqual(sorted(self.stub), sorted(striate.__all__))
        for name in striate.__all__:
            self.assertTrue(hasattr(striate, name), name)
        for name, members in self.stub.items():
            cls = getattr(striate, name)
            if not inspect.isclass(cls) or issubclass(cls, striate.Record):
                continue
            own = {member for base in cls.__mro__ if base.__module__.startswith("striate") for member in members_of(base)}
            with self.subTest(cls=name):
                self.assertEqual(own - set(members), set())
                if cls.__module__ == "striate._striate":  # others have attributes that __init__ makes
                    self.assertEqual(set(members) - own, set())

    def test_functions_take_what_the_stub_says(self):
        tree = {node.name: node for node in ast.parse(STUB.read_text()).body if isinstance(node, ast.FunctionDef)}
        for name, node in tree.items():
            function = getattr(striate, name)
            stub = [one.arg for one in node.args.posonlyargs + node.args.args + node.args.kwonlyargs]
            if inspect.isfunction(function):
                self.assertEqual(list(inspect.signature(function).parameters), stub, name)
            else:
                told = re.match(rf"{name}\((.*)\)", function.__doc__.splitlines()[0])[1]
                mine = re.findall(r"(?:^|, )(\w+)(?=:)", told)
                self.assertEqual([one for one in stub if one in mine], mine, name)

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

    def test_importing_it_is_quick_and_brings_nothing_else(self):
        code = "import sys; import striate; print('cv2' in sys.modules, 'matplotlib' in sys.modules)"
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(said.stdout.split(), ["False", "False"])


if __name__ == "__main__":
    unittest.main()
