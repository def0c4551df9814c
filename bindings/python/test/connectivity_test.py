import unittest

import numpy as np
from grid import faces, grid, points

import alphamst
from alphamst import Mesh


class Connectivity(unittest.TestCase):
    def test_ids_index_arrays(self):
        mesh = grid(4, 3)
        xy, corners = mesh.points(), mesh.faces()
        self.assertTrue((corners == faces(4, 3)).all() and corners.dtype == np.int32)
        self.assertEqual(xy[corners[6, 0]].tolist(), [2, 1])  # face 6 is (2, 1)
        pairs, sides = mesh.edges(), mesh.edge_faces()
        self.assertTrue((pairs[:, 0] < pairs[:, 1]).all())
        self.assertEqual((sides == -1).sum(), 2 * (4 + 3))
        for (start, end), (left, right) in zip(pairs, sides):
            along = [left >= 0 and self.has_side(corners[left], start, end)]
            along.append(right >= 0 and self.has_side(corners[right], end, start))
            if right >= 0:
                self.assertEqual(along, [True, True])  # left along, right back
            else:
                self.assertTrue(along[0] or self.has_side(corners[left], end, start))

    @staticmethod
    def has_side(corners, start, end):
        at = corners.tolist()
        return at[(at.index(start) + 1) % 4] == end

    def test_find_edges(self):
        mesh = grid(4, 3)
        self.assertEqual(mesh.find_edges(mesh.edges()).tolist(), list(range(31)))
        self.assertEqual(mesh.find_edges([[1, 0], [0, 6], [0, 19]])[1:].tolist(), [-1, -1])
        self.assertEqual(mesh.find_edges(np.zeros((0, 2), int)).tolist(), [])
        with self.assertRaises(alphamst.RangeError):
            mesh.find_edges([[-1, 0]])
        with self.assertRaises(ValueError):
            mesh.find_edges([[1, 2, 3]])

    def test_valences_and_singularities(self):
        wanted = [4 - (i in (0, 4)) - (j in (0, 3)) for j in range(4) for i in range(5)]
        self.assertEqual(grid(4, 3).valences().tolist(), wanted)
        self.assertEqual(grid(4, 3).singularities().tolist(), [])
        corners = [[(v >> c) & 1 for c in range(3)] for v in range(8)]
        cube = Mesh(
            corners, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        )
        self.assertEqual(cube.singularities().tolist(), list(range(8)))

    def test_pairs_of_triangles(self):
        fold = np.column_stack([points(1, 1), [0, 0, 0, 1.0]])
        mesh = Mesh(fold, [[0, 1, 2], [1, 3, 2]], sharp_angle=10, keep_boundary=1)
        self.assertEqual(mesh.crossed_edges().shape[1], 2)
        split = Mesh(points(1, 1), faces(1, 1), quadrangulate=1).split_edges()
        self.assertEqual((split.shape[1], len(split) >= 0), (3, True))

    def test_faces_around_vertices(self):
        mesh = grid(4)
        offsets, around = mesh.vertex_faces()
        self.assertEqual(np.diff(offsets)[[0, 1, 6]].tolist(), [1, 2, 4])
        self.assertEqual((offsets[0], offsets[-1]), (0, len(around)))
        corners = mesh.faces()
        for v in range(mesh.n_vertices):
            for f in around[offsets[v] : offsets[v + 1]]:
                self.assertIn(v, corners[f])
