import unittest

import numpy as np
from grid import grid, grid_with_square

import alphamst
from alphamst import Refusal


class Chords(unittest.TestCase):
    def test_queries(self):
        mesh = grid(5, 3)
        ids = mesh.chord_ids()
        self.assertEqual((len(ids), ids.min(), ids.max()), (mesh.n_edges, 0, 7))
        self.assertEqual(mesh.chords("length").sum(), 2 * mesh.n_faces)
        self.assertEqual(mesh.chords("length").dtype, np.int64)
        for edge in mesh.chords("edge"):
            found = mesh.chord(edge)
            self.assertEqual((found.closed, found.crossings), (False, 0))
            self.assertTrue((ids[found.edges] == ids[edge]).all())
        self.assertRaises(alphamst.RangeError, lambda: mesh.chord(98))
        self.assertRaises(ValueError, lambda: mesh.chords("colour"))

    def test_rings_in_and_out(self):
        mesh, patches = grid_with_square()
        before, first = mesh.checksum(), mesh.mark()
        report = mesh.insert_chords(patches, 2)
        self.assertEqual((mesh.n_faces, report.is_partial), (148, False))
        ring = int(np.flatnonzero(mesh.chords("closed"))[0])
        self.assertEqual(mesh.chords("refusal")[ring], 0)
        after = mesh.chords("singular_after")[ring]
        mesh.collapse_chord(mesh.chords("edge")[ring])
        self.assertEqual((mesh.n_faces, len(mesh.singularities())), (124, after))
        mesh.rollback(first)
        self.assertEqual(mesh.checksum(), before)

    def test_refused(self):
        mesh = grid(4)
        before = mesh.checksum()
        self.assertRaises(alphamst.ChordError, lambda: mesh.collapse_chord(0))
        self.assertRaises(alphamst.ChordError, lambda: mesh.split_chord(0))
        self.assertRaises(alphamst.RangeError, lambda: mesh.split_chord(0, 0))
        self.assertTrue((mesh.chords("refusal") == Refusal.BOUNDARY).all())
        self.assertEqual(mesh.checksum(), before)
        mesh.split_chord(0, 2, edit_boundary=1)
        self.assertEqual(mesh.n_faces, 24)
        mesh.adapt(20 / 24, strategy=1, edit_boundary=1)
        self.assertEqual(mesh.n_faces, 20)
