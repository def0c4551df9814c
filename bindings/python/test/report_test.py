import math
import unittest

import numpy as np
from grid import grid_with_square, square

import alphamst
from alphamst import report as module


class Report(unittest.TestCase):
    def test_keys_tell_themselves_apart(self):
        mesh, patches = grid_with_square()
        report = mesh.adapt(1.26, patches)
        for at in (report, report[0]):
            self.assertEqual((at.status, at.faces_before, at.faces_after, at.faces_wanted), (0, 36, 45, 45))
            self.assertEqual((at.singular_before, at.singular_bound, at.unused_option), (0, 0, -1))
            self.assertEqual(at.singular_after, len(mesh.singularities()))
            self.assertTrue(0 <= at.candidate <= 1000)
            self.assertEqual((at.alpha, at.area_gained), (45 / 36, 0))
            self.assertAlmostEqual(at.quality_before, 1)
            self.assertTrue(0 < at.quality_after < 1 and 0 <= at.seconds < 60)
            self.assertTrue(0.2 < at.size_error_before < 0.6)  # the old faces are 1.26 times too large
            self.assertTrue(0 < at.size_error_after < 1)
            self.assertTrue(0.125 < at.least_area_after < at.least_area_before)
            self.assertTrue(0.1 < at.time_step < 1)
            self.assertTrue(0.2 < at.shortest_edge_after < at.shortest_edge_before)
            self.assertTrue(at.aspect_ratio_before < at.aspect_ratio_after < 10)
            for name, key in module.KEYS.items():
                self.assertEqual(getattr(at, name), at.get(key))
                self.assertIs(type(at.get(key)), int if key < 1000 else float)
        self.assertTrue(math.isnan(mesh.smooth().size_error_after))  # which wants no sizes
        self.assertRaises(AttributeError, lambda: report.faces)
        for key in (999, 1999):
            self.assertRaises(alphamst.NotFoundError, lambda: report.get(key))
        for patch in (1, -1):
            self.assertRaises(alphamst.RangeError, lambda: report[patch])
        self.assertEqual(report.valence_before(4), 81)
        self.assertEqual(report.valence_after(3) + report.valence_after(5), report.singular_after)
        self.assertNotEqual(report.valence_before(4, 0), 81)

    def test_origins(self):
        mesh, patches = grid_with_square()
        old = mesh.copy()
        report = mesh.adapt(2, patches)
        sizes = mesh.n_vertices, mesh.n_edges, mesh.n_faces
        mesh.close()
        patches.close()  # a report outlives both
        vertex, edge, face = (report.origin(entity) for entity in ("vertex", "edge", "face"))
        self.assertEqual((len(vertex), len(edge), len(face)), sizes)
        self.assertEqual((face == -1).sum(), 72)
        self.assertEqual(sorted(face[face >= 0]), sorted(set(range(100)) - set(square(10, 2, 8))))
        self.assertEqual((edge >= 0).sum(), 220 - 60)  # all but those inside the square
        self.assertEqual(edge.max(), old.n_edges - 1)
        self.assertTrue((report.origin("edge", np.zeros(len(edge), np.int32)) == edge).all())
        self.assertRaises(ValueError, lambda: report.origin("edge", np.zeros(3, np.int32)))
        self.assertRaises(alphamst.ArgumentError, lambda: report.origin(3))
