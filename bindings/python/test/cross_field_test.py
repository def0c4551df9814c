import unittest

import numpy as np
from grid import grid

import alphamst


class CrossField(unittest.TestCase):
    def test_computed(self):
        mesh = grid(4, 3)
        self.assertRaises(alphamst.NotFoundError, mesh.alignment)
        mesh.compute_cross_field()
        self.assertLess(mesh.alignment(), 1e-9)
        cross = mesh.field("face", "cross")
        self.assertEqual(cross.shape, (12, 3))
        self.assertTrue(np.allclose(abs(cross).max(axis=1), 1))  # along x or y
        self.assertRaises(alphamst.RangeError, lambda: mesh.compute_cross_field(smooth_steps=-1))

    def test_given(self):
        mesh = grid(2)
        turned = [np.cos(np.pi / 6), np.sin(np.pi / 6), 0]
        mesh.set_field("face", "cross", [turned] * 4, carry="inherit")
        self.assertAlmostEqual(mesh.alignment(), 30)
        self.assertRaises(
            alphamst.RangeError, lambda: mesh.set_field("face", "cross", range(4), carry="inherit")
        )
