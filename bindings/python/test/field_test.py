import unittest

import numpy as np
from grid import grid, grid_with_square

import alphamst
from alphamst import Mesh

COUNTS = {"vertex": 16, "edge": 24, "face": 9}


class Fields(unittest.TestCase):
    def test_of_each_entity(self):
        for entity, n in COUNTS.items():
            mesh = grid(3)
            mesh.set_field(entity, "height", range(n), carry="inherit")
            self.assertEqual(mesh.field(entity, "height").tolist(), list(range(n)))
            pairs = np.array([[10.0 * i, 10.0 * i + 1] for i in range(n)])
            mesh.set_field(entity, "velocity", np.hstack([pairs, pairs])[:, :2], carry="drop")  # not packed
            self.assertTrue((mesh.field(entity, "velocity") == pairs).all())
            for other in COUNTS.keys() - {entity}:
                self.assertRaises(alphamst.NotFoundError, lambda: mesh.field(other, "height"))
            mesh.set_field(entity, "height", np.zeros(n), carry="drop")
            self.assertFalse(mesh.field(entity, "height").any())
            mesh.remove_field(entity, "height")
            self.assertRaises(LookupError, lambda: mesh.field(entity, "height"))
            self.assertTrue((mesh.copy().field(entity, "velocity") == pairs).all())
            self.assertEqual(mesh.revision, 0)

    def test_into_the_callers_array(self):
        mesh = grid(2)
        mesh.set_field("face", "one", [1, 2, 3, 4], carry="inherit")
        two = [[1, 5], [2, 6], [3, 7], [4, 8]]
        mesh.set_field("face", "two", two, carry="inherit")
        out = np.zeros(4)
        self.assertIs(mesh.field("face", "one", out), out)
        self.assertEqual(out.tolist(), [1, 2, 3, 4])
        self.assertEqual(mesh.field("face", "one", np.zeros((4, 4))[:, 1]).tolist(), [1, 2, 3, 4])
        self.assertEqual(mesh.field("face", "one", np.zeros((4, 1))).tolist(), [[1], [2], [3], [4]])
        self.assertEqual(mesh.field("face", "two", np.zeros((4, 2), np.float32)).tolist(), two)
        self.assertRaises(ValueError, lambda: mesh.field("face", "two", np.zeros(8)))
        self.assertRaises(ValueError, lambda: mesh.field("face", "one", np.zeros(3)))

    def test_carried(self):
        mesh, patches = grid_with_square()

        def linear():
            return mesh.points() @ [1, -3] + 2

        def total(name):
            return (mesh.field("face", name) * mesh.quality("area")).sum()

        mesh.set_field("vertex", "linear", linear(), carry="linear")
        for carry in ("conserve", "average"):
            mesh.set_field("face", carry, np.sin(np.arange(100)), carry=carry)
        mesh.set_field("face", "name", range(100), carry="inherit")
        mesh.set_field("edge", "gone", range(220), carry="drop")
        before, start = total("conserve"), mesh.mark()
        report = mesh.adapt(2, patches)
        self.assertLess(abs(mesh.field("vertex", "linear") - linear()).max(), 1e-12)
        self.assertLess(abs(total("conserve") - before), 1e-12)
        self.assertLess(abs(total("average") - before), 1e-12)
        self.assertTrue((mesh.field("face", "conserve") != mesh.field("face", "average")).any())
        origin = report.origin("face")
        self.assertTrue((mesh.field("face", "name")[origin >= 0] == origin[origin >= 0]).all())
        self.assertRaises(alphamst.NotFoundError, lambda: mesh.field("edge", "gone"))
        mesh.rollback(start)
        self.assertEqual(mesh.field("edge", "gone").tolist(), list(range(220)))

    def test_what_meshes_share(self):
        mesh, patches = grid_with_square()
        old = mesh.copy()
        mesh.adapt(2, patches)
        rows = old.overlap(mesh)
        self.assertEqual(rows.before.dtype, np.int32)
        self.assertTrue((np.diff(rows.after) >= 0).all())
        self.assertTrue(np.allclose(np.bincount(rows.before, rows.area), old.quality("area")))
        self.assertTrue(np.allclose(np.bincount(rows.after, rows.area), mesh.quality("area")))
        fine = grid(30)  # more rows than are made room for at first
        fine.set_points(fine.points() / 30)
        coarse = Mesh([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2, 3]])
        self.assertEqual(len(coarse.overlap(fine).area), 900)
        self.assertEqual(len(mesh.overlap(grid(1)).area), 1)  # what lies outside has no rows
        curved = Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1]], [[0, 1, 2, 3]])
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.overlap(curved))

    def test_refused(self):
        mesh = grid(3)
        for error, given, carry in [
            (alphamst.RangeError, ("face", "a", range(8)), "inherit"),
            (alphamst.ArgumentError, ("face", "", range(9)), "inherit"),
            (alphamst.NotFiniteError, ("face", "a", [np.inf] * 9), "inherit"),
            (alphamst.RangeError, ("face", "a", np.zeros((9, 0))), "inherit"),
            (alphamst.ArgumentError, ("face", "a", range(9)), "linear"),
            (alphamst.ArgumentError, ("edge", "a", range(24)), "conserve"),
            (alphamst.ArgumentError, ("face", "size", range(9)), "inherit"),
            (alphamst.RangeError, ("vertex", "size", range(16)), "inherit"),
            (ValueError, ("face", "a", range(9)), "copied"),
            (ValueError, ("face", "a", np.zeros((9, 1, 1))), "inherit"),
        ]:
            self.assertRaises(error, lambda: mesh.set_field(*given, carry=carry))
        with self.assertRaises(alphamst.RangeError) as caught:
            mesh.set_field("vertex", "size", range(8, -8, -1), carry="linear")
        self.assertEqual((caught.exception.entity, caught.exception.id), ("vertex", 8))
        self.assertRaises(alphamst.NotFoundError, lambda: mesh.remove_field("face", "a"))
