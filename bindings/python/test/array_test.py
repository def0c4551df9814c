"""What goes in and out without a copy, and what is copied."""

import unittest
from fractions import Fraction

import numpy as np
from grid import faces, grid, points

from alphamst import Mesh, array


class In(unittest.TestCase):
    def test_matrices_of_any_layout(self):
        wanted = grid(4, 3).checksum()
        xy, corners = points(4, 3), faces(4, 3)
        padded = np.full((40, 5), np.nan)
        padded[::2, 1:5:2] = xy
        for given in [
            xy,
            padded[::2, 1:5:2],
            np.asfortranarray(xy),
            xy.astype(np.float32),
            xy[::-1][::-1],
            xy[::-1].copy()[::-1],
            xy.tolist(),
            [[Fraction(c) for c in row] for row in xy],
        ]:
            self.assertEqual(Mesh(given, corners).checksum(), wanted)
        wide = np.zeros((12, 6), np.int32)
        wide[:, 1:5] = corners
        for given in [
            corners,
            corners.astype(np.int64),
            wide[:, 1:5],
            np.asfortranarray(corners),
            corners.astype(np.uint8),
            np.asfortranarray(corners.astype(np.int64)),
            corners[::-1].copy()[::-1],
            corners.tolist(),
            corners.astype(">i4"),
        ]:
            self.assertEqual(Mesh(xy, given).checksum(), wanted)

    def test_strides_are_read_where_they_lie(self):
        strided = np.zeros((3, 4))[:, ::2]
        self.assertIs(array.by_strides(strided, np.float64)[0], strided)
        self.assertEqual(array.by_strides(strided, np.float64)[1:], (4, 2))
        fortran = np.zeros((3, 2), order="F")
        self.assertEqual(array.by_strides(fortran, np.float64)[1:], (1, 3))
        self.assertGreater(min(array.by_strides(np.zeros((3, 4))[::-1], np.float64)[1:]), 0)
        self.assertGreater(min(array.by_strides(np.broadcast_to(0.0, (3, 4)), np.float64)[1:]), 0)

    def test_ids_are_whole_and_fit(self):
        mesh = grid(2)
        with self.assertRaises(TypeError):
            mesh.raise_flags("vertex", [1.0], 1)
        with self.assertRaises(OverflowError):
            mesh.raise_flags("vertex", [2**32], 1)  # not vertex 0
        with self.assertRaises(ValueError):
            mesh.raise_flags("vertex", [[1]], 1)
        mesh.raise_flags("vertex", np.array([8], np.uint64), 1)
        self.assertEqual(mesh.flags("vertex")[8], 1)


class Out(unittest.TestCase):
    def test_arrays_of_the_caller_are_filled(self):
        mesh = grid(4, 3)
        storage = np.full((30, 2), np.nan)
        self.assertTrue((mesh.points(storage[5:25]) == mesh.points()).all())
        self.assertTrue((storage[5:25] == mesh.points()).all() and np.isnan(storage[[4, 25]]).all())
        strided = np.full((20, 4), np.nan)
        mesh.points(strided[:, ::2])
        self.assertTrue((strided[:, ::2] == mesh.points()).all() and np.isnan(strided[:, 1::2]).all())
        for dtype, order in ((np.float32, "C"), (np.float64, "F")):
            self.assertTrue((mesh.points(np.zeros((20, 2), dtype, order)) == mesh.points()).all())
        for get, shape in (
            (mesh.faces, (12, 4)),
            (mesh.edges, (31, 2)),
            (mesh.edge_faces, (31, 2)),
            (mesh.valences, (20,)),
        ):
            for dtype in (np.int32, np.int64):
                out = np.zeros(shape, dtype)
                self.assertIs(get(out), out)
                self.assertTrue((out == get()).all())
        self.assertTrue((mesh.flags("edge", np.ones(31, np.int32)) == 0).all())
        self.assertTrue(np.allclose(mesh.quality("max_angle", np.zeros(12)), 90))

    def test_wrong_shapes(self):
        mesh = grid(4, 3)
        for call in [
            lambda: mesh.points(np.zeros((19, 2))),
            lambda: mesh.points(np.zeros((20, 3))),
            lambda: mesh.faces(np.zeros((13, 4), np.int32)),
            lambda: mesh.edges(np.zeros((2, 31), np.int32)),
            lambda: mesh.valences(np.zeros(21, np.int32)),
            lambda: mesh.quality("area", np.zeros(11)),
        ]:
            self.assertRaises(ValueError, call)
        locked = np.zeros((20, 2))
        locked.flags.writeable = False
        self.assertRaises(ValueError, lambda: mesh.points(locked))
