import unittest

import numpy as np
from grid import grid

import alphamst
from alphamst import Mesh, Options
from alphamst import options as module

DEFAULTS = {
    "seed": 0,
    "smooth_steps": 20,
    "repair_patches": 1,
    "candidates": 16,
    "node_limit": 1000,
    "quadrangulate": 0,
    "edit_boundary": 0,
    "strategy": 0,
    "align": 0,
    "chart": 0,
    "keep_boundary": 0,
    "starts": 1,
    "buffer_layers": 2,
    "min_quality": 0.0,
    "min_convexity": 0.6,
    "patch_faces": 100.0,
    "tolerance": 0.5,
    "effort": 1.0,
    "size_weight": 0.7,
    "transition": 0.5,
    "least_size": 0.125,
    "sharp_angle": 40.0,
    "size_band": 0.0,
    "min_edge": 0.0,
    "max_edge": 0.0,
    "gradation": 0.2,
    "error_order": 1.0,
}
OTHERS = {
    "seed": 2**40 + 7,
    "smooth_steps": 3,
    "repair_patches": 0,
    "candidates": 5,
    "node_limit": 10**9,
    "quadrangulate": 1,
    "edit_boundary": 1,
    "strategy": 1,
    "align": 1,
    "chart": 3,
    "keep_boundary": 1,
    "starts": 3,
    "buffer_layers": 5,
    "min_quality": 0.25,
    "min_convexity": 0.5,
    "patch_faces": 12.0,
    "tolerance": 0.25,
    "effort": 4.0,
    "size_weight": 0.3,
    "transition": 0.75,
    "least_size": 0.0625,
    "sharp_angle": 25.0,
    "size_band": 0.75,
    "min_edge": 0.5,
    "max_edge": 7.0,
    "gradation": 0.3,
    "error_order": 2.0,
}


def settings(options):
    return {name: getattr(options, name) for name in module.KEYS}


class Settings(unittest.TestCase):
    def test_defaults(self):
        self.assertEqual(settings(Options()), DEFAULTS)
        self.assertEqual({type(value) for value in settings(Options()).values()}, {int, float})
        self.assertEqual(module.Settings.__annotations__.keys() - {"edges"}, DEFAULTS.keys())

    def test_come_back(self):
        self.assertEqual(settings(Options(**OTHERS)), OTHERS)
        options = Options()
        for name, value in OTHERS.items():
            setattr(options, name, value)
            self.assertEqual(settings(options), {**DEFAULTS, name: value})
            setattr(options, name, DEFAULTS[name])
        options.set(1002, 31.5)
        options.seed = np.int64(9)
        self.assertEqual((options.get(0), options.patch_faces), (9, 31.5))

    def test_refused(self):
        options = Options()
        self.assertRaises(TypeError, lambda: Options(sead=7))
        self.assertRaises(TypeError, lambda: Options(get=7))
        for name, value, error in [
            ("sead", 1, AttributeError),
            ("seed", 1.5, TypeError),
            ("seed", 2**63, OverflowError),
            ("candidates", 0, alphamst.RangeError),
            ("transition", 0.01, alphamst.RangeError),
            ("min_quality", np.nan, alphamst.NotFiniteError),
            ("effort", "much", TypeError),
        ]:
            self.assertRaises(error, lambda: setattr(options, name, value))
        self.assertRaises(alphamst.NotFoundError, lambda: options.set(99, 1))
        self.assertRaises(alphamst.NotFoundError, lambda: options.get(1099))
        self.assertRaises(TypeError, lambda: grid(2).clean(options=options, seed=7))

    def test_edges_that_no_pair_crosses(self):
        xy, triangles = [[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [2, 3, 0]]
        options = Options(edges=[[2, 0]])
        self.assertEqual(options.edges.tolist(), [[2, 0]])
        self.assertGreater(Mesh(xy, triangles, options=options).n_faces, 1)
        options.edges = []
        self.assertEqual(options.edges.shape, (0, 2))
        mesh = Mesh(xy, triangles, options=options)
        self.assertEqual(
            (mesh.n_faces, mesh.crossed_edges().shape, mesh.split_edges().shape), (1, (0, 2), (0, 3))
        )
        split = Mesh(xy, triangles, quadrangulate=1).split_edges()
        self.assertEqual(sorted(split[:, 2]), list(range(4, 9)))
        options.edges = [[3, 1]]
        self.assertRaises(alphamst.NotFoundError, lambda: Mesh(xy, triangles, options=options))
        self.assertRaises(ValueError, lambda: Options(edges=[[1, 2, 3]]))
