import unittest

import numpy as np
from grid import faces, grid, grid_with_square, points, square

import alphamst
from alphamst import Context, Mesh, Options, Patches


class Operations(unittest.TestCase):
    def test_adapt(self):
        mesh, patches = grid_with_square()
        report = mesh.adapt(2, patches, seed=7, smooth_steps=40)
        self.assertEqual((report.faces_after, mesh.n_faces, report.is_partial), (72, 136, False))
        self.assertGreater(mesh.revision, 0)
        self.assertEqual(len(patches.faces(0)), 72)  # moved along
        mesh.check()
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.adapt(0, patches))
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.adapt(1, Patches(grid(2))))
        self.assertRaises(TypeError, lambda: mesh.adapt(1, patches, sead=7))
        self.assertRaises(TypeError, lambda: mesh.adapt(patches, 1))

    def test_a_patch_with_defects_is_left(self):
        mesh = grid(10)
        patches = Patches(mesh, repair_patches=0)
        patches.add_faces([55, 57])
        before = mesh.checksum()
        report = mesh.adapt(2, patches)
        self.assertTrue(report.is_partial)
        self.assertEqual(alphamst.status_name(report[0].status), "AMST_ERR_PATCH")
        self.assertEqual(mesh.checksum(), before)

    def test_reduce_singularities(self):
        mesh = grid(10)
        patches = Patches(mesh)
        patches.add_faces(square(10, 2, 7))
        mesh.adapt(2, patches)
        before = len(mesh.singularities())
        self.assertGreaterEqual(before, 4)
        report = mesh.reduce_singularities(patches)
        self.assertEqual((report.singular_before, report.singular_after), (before, 0))
        self.assertEqual((report.faces_before, report.faces_after, mesh.n_faces), (50, 25, 100))

    def test_smooth(self):
        def pushed():
            mesh = grid(8)
            xy = mesh.points().reshape(9, 9, 2)
            for j in range(1, 8):
                for i in range(1, 8):
                    xy[j, i] += (0.35, -0.3) if (i + j) % 2 == 0 else 0
            mesh.set_points(xy.reshape(-1, 2))
            return mesh

        mesh = pushed()
        before = mesh.points()
        report = mesh.smooth()
        self.assertGreater(report.quality_after, report.quality_before)
        self.assertAlmostEqual(report.quality_after, mesh.summary("scaled_jacobian").min)
        self.assertEqual(mesh.revision, 0)
        self.assertRaises(alphamst.RangeError, lambda: report[0])  # no patches
        mesh = pushed()
        patches = Patches(mesh)
        patches.add_faces(square(8, 2, 6))
        mesh.smooth(patches, smooth_steps=30)
        moved = np.flatnonzero((mesh.points() != before).any(axis=1))
        self.assertTrue(len(moved) > 0 and all(3 <= v % 9 <= 5 and 3 <= v // 9 <= 5 for v in moved))
        mesh = pushed()
        mesh.smooth(options=Options(smooth_steps=0))  # settings arrive
        self.assertTrue((mesh.points() == before).all())

    def test_clean(self):
        corners = np.vstack([faces(7, 7), faces(7, 7)[24]])
        corners[24, 3] = corners[49, 1] = 64  # a vertex of valence 2 inside the middle face
        mesh = Mesh(np.vstack([points(7, 7), [3.5, 3.5]]), corners)
        self.assertEqual(mesh.valences()[64], 2)
        report = mesh.clean()
        mesh.check()
        self.assertEqual((report.faces_before, report.faces_after), (50, mesh.n_faces))
        self.assertEqual((report.valence_before(2), report.valence_after(2)), (1, 0))
        tidy = grid(4)
        tidy.clean(seed=1)
        self.assertEqual(tidy.revision, 0)

    def test_equal_input_and_seed_equal_output(self):
        def digest(threads):
            mesh = grid(20, context=Context(threads=threads))
            patches = Patches(mesh, patch_faces=30)
            patches.decompose()
            mesh.adapt(1.5, patches, seed=7)
            return mesh.checksum()

        self.assertEqual({digest(1), digest(2), digest(0)}, {digest(1)})

    def test_whole_meshes(self):
        mesh, patches = grid_with_square()
        mesh.adapt(2, patches)
        report = mesh.adapt(1.2, seed=3)
        self.assertEqual((report.faces_before, mesh.n_faces), (136, round(1.2 * 136)))
        before = len(mesh.singularities())
        report = mesh.reduce_singularities()
        self.assertEqual(report.singular_before, before)
        self.assertLessEqual(len(mesh.singularities()), before)
