import pathlib
import tempfile
import unittest

import numpy as np
from grid import grid

import alphamst
from alphamst import Flag, Mesh

COUNTS = {"vertex": 16, "edge": 24, "face": 9}


class Markers(unittest.TestCase):
    def test_of_each_entity(self):
        for entity, n in COUNTS.items():
            mesh = grid(3)
            before = mesh.checksum()
            self.assertFalse(mesh.markers(entity).any())
            self.assertEqual(mesh.marker_list(entity).tolist(), [])
            mesh.set_markers(entity, [0, 8], 7)
            mesh.set_markers(entity, [8], -2)
            mesh.set_markers(entity, [], 5)  # none, not all
            wanted = [{0: 7, 8: -2}.get(i, 0) for i in range(n)]
            self.assertEqual(mesh.markers(entity).tolist(), wanted)
            self.assertEqual(mesh.markers(entity, np.zeros(n + 2, np.int32)[1 : n + 1]).tolist(), wanted)
            self.assertEqual(mesh.marker_list(entity).tolist(), [-2, 7])
            self.assertEqual(mesh.flags(entity)[0] == Flag.CORNER, entity == "vertex")
            self.assertNotEqual(mesh.checksum(), before)
            mesh.set_markers(entity, None, 3)
            self.assertEqual(mesh.marker_list(entity).tolist(), [3])

    def test_names(self):
        mesh = grid(3)
        mesh.set_markers("edge", [0, 1], 7)
        self.assertEqual(mesh.marker_name("edge", 7), "")
        mesh.set_marker_name("edge", 7, "Überlauf 1")
        mesh.set_marker_name("face", 7, "sand")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "named.msh")
            mesh.write(path)
            back = Mesh.read(path)
        self.assertEqual(back.checksum(), mesh.checksum())
        self.assertEqual((back.marker_name("edge", 7), back.marker_name("face", 7)), ("Überlauf 1", "sand"))
        mesh.set_marker_name("edge", 7, "")
        self.assertEqual(mesh.marker_name("edge", 7), "")

    def test_refused(self):
        mesh = grid(3)
        before = mesh.checksum()
        self.assertRaises(alphamst.RangeError, lambda: mesh.set_markers("vertex", [0, 16], 1))
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.set_marker_name("edge", 0, "none"))
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.set_marker_name("edge", 1, 'a "b"'))
        self.assertRaises(ValueError, lambda: mesh.set_marker_name("edge", 1, "a\0b"))
        self.assertEqual(mesh.checksum(), before)
