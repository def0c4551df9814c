import unittest

import numpy as np
from grid import grid

from alphamst import ArgumentError


class Geometry(unittest.TestCase):
    def test_of_a_grid(self):
        mesh = grid(4)
        centroids, normals = mesh.geometry("centroids"), mesh.geometry("normals")
        self.assertEqual(list(centroids[5]), [1.5, 1.5])
        np.testing.assert_array_equal(mesh.geometry("lengths"), np.ones(mesh.n_edges))
        middles = mesh.points()[mesh.edges()].mean(axis=1)
        away = middles - centroids[mesh.edge_faces()[:, 0]]
        np.testing.assert_allclose((normals * away).sum(axis=1), 0.5)
        with self.assertRaises(ArgumentError):
            mesh.geometry(99)

    def test_into_an_array_of_the_caller(self):
        mesh = grid(4)
        out = np.zeros((mesh.n_edges, 2))
        self.assertIs(mesh.geometry("normals", out), out)
        np.testing.assert_array_equal(out, mesh.geometry("normals"))
