import pathlib
import tempfile
import unittest

import numpy as np
from grid import grid, grid_with_square, square

import alphamst
from alphamst import Check, Defect, Options, Patches


class Adding(unittest.TestCase):
    def test_each_way(self):
        patches = Patches(grid(10))
        self.assertEqual((len(patches), bool(patches)), (0, True))
        self.assertEqual(patches.add_rings(2 * 11 + 2, 2), 0)  # around (2, 2)
        self.assertEqual(len(patches.faces(0)), 16)
        self.assertEqual(patches.add_ball((8, 8), 1), 1)
        self.assertEqual(len(patches.faces(1)), 4)
        self.assertEqual(patches.add_box([0, 6, -1], np.array([3, 9, 1])), 2)
        self.assertEqual(len(patches.faces(2)), 9)
        self.assertEqual(patches.add_faces([9, 8, 9, 19, 18]), 3)
        self.assertEqual(patches.faces(3).tolist(), [8, 9, 18, 19])
        for error, call in [
            (alphamst.RangeError, lambda: patches.faces(4)),
            (alphamst.RangeError, lambda: patches.faces(-1)),
            (alphamst.RangeError, lambda: patches.add_faces([100])),
            (alphamst.PatchError, lambda: patches.add_faces([])),
            (alphamst.ArgumentError, lambda: patches.add_ball((1, 1), -1)),
            (alphamst.PatchError, lambda: patches.add_ball((5, 5, 500), 1)),  # z is passed on
            (alphamst.ArgumentError, lambda: patches.add_box((5, 5), (1, 1))),
            (alphamst.RangeError, lambda: patches.add_rings(121, 1)),
            (ValueError, lambda: patches.add_ball((1,), 1)),
        ]:
            self.assertRaises(error, call)
        self.assertEqual(len(patches), 4)

    def test_decompositions(self):
        for method in ("clusters", "partition", "voronoi"):
            patches = Patches(grid(10), patch_faces=12, seed=3)
            n = patches.decompose(method)
            self.assertTrue(n == len(patches) and 4 <= n <= 20)
            found = np.concatenate([patches.faces(p) for p in range(n)])
            self.assertEqual(len(np.unique(found)), len(found))
        one = Patches(grid(10), options=Options(patch_faces=100))
        self.assertLess(one.decompose(), 4)
        self.assertRaises(alphamst.ArgumentError, lambda: one.decompose(7))
        self.assertRaises(ValueError, lambda: one.decompose("circles"))
        some = Patches(grid(10), patch_faces=12)
        self.assertEqual(some.decompose("singularities"), 0)  # a grid has none
        self.assertGreaterEqual(some.decompose("medial"), 2)


class Asking(unittest.TestCase):
    def test_boundary_and_corners(self):
        mesh = grid(10)
        patches = Patches(mesh)
        patches.add_faces(square(10, 2, 5))
        loop, found = patches.boundary(0), patches.corners(0)
        self.assertEqual((len(loop), len(found), loop[0]), (12, 4, found[0]))
        x, y = mesh.points()[loop].T
        self.assertEqual((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2, 9)  # counter-clockwise
        given = [5 * 11 + 5, 5 * 11 + 2, 2 * 11 + 3]
        patches.set_corners(0, given)
        self.assertEqual(patches.corners(0).tolist(), given)
        self.assertEqual(patches.check(0).defects, 0)
        patches.set_corners(0, given[::-1])
        self.assertEqual(patches.check(0).defects, Defect.CORNERS)
        patches.set_corners(0, [])
        self.assertEqual(patches.corners(0).tolist(), found.tolist())
        self.assertRaises(alphamst.RangeError, lambda: patches.set_corners(0, given[:2]))

    def test_defects_and_convexity(self):
        mesh = grid(10)
        patches = Patches(mesh, repair_patches=0, min_convexity=0.8)
        for faces in ([0, 1, 2, 10, 12, 20, 21, 22], [55, 57], [88, 99], [45, 44, 46, 35]):
            patches.add_faces(faces)
        self.assertIn(Defect.NOT_DISK, patches.check(0).defects)
        self.assertEqual(patches.check(0).convexity, 0)
        self.assertIn(Defect.NOT_CONNECTED, patches.check(1).defects)
        self.assertIn(Defect.PINCHED, patches.check(2).defects)
        self.assertAlmostEqual(patches.check(3).convexity, 4 / 5)
        with self.assertRaises(alphamst.PatchError) as caught:
            patches.boundary(1)
        self.assertEqual(caught.exception.patch, 1)
        strict = Patches(mesh, min_convexity=0.81)
        strict.add_faces([45, 44, 46, 35])
        self.assertEqual(strict.check(0), Check(Defect.NOT_CONVEX, patches.check(3).convexity))

    def test_prediction(self):
        mesh, patches = grid_with_square()
        self.assertEqual(patches.predict(0, 1), (36, 0))
        foreseen = patches.predict(0, 2, seed=3)
        self.assertTrue(foreseen.faces == 72 and foreseen.singularities > 0)
        self.assertEqual(mesh.adapt(2, patches, seed=3)[0].faces_after, 72)
        self.assertRaises(alphamst.ArgumentError, lambda: patches.predict(0, 0))
        self.assertRaises(alphamst.RangeError, lambda: patches.predict(1, 1))

    def test_alpha_of_a_patch(self):
        def wanted(change):
            mesh = grid(10)
            patches = Patches(mesh)
            patches.add_faces(square(10, 0, 4))
            patches.add_faces(square(10, 5, 9))
            change(patches)
            report = mesh.adapt(1.5, patches)
            return [report[p].faces_wanted for p in range(2)]

        self.assertEqual(wanted(lambda patches: None), [24, 24])
        self.assertEqual(wanted(lambda patches: patches.set_alpha(1, 3)), [24, 48])
        self.assertEqual(wanted(lambda patches: patches.set_all_alphas(2)), [32, 32])
        patches = grid_with_square()[1]
        self.assertRaises(alphamst.RangeError, lambda: patches.set_alpha(2, 1))
        self.assertRaises(alphamst.ArgumentError, lambda: patches.set_all_alphas(-1))

    def test_pictures(self):
        mesh, patches = grid_with_square()
        with tempfile.TemporaryDirectory() as folder:
            path, other = pathlib.Path(folder, "patches.svg"), pathlib.Path(folder, "mesh.svg")
            patches.write(path)
            mesh.write(other)
            self.assertIn("<svg", path.read_text())
            self.assertNotEqual(path.read_text(), other.read_text())
            self.assertRaises(alphamst.UnsupportedError, lambda: patches.write(path.with_suffix(".vtk")))
