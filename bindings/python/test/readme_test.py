"""The programs that are printed in the documentation run as they are printed."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import alphamst

ROOT = pathlib.Path(__file__).resolve().parents[3]


class Readme(unittest.TestCase):
    def run_printed(self, program):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(ROOT / "examples/data/coast_small.msh", pathlib.Path(folder, "coast.msh"))
            command = [sys.executable, "-c", program]
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60)
            self.assertEqual(done.stderr, "")
            self.assertRegex(done.stdout, r"^\d+\b")
            self.assertIn("finer.vtk", os.listdir(folder))

    def test_printed_programs(self):
        for path in (ROOT / "README.md", ROOT / "bindings/python/README.md"):
            programs = re.findall(r"```python\n(.*?)```", path.read_text(encoding="utf-8"), flags=re.S)
            self.assertEqual(len(programs), 1, path)
            self.run_printed(programs[0])

    def test_documentation_of_the_package(self):
        block = re.search(r"(?m)(?:^    .*\n)+", alphamst.__doc__)[0]
        self.run_printed(re.sub(r"(?m)^    ", "", block))
