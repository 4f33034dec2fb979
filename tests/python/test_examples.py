"""Every example in examples/python runs: scripts, and the notebook from its first cell to its last."""

import json
import pathlib
import shutil
import subprocess
import sys
import unittest

from support import SOURCE, InScratchFolder, pair, program, write_ppm

EXAMPLES = SOURCE / "examples" / "python"


class Examples(InScratchFolder):
    def test_every_script_runs(self):
        scripts = sorted(EXAMPLES.glob("[0-9]*.py"))
        self.assertGreaterEqual(len(scripts), 6)
        left = pair()[0]
        home = self.folder / "home.db"
        scene = write_ppm(self.folder / "scene.ppm", left)
        program("teach", "book", "--image", write_ppm(self.folder / "book.ppm", left[60:220, 80:260]),
                "--memory", home)
        listed = (EXAMPLES / "README.md").read_text()
        for script in scripts:
            with self.subTest(script=script.name):
                words = [home, scene] if script.name.startswith("03") else []
                done = subprocess.run([sys.executable, "-B", script, *words], capture_output=True, text=True,
                                      cwd=self.folder, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertGreater(len(done.stdout), 20)
                self.assertIn(f"[`{script.name}`]({script.name})", listed)

    def test_every_notebook_runs_and_holds_no_output(self):
        notebooks = sorted(EXAMPLES.glob("*.ipynb"))
        self.assertGreaterEqual(len(notebooks), 1)
        for notebook in notebooks:
            cells = json.loads(notebook.read_text())["cells"]
            self.assertFalse(any(cell.get("outputs") for cell in cells), notebook.name)
            copy = shutil.copy(notebook, self.folder)  # it runs where it lies, and writes there
            done = subprocess.run(
                [sys.executable, "-m", "jupyter", "nbconvert", "--to", "notebook", "--inplace", "--execute",
                 str(copy), "--ExecutePreprocessor.timeout=240"],
                capture_output=True, text=True, cwd=self.folder, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            out = json.loads(pathlib.Path(copy).read_text())
            said = json.dumps([cell.get("outputs") for cell in out["cells"]])
            self.assertIn("success", said)


if __name__ == "__main__":
    unittest.main()
