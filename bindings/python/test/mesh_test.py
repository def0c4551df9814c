import pathlib
import tempfile
import unittest

import numpy as np
from grid import faces, grid, points

import alphamst
from alphamst import Mesh


class Numbers(unittest.TestCase):
    def test_counts_tell_themselves_apart(self):
        mesh = grid(4, 3)
        self.assertEqual(
            (mesh.dim, mesh.n_vertices, mesh.n_edges, mesh.n_faces, mesh.revision), (2, 20, 31, 12, 0)
        )
        lifted = Mesh(np.column_stack([points(4, 3), np.full(20, 2.5)]), faces(4, 3))
        self.assertEqual(lifted.dim, 3)
        self.assertTrue((lifted.points()[:, 2] == 2.5).all())

    def test_checksum_check_copy(self):
        mesh = grid(3)
        same = mesh.copy()
        self.assertEqual(same.checksum(), mesh.checksum())
        self.assertIs(same.context, mesh.context)
        xy = mesh.points()
        xy[5] = 2.5, 2.5  # turns corners over
        mesh.set_points(xy)
        self.assertNotEqual(same.checksum(), mesh.checksum())
        self.assertTrue((same.points() == points(3, 3)).all())
        self.assertIsNone(same.check())
        with self.assertRaises(alphamst.AlphaMSTError):
            mesh.check()
        for wrong, error in [
            (np.zeros((16, 3)), ValueError),
            (np.zeros((15, 2)), alphamst.RangeError),
            (np.full((16, 2), np.nan), alphamst.NotFiniteError),
        ]:
            with self.assertRaises(error):
                mesh.set_points(wrong)
        mesh.set_points(points(3, 3)[:, ::-1])  # not packed
        self.assertTrue((mesh.points() == points(3, 3)[:, ::-1]).all())


class Creation(unittest.TestCase):
    def test_triangles(self):
        xy, corners = points(2, 1), faces(2, 1)
        triangles = np.vstack([corners[:, :3], corners[:, [0, 2, 3]]])
        mesh = Mesh(xy, triangles)
        self.assertEqual(mesh.n_faces, 2)
        mixed = [corners[0], [*corners[1, :3], -1], [*corners[1, [0, 2, 3]], -1]]
        self.assertEqual(Mesh(xy, mixed).n_faces, 2)
        split = Mesh(xy, triangles, quadrangulate=1)
        self.assertEqual((split.n_faces, split.n_vertices), (12, 6 + 9 + 4))

    def test_refused_arrays(self):
        xy, corners = points(2, 2), faces(2, 2)
        for given, error in [
            ((xy[:, :1], corners), alphamst.ArgumentError),
            ((xy, corners[:, :2]), alphamst.ArgumentError),
            ((xy, corners + np.int32(5)), alphamst.RangeError),
            ((xy, corners.astype(np.int64) + 2**33), alphamst.RangeError),
            ((xy * np.nan, corners), alphamst.NotFiniteError),
            ((xy, np.zeros((1, 4), int)), alphamst.NotQuadError),
            ((xy, np.zeros((0, 4), int)), alphamst.RangeError),
            ((xy, corners[0]), ValueError),
            ((xy, corners * 1.0), TypeError),
        ]:
            with self.assertRaises(error):
                Mesh(*given)

    def test_made_once(self):
        mesh = grid(2)
        with self.assertRaises(TypeError):
            mesh.__init__(points(1, 1), faces(1, 1))
        self.assertEqual(mesh.n_faces, 4)


class Files(unittest.TestCase):
    def test_come_back(self):
        mesh = grid(3, 2)
        with tempfile.TemporaryDirectory() as folder:
            for extension in ["off", "obj", "ply", "msh", "vtk", "su2"]:
                path = pathlib.Path(folder, f"grid ä.{extension}")
                self.assertIsNone(mesh.write(path))
                again = Mesh.read(path)
                self.assertEqual(again.dim, 2)
                self.assertTrue((again.points() == mesh.points()).all())
                self.assertTrue((again.faces() == mesh.faces()).all())
            picture = pathlib.Path(folder, "grid.svg")
            mesh.write(picture)
            self.assertIn("<svg", picture.read_text())
            with self.assertRaises(alphamst.UnsupportedError):
                mesh.write(f"{folder}/grid.stl")
            bad = pathlib.Path(folder, "bad.off")
            bad.write_text("OFF\n1 1\n")
            with self.assertRaises(alphamst.FormatError):
                Mesh.read(bad)
        with self.assertRaises(OSError):
            Mesh.read("nowhere.msh")
        with self.assertRaises(ValueError):
            Mesh.read("a\0b.off")
