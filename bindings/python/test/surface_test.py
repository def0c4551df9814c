import unittest

import numpy as np
from grid import grid

import alphamst

CORNERS = np.array([[0, 0], [3, 0], [3, 3], [0, 3]])


class Surface(unittest.TestCase):
    def test_set(self):
        mesh = grid(3)
        before = mesh.checksum()
        mesh.set_surface_to_mesh()
        mesh.set_surface(CORNERS, [[0, 1, 2], [0, 2, 3]])
        mesh.set_surface(np.hstack([CORNERS, CORNERS])[:, :2], np.array([[0, 1, 2], [0, 2, 3]], np.int8))
        self.assertEqual((mesh.copy().checksum(), mesh.revision), (before, 0))

    def test_refused(self):
        mesh = grid(3)
        for error, points, triangles in [
            (alphamst.RangeError, CORNERS, [[0, 1, 2], [0, 2, 4]]),
            (alphamst.RangeError, CORNERS, [[-1, 0, 1]]),
            (alphamst.RangeError, CORNERS, np.zeros((0, 3), int)),
            (alphamst.RangeError, np.zeros((0, 2)), [[0, 1, 2]]),  # none, not the mesh
            (alphamst.NotFiniteError, [[0, 0], [1, 0], [np.nan, 1]], [[0, 1, 2]]),
            (ValueError, np.zeros((4, 3)), [[0, 1, 2]]),
            (ValueError, CORNERS, np.zeros((1, 4), int)),
        ]:
            self.assertRaises(error, lambda: mesh.set_surface(points, triangles))
