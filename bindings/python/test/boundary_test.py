import gc
import unittest

import numpy as np
from grid import faces, points

import alphamst
from alphamst import Mesh


def disk():
    """A square of 8 x 8 faces, bent to the disk of radius 1: 32 edges on its rim, and no corner."""
    xy = points(8, 8) / 4 - 1
    most = abs(xy).max(axis=1, keepdims=True)
    radius = np.maximum(np.linalg.norm(xy, axis=1, keepdims=True), 1e-300)
    return Mesh(xy * (most * most / radius + (1 - most) * 0.7), faces(8, 8))


def radii(mesh):
    rim = mesh.edges()[(mesh.edge_faces() == -1).any(axis=1), 0]
    return np.linalg.norm(mesh.points()[rim], axis=1)


def to_circle(markers, xy):
    return xy / np.linalg.norm(xy, axis=1, keepdims=True)


def refine(mesh):
    return mesh.adapt(4, edit_boundary=1)


class Projection(unittest.TestCase):
    def test_new_vertices_lie_on_the_circle(self):
        mesh, seen = disk(), []

        def project(markers, xy):
            seen.append((markers, xy))
            return to_circle(markers, xy)

        mesh.set_projection(project)
        self.assertTrue(0.01 < refine(mesh).area_gained < 0.1)  # what the chords had cut off the disk
        mesh.check()
        found = radii(mesh)
        self.assertTrue(mesh.n_faces == 256 and len(found) > 48 and abs(found - 1).max() <= 1e-12)
        self.assertEqual(len(seen), 2)
        for markers, xy in seen:  # they are the caller's
            self.assertEqual((markers.any(), xy.shape, markers.dtype), (False, (len(markers), 2), np.int32))

    def test_without_the_option_nobody_asks(self):
        mesh = disk()
        mesh.set_projection(lambda: 1 / 0)
        mesh.adapt(4)
        self.assertEqual(len(radii(mesh)), 32)
        mesh.set_projection(None)
        refine(mesh)
        self.assertGreater(len(radii(mesh)), 32)

    def test_copies_keep_it(self):
        calls = []

        def made():
            mesh = disk()
            mesh.set_projection(lambda *given: calls.append(1) or to_circle(*given))
            return mesh.copy()

        mesh = made()
        gc.collect()
        refine(mesh)
        self.assertTrue(abs(radii(mesh) - 1).max() <= 1e-12 and len(calls) == 2)

    def test_a_failing_one_changes_nothing(self):
        mesh = disk()
        before = mesh.checksum()
        for error, project in [
            (alphamst.ProjectionError, lambda markers, xy: None),
            (alphamst.ProjectionError, lambda markers, xy: 3 * xy),
            (alphamst.ProjectionError, lambda markers, xy: xy * np.nan),
            (ValueError, lambda markers, xy: xy[1:]),
            (TypeError, lambda xy: xy),
        ]:
            mesh.set_projection(project)
            self.assertRaises(error, lambda: refine(mesh))
        for last in (1, 2):
            calls = []

            def project(markers, xy):
                calls.append(1)
                if len(calls) == last:
                    raise KeyError(last)
                return to_circle(markers, xy)

            mesh.set_projection(project)
            self.assertRaises(KeyError, lambda: refine(mesh))
        self.assertEqual((mesh.checksum(), mesh.revision), (before, 0))
        mesh.set_projection(to_circle)
        refine(mesh)

    def test_may_ask_but_not_change(self):
        mesh, refused = disk(), []

        def project(markers, xy):
            self.assertEqual((mesh.n_faces, mesh.copy().n_faces), (64, 64))
            for change in (lambda: mesh.set_projection(None), mesh.clean):
                self.assertRaises(alphamst.StateError, change)
                refused.append(change)
            return to_circle(markers, xy)

        mesh.set_projection(project)
        refine(mesh)
        self.assertEqual(len(refused), 4)
