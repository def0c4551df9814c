import unittest

from grid import grid_with_square

import alphamst
from alphamst import Patches


class Savepoints(unittest.TestCase):
    def test_rollback_and_forget(self):
        mesh, patches = grid_with_square()
        before, first = mesh.checksum(), mesh.mark()
        self.assertEqual(first, mesh.revision)
        mesh.adapt(2, patches)
        changed, second = mesh.checksum(), mesh.mark()
        mesh.adapt(0.5, patches)
        mesh.rollback(second)
        self.assertEqual((mesh.checksum(), mesh.revision), (changed, second))
        mesh.rollback(first)
        self.assertEqual((mesh.checksum(), mesh.revision), (before, first))
        self.assertRaises(alphamst.NotFoundError, lambda: mesh.rollback(second))
        mesh.forget(first)
        self.assertEqual(mesh.checksum(), before)
        self.assertRaises(alphamst.NotFoundError, lambda: mesh.forget(first))

    def test_patches_are_stale_until_their_revision_returns(self):
        mesh, patches = grid_with_square()
        others = Patches(mesh)
        others.add_rings(0, 1)
        start = mesh.mark()
        mesh.adapt(2, patches)
        self.assertRaises(alphamst.StaleError, lambda: others.faces(0))
        self.assertRaises(alphamst.StaleError, lambda: mesh.adapt(2, others))
        mesh.rollback(start)
        self.assertEqual(others.faces(0).tolist(), [0])
