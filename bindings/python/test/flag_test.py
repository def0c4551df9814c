import unittest

import numpy as np
from grid import faces, grid, points

import alphamst
from alphamst import Flag, Mesh

COUNTS = {"vertex": 16, "edge": 24, "face": 9}


class Flags(unittest.TestCase):
    def test_of_each_entity(self):
        for entity, n in COUNTS.items():
            mesh = grid(3)
            mesh.raise_flags(entity, [0, 8], Flag.FIXED | Flag.CORNER)
            self.assertEqual(mesh.flags(entity).tolist(), [5 if i in (0, 8) else 0 for i in range(n)])
            for other in COUNTS.keys() - {entity}:
                self.assertFalse(mesh.flags(other).any())
            mesh.raise_flags(entity, None, Flag.FEATURE)
            mesh.lower_flags(entity, [0], Flag.FIXED)
            self.assertEqual(mesh.flags(entity).tolist(), [{0: 6, 8: 7}.get(i, 2) for i in range(n)])
            mesh.set_flags(entity, None, Flag.FEATURE | Flag.CORNER, Flag.FEATURE | Flag.FIXED)
            self.assertEqual(mesh.flags(entity).tolist(), [3 if i == 8 else 2 for i in range(n)])
            self.assertEqual(mesh.revision, 0)

    def test_refused(self):
        mesh = grid(3)
        before = mesh.checksum()
        mesh.raise_flags("face", [], Flag.FIXED)  # none, not all
        mesh.raise_flags("face", np.zeros(0, np.int32), Flag.FIXED)
        for entity, which, flags in (("vertex", [0, 16], 1), ("face", [-1], 1), ("face", None, 8)):
            self.assertRaises(alphamst.RangeError, lambda: mesh.raise_flags(entity, which, flags))
        self.assertEqual(mesh.checksum(), before)

    def test_features(self):
        flat = points(4, 3)
        fold = np.column_stack([flat, np.maximum(flat[:, 0] - 2, 0)])  # upwards by 45 degrees from x = 2 on
        mesh = Mesh(fold, faces(4, 3))
        self.assertEqual(mesh.detect_features(46), 0)
        self.assertFalse(mesh.flags("edge").any())
        self.assertEqual(mesh.detect_features(44), 3)
        at_fold = (flat[mesh.edges(), 0] == 2).all(axis=1)
        self.assertTrue((mesh.flags("edge") == Flag.FEATURE * at_fold).all())
        self.assertEqual(np.flatnonzero(mesh.flags("vertex") == Flag.CORNER).tolist(), [2, 17])
        self.assertRaises(alphamst.RangeError, lambda: mesh.detect_features(181))
        self.assertRaises(alphamst.NotFiniteError, lambda: mesh.detect_features(np.nan))
