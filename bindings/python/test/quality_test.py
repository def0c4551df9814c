import math
import unittest

import numpy as np
from grid import faces, grid, points

import alphamst
from alphamst import Mesh, quality


class Quality(unittest.TestCase):
    def test_each_metric_by_its_own_value(self):
        mesh = Mesh([[0, 0], [4, 0], [2, 3], [0, 1]], [[0, 1, 2, 3]])
        self.assertEqual(list(quality.METRICS.values()), list(range(20)))
        values = {metric: mesh.quality(metric)[0] for metric in quality.METRICS}
        for metric, value in {
            "area": 7,
            "max_angle": 135,
            "min_angle": math.degrees(math.atan(1.5)),
            "edge_ratio": 4,
            "warpage": 1,
        }.items():
            self.assertAlmostEqual(values[metric], value)
        for metric, number in quality.METRICS.items():
            self.assertEqual(mesh.quality(number)[0], values[metric])
            summary = mesh.summary(metric)
            self.assertEqual((summary.count, summary.stddev), (1, 0))
            self.assertTrue(summary.min == summary.max == summary.mean == values[metric])

    def test_unit_squares_are_ideal(self):
        mesh = grid(3, 2)
        for metric in quality.METRICS:
            ideal = 90 if "angle" in metric else 0 if metric in ("oddy", "skew", "taper") else 1
            self.assertTrue(np.allclose(mesh.quality(metric), ideal, atol=1e-12), metric)

    def test_summary_is_that_of_the_values(self):
        xy = points(4, 1)
        xy[:, 0] **= 2  # columns of width 1, 3, 5, 7
        mesh = Mesh(xy, faces(4, 1))
        self.assertTrue(np.allclose(mesh.quality("area"), [1, 3, 5, 7]))
        summary = mesh.summary("area")
        self.assertEqual((summary.count, summary.min, summary.max, summary.mean), (4, 1, 7, 4))
        self.assertAlmostEqual(summary.stddev, math.sqrt(5))
        self.assertTrue(0 < mesh.summary("aspect_ratio").acceptable < 4)
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.summary(20))
        self.assertRaises(ValueError, lambda: mesh.quality("beauty"))
