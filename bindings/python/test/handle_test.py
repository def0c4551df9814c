"""Ends of objects, in every order and by every way; what is left still works."""

import copy
import gc
import itertools
import threading
import unittest
import weakref

from grid import faces, grid, grid_with_square, points

import alphamst
from alphamst import Context, Mesh, Options, Patches


def new_world():
    context = Context()
    mesh, patches = grid_with_square(context=context)
    return [context, mesh, patches, mesh.smooth(patches)]


USES = [
    lambda context: context.set_threads(1),
    lambda mesh: mesh.smooth().faces_after == 100 or 1 / 0,
    lambda patches: len(patches.boundary(0)) == 24 or 1 / 0,
    lambda report: report[0].faces_after == 36 or 1 / 0,
]


class Ends(unittest.TestCase):
    def test_closed_in_any_order(self):
        for order in itertools.permutations(range(4)):
            world = new_world()
            for k, which in enumerate(order):
                world[which].close()
                self.assertTrue(world[which].closed)
                for rest in order[k + 1 :]:
                    USES[rest](world[rest])
                world[which].close()  # again does nothing

    def test_collected_in_any_order(self):
        for order in itertools.permutations(range(4)):
            world = new_world()
            for k, which in enumerate(order):
                world[which] = None
                gc.collect()
                for rest in order[k + 1 :]:
                    USES[rest](world[rest])

    def test_a_circle_is_collected(self):
        def made():
            mesh = grid(2)
            mesh.context.set_progress(lambda fraction, stage: mesh.n_faces)
            mesh.set_projection(lambda markers, xy: xy + mesh.n_faces)
            return weakref.ref(mesh)

        seen = made()
        gc.collect()
        self.assertIsNone(seen())

    def test_with(self):
        with grid(2) as mesh:
            self.assertEqual(mesh.n_faces, 4)
        self.assertTrue(mesh.closed)
        self.assertEqual(repr(mesh), "<Mesh, closed>")

    def test_use_after_close(self):
        mesh, patches = grid_with_square()
        context, options, report = Context(), Options(), mesh.smooth(patches)
        for handle in (context, options, report, patches):
            handle.close()
        for call in [
            lambda: context.set_threads(1),
            lambda: context.set_progress(print),
            lambda: context.progress,
            lambda: Mesh(points(1, 1), faces(1, 1), context=context),
            lambda: options.seed,
            lambda: setattr(options, "seed", 1),
            lambda: mesh.clean(options=options),  # not: all defaults
            lambda: mesh.smooth(patches),  # not: the whole mesh
            lambda: patches.add_rings(0, 1),
            lambda: report.status,
            lambda: report.origin("face"),
        ]:
            self.assertRaisesRegex(ValueError, "is closed", call)
        mesh.close()
        for call in (
            mesh.points,
            mesh.faces,
            mesh.singularities,
            mesh.copy,
            mesh.check,
            mesh.mark,
            mesh.clean,
            lambda: Patches(mesh),
            lambda: mesh.set_projection(None),
        ):
            self.assertRaisesRegex(ValueError, "is closed", call)

    def test_no_second_owner(self):
        for handle in new_world() + [Options()]:
            self.assertRaises(TypeError, lambda: copy.copy(handle))
            self.assertRaises(TypeError, lambda: copy.deepcopy(handle))

    def test_wrong_kinds(self):
        mesh, patches = grid_with_square()
        for call in [
            lambda: mesh.smooth(mesh),
            lambda: Patches(patches),
            lambda: mesh.clean(options=7),
            lambda: Patches(None),
            lambda: Mesh(points(1, 1), faces(1, 1), context=mesh),
        ]:
            self.assertRaises(TypeError, call)


class Threads(unittest.TestCase):
    def run_together(self, jobs):
        failures = []

        def guarded(job):
            try:
                job()
            except BaseException as failure:
                failures.append(failure)

        threads = [threading.Thread(target=guarded, args=(job,)) for job in jobs]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return failures

    def test_read_one_mesh_and_end_what_they_made(self):
        mesh, _ = grid_with_square()
        digest = mesh.checksum()
        several = [Patches(mesh) for _ in range(16)]
        for patches in several:
            patches.add_rings(60, 2)  # changes patches, and needs the mesh alone

        def read(i):
            own, patches = mesh.copy(), several[i]
            with self.assertRaises(alphamst.RangeError) as caught:
                patches.faces(i + 1)
            self.assertEqual(caught.exception.patch, i + 1)  # errors stay on their thread
            self.assertEqual(own.checksum(), digest)
            self.assertEqual(mesh.overlap(own).area.sum(), 100)
            self.assertEqual(len(patches.faces(0)), 16)

        self.assertEqual(self.run_together([lambda i=i: read(i) for i in range(16)]), [])

    def test_a_mesh_at_work_refuses_others(self):
        """From the progress of one thread another one is started: the mesh is certainly at work."""
        context = Context()
        mesh, patches = grid_with_square(context=context)
        other = grid(3, context=context)
        refused, seen = [], []

        def try_all():
            for call in (
                mesh.points,
                mesh.smooth,
                mesh.close,
                lambda: patches.faces(0),
                lambda: len(patches),
                lambda: context.set_threads(2),
                other.smooth,
                patches.close,
            ):
                with self.assertRaises(alphamst.StateError) as caught:
                    call()
                refused.append(str(caught.exception))
            seen.append((other.n_faces, context.progress))  # both are allowed
            grid(2).smooth()  # another context shares nothing

        def once(fraction, stage):
            if not refused:
                self.assertEqual(self.run_together([try_all]), [])

        context.set_progress(once)
        report = mesh.adapt(2, patches)
        self.assertEqual(report.faces_after, 72)
        self.assertEqual(len(refused), 8)
        self.assertIn("in use", refused[0])
        self.assertEqual(seen[0][0], 9)
        context.set_progress(None)
        mesh.smooth()  # free again
        mesh.close()

    def test_copies_in_contexts_of_their_own(self):
        mesh = grid(12)
        mesh.set_projection(lambda markers, xy: 1 / 0)
        copies = [mesh.copy(Context()) for _ in range(4)]
        self.assertEqual(len({id(one.context) for one in [mesh, *copies]}), 5)
        self.assertEqual(
            self.run_together([lambda one=one: one.adapt(2, edit_boundary=1) for one in copies]), []
        )
        self.assertEqual(len({one.checksum() for one in copies}), 1)

    def test_others_go_on(self):
        """While an operation runs the interpreter's lock is free."""
        jobs = [lambda: grid(20).adapt(2) for _ in range(4)]
        self.assertEqual(self.run_together(jobs), [])
