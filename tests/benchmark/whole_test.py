#!/usr/bin/env python3
"""whole_test.py PROGRAM: whole.py passes good meshes and sees each kind of bad one. The bad ones are
made by a program that calls whole_run and then damages what it wrote."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import damage

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SIDE = 6

# The first vertex is a corner of the square: it can move outwards without harm to any face, or so far
# inwards that its face turns over.
MOVE = 'lines[lines.index("$Nodes") + 2] = "1 {0} {0} 0"'
DAMAGES = {
    "boundary edges changed": ("", MOVE.format(-0.25)),
    "inverted quads": ("", MOVE.format(2)),
    "faces instead of": ("arguments[2:3] = [str(1.2 * float(a)) for a in arguments[2:3]]", ""),
    "Segmentation fault": ("if len(arguments) == 5: import os; os.kill(os.getpid(), 11)", ""),
    "is no number": ("if len(arguments) == 5: sys.exit('is no number')", ""),
}


def write_grid(path):
    nodes = [f"{1 + x + (SIDE + 1) * y} {x} {y} 0" for y in range(SIDE + 1) for x in range(SIDE + 1)]
    corners = [1 + x + (SIDE + 1) * y for y in range(SIDE) for x in range(SIDE)]
    faces = [f"{i} 3 2 1 1 {a} {a + 1} {a + SIDE + 2} {a + SIDE + 1}" for i, a in enumerate(corners, 1)]
    path.write_text("\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes)), *nodes,
                               "$EndNodes", "$Elements", str(len(faces)), *faces, "$EndElements", ""]),
                    encoding="utf-8")


class Whole(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.mesh = self.folder / "grid.msh"
        write_grid(self.mesh)

    def compare(self, program, mesh=None):
        return subprocess.run(
            [sys.executable, "-B", HERE / "whole.py", "--program", program, "--out", self.folder / "out",
             mesh or self.mesh],
            text=True, capture_output=True, check=False, env={**os.environ, "ALPHAMST_JUDGE": ""})

    def test_passes_good_meshes(self):
        done = self.compare(PROGRAM)
        self.assertEqual((done.returncode, done.stderr.count("AlphaMST")), (0, 3), done.stdout + done.stderr)
        self.assertIn("3 meshes by AlphaMST, 0 faults.", done.stdout)
        self.assertIn(f"| AlphaMST alpha = 1 | {(SIDE + 1) ** 2} | {SIDE ** 2} | 0 | 0 | 0 | 1.000 |", done.stdout)

    def test_sees_damage(self):
        for fault, (before, after) in DAMAGES.items():
            with self.subTest(fault):
                done = self.compare(damage.program(self.folder, PROGRAM, before, after))
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertRegex(done.stdout, rf"AlphaMST alpha = 0.8: \*\*.*{fault}")
                self.assertIn("3 meshes by AlphaMST, 3 faults.", done.stdout)

    def test_sees_that_a_mesh_cannot_be_read(self):
        self.mesh.write_text("no mesh\n", encoding="utf-8")
        done = self.compare(PROGRAM)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("input: **AMST_ERR_FORMAT", done.stdout)


if __name__ == "__main__":
    unittest.main()
