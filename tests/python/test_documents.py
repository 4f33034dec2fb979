"""Every block of Python in docs/python.md runs, in its order, from a folder of its own."""

import contextlib
import io
import os
import re
import unittest

import striate
from support import SOURCE, InScratchFolder, pair, program, write_ppm


class Documents(InScratchFolder):
    def test_every_block_of_python_runs(self):
        text = (SOURCE / "docs" / "python.md").read_text()
        blocks = [(text.count("\n", 0, found.start()) + 2, found[1])
                  for found in re.finditer(r"^```python\n(.*?)^```", text, re.M | re.S)]
        self.assertGreater(len(blocks), 6)
        left, right, _ = pair()
        # What is in a file tells what it is, never its name.
        write_ppm(self.folder / "left.png", left)
        write_ppm(self.folder / "right.png", right)
        write_ppm(self.folder / "book.png", left[60:220, 80:260])
        program("teach", "book", "--image", self.folder / "book.png", "--memory", self.folder / "home.db")
        names = {}
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        said = io.StringIO()
        for line, block in blocks:
            code = compile("\n" * (line - 1) + block, "docs/python.md", "exec")
            with contextlib.redirect_stdout(said):
                exec(code, names)
        self.assertIn("keypoints are in both images", said.getvalue())
        self.assertIn("wrong.yaml 4", said.getvalue())
        self.assertIn("success", said.getvalue())
        self.assertIn("book", said.getvalue())
        self.assertIs(names["striate"], striate)


if __name__ == "__main__":
    unittest.main()
