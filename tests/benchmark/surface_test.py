#!/usr/bin/env python3
"""surface_test.py PROGRAM: surface.py passes good meshes, sees each kind of bad one and reads what it is
asked for; the surfaces that it makes are closed and have their outside outside."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import damage
import shape

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()

# A vertex far off turns faces over; one a little off is another mesh.
MOVE = 'line = lines[lines.index("$Nodes") + 2].split(); lines[lines.index("$Nodes") + 2] = " ".join([*line[:3], {}])'
DAMAGES = {
    "inverted quads": ("", MOVE.format('"-3"')),
    "faces instead of": ("arguments[2:3] = [str(1.2 * float(a)) for a in arguments[2:3]]", ""),
    "two threads give another mesh": ("", f'if arguments[4] == "2": {MOVE.format("str(float(line[3]) + 1e-9)")}'),
    "Segmentation fault": ("if len(arguments) == 5: import os; os.kill(os.getpid(), 11)", ""),
    "not on two": ("if arguments[4:] == ['2']: sys.exit('not on two')", ""),
}


class Surface(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.mesh = self.folder / "pebble.off"
        shape.write_pebble(self.mesh, 5)  # 250 faces when paired

    def measure(self, *arguments, program=PROGRAM):
        return subprocess.run(
            [sys.executable, "-B", HERE / "surface.py", "--program", program, "--out", self.folder / "out", *arguments],
            text=True, capture_output=True, check=False, env={**os.environ, "ALPHAMST_JUDGE": ""})

    def test_passes_good_meshes(self):
        done = self.measure("--pictures", self.folder, f"{self.mesh}:x0.8", f"{self.mesh}:302")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("2 meshes by AlphaMST, 0 faults.", done.stdout)
        self.assertIn("\n| input | 252 | 250 |", done.stdout)
        self.assertIn("\n| AlphaMST alpha = 0.8 | 202 | 200 |", done.stdout)
        self.assertIn("\n| AlphaMST alpha = 1.2 | 302 | 300 |", done.stdout)
        pictures = sorted(path.name for path in self.folder.glob("*.svg"))
        self.assertEqual(pictures, ["pebble_alpha_0.8.svg", "pebble_alpha_1.2.svg", "pebble_before.svg"])

    def test_shows_peers(self):
        peers = self.folder / "peers.json"
        numbers = {"V": 7, "F": 8, "irr": 9, "inverted": 1, "SJ_min": 0.25, "SJ_mean": 0.5, "d_max": 0.01}
        peers.write_text(json.dumps({"pebble.off": [{"name": "other", "numbers": numbers}]}), encoding="utf-8")
        done = self.measure("--peers", peers, self.mesh)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("\n| other | 7 | 8 | 9 | 1 | 0.250 | 0.500 | 1.000 |", done.stdout)

    def test_sees_damage(self):
        for fault, (before, after) in DAMAGES.items():
            with self.subTest(fault):
                damaging = damage.program(self.folder, PROGRAM, before, after)
                done = self.measure(self.mesh, program=damaging)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertRegex(done.stdout, rf"AlphaMST alpha = 1: \*\*.*{fault}")

    def test_refuses_what_it_cannot_read(self):
        self.assertEqual(self.measure(f"{self.mesh}:half").returncode, 2)
        self.assertEqual(self.measure(self.folder / "none.off").returncode, 2)

    def test_made_surfaces_are_closed(self):
        for write in shape.SHAPES.values():
            write(self.mesh)
            lines = self.mesh.read_text(encoding="utf-8").splitlines()
            n_points, n_faces, _ = map(int, lines[1].split())
            points = [list(map(float, line.split())) for line in lines[2:2 + n_points]]
            faces = [list(map(int, line.split()[1:])) for line in lines[2 + n_points:]]
            edges = {edge for a, b, c in faces for edge in ((a, b), (b, c), (c, a))}
            self.assertEqual((len(faces), len(edges)), (n_faces, 3 * n_faces))
            self.assertEqual(edges, {(b, a) for a, b in edges})
            volume = sum(shape.dot(points[a], shape.cross(points[b], points[c])) for a, b, c in faces)
            self.assertGreater(volume, 1)


if __name__ == "__main__":
    unittest.main()
