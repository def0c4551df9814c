import unittest

import numpy as np
from grid import grid

from alphamst import RangeError


class Indicator(unittest.TestCase):
    def test_sizes_from_an_indicator(self):
        mesh, ones = grid(4), np.ones(16)
        self.assertAlmostEqual(mesh.size_from_indicator(ones, faces=64), 64, delta=0.064)
        np.testing.assert_allclose(mesh.field("vertex", "size"), 0.5, rtol=1e-3)
        self.assertAlmostEqual(mesh.size_from_indicator(ones, tolerance=0.25, error_order=2), 64)
        self.assertAlmostEqual(
            mesh.size_from_indicator(ones, tolerance=0.25, error_order=2, min_edge=1), 16
        )
        self.assertAlmostEqual(mesh.size_from_indicator(ones, tolerance=0.25, faces=32), 32, delta=0.032)

    def test_what_is_refused(self):
        mesh = grid(4)
        with self.assertRaises(RangeError):
            mesh.size_from_indicator(np.ones(16))
        with self.assertRaises(RangeError):
            mesh.size_from_indicator(np.ones(15), faces=64)
