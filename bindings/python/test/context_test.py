import contextlib
import io
import os
import subprocess
import sys
import textwrap
import unittest

from grid import grid, two_patches

import alphamst
from alphamst import Context, show_bar
from alphamst import context as module


class Stop(Exception):
    pass


OPERATIONS = [
    lambda mesh, patches: mesh.adapt(2, patches),
    lambda mesh, patches: mesh.reduce_singularities(patches),
    lambda mesh, patches: mesh.smooth(patches),
    lambda mesh, patches: mesh.clean(),
]


class Progress(unittest.TestCase):
    def test_seen(self):
        context = Context()
        mesh, patches = two_patches(context)
        seen = []
        context.set_progress(lambda fraction, stage: seen.append((fraction, stage, context.progress)))
        mesh.adapt(2, patches)
        fractions = [fraction for fraction, _, _ in seen]
        self.assertGreaterEqual(len(seen), 2)
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1)
        self.assertEqual(fractions, [asked for _, _, asked in seen])
        self.assertIn("adapt", [stage for _, stage, _ in seen])
        context.set_progress(None)
        n = len(seen)
        mesh.smooth()
        self.assertEqual(len(seen), n)

    def test_an_exception_or_true_at_any_call_changes_nothing(self):
        def throw(n):
            raise Stop(n)

        for misbehave, error in ((throw, Stop), (lambda n: True, alphamst.CancelledError)):
            for operation in OPERATIONS:
                for n in range(1, 1000):
                    context = Context()
                    mesh, patches = two_patches(context)
                    before, calls = mesh.checksum(), []

                    def progress(fraction, stage):
                        calls.append(fraction)
                        return misbehave(n) if len(calls) == n else None

                    context.set_progress(progress)
                    try:
                        operation(mesh, patches)
                        break
                    except error:
                        pass
                    self.assertEqual(len(calls), n)  # not called again
                    self.assertEqual((mesh.checksum(), mesh.revision), (before, 0))
                    context.set_progress(None)
                    operation(mesh, patches)
                self.assertGreater(n, 2)

    def test_a_function_that_is_not_fit(self):
        context = Context()
        mesh, patches = two_patches(context)
        before = mesh.checksum()
        context.set_progress(lambda: True)
        self.assertRaises(TypeError, lambda: mesh.adapt(2, patches))
        context.set_progress(7)
        self.assertRaises(TypeError, lambda: mesh.adapt(2, patches))
        self.assertEqual(mesh.checksum(), before)

    def test_may_ask_and_close_but_not_change(self):
        context = Context()
        mesh, patches = two_patches(context)
        before, refused = mesh.checksum(), set()

        def ask(fraction, stage):
            self.assertEqual((mesh.checksum(), mesh.copy().n_faces), (before, 100))
            for change in (
                mesh.smooth,
                lambda: context.set_threads(1),
                lambda: context.set_progress(None),
                mesh.mark,
                lambda: patches.add_rings(0, 1),
            ):
                try:
                    change()
                except alphamst.AlphaMSTError as failure:
                    refused.add(failure.name)

        context.set_progress(ask)
        mesh.adapt(2, patches)
        self.assertEqual(refused, {"AMST_ERR_STATE"})
        context.set_progress(lambda *_: [handle.close() for handle in (context, mesh, patches)] and None)
        self.assertEqual(mesh.adapt(1, patches).faces_before, 64)
        self.assertTrue(mesh.closed)

    def test_lives_as_long_as_meshes(self):
        seen = []
        mesh, patches = two_patches(Context(progress=lambda fraction, stage: seen.append(fraction)))
        mesh.smooth(patches)
        self.assertEqual(seen[-1], 1)

    def test_bar(self):
        class Terminal(io.StringIO):
            def isatty(self):
                return True

        for stream, written in ((Terminal(), True), (io.StringIO(), False)):
            with contextlib.redirect_stderr(stream):
                grid(4, context=Context(progress=show_bar)).smooth()
            self.assertEqual("100%" in stream.getvalue(), written)
            self.assertEqual(stream.getvalue().endswith("\n"), written)


class Interrupt(unittest.TestCase):
    def test_ctrl_c(self):
        """In a process of its own; the mesh is as before, and the next call works."""
        program = """
            import os, signal, threading
            from grid import grid
            mesh = grid(60)
            before = mesh.checksum()
            timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
            timer.start()
            try:
                while True:
                    mesh.adapt(4, effort=10)
                    mesh = grid(60)
            except KeyboardInterrupt:
                pass
            timer.join()
            assert mesh.checksum() == before
            mesh.smooth()
            print("as before")
        """
        here = os.path.dirname(os.path.abspath(__file__))
        done = subprocess.run(
            [sys.executable, "-c", textwrap.dedent(program)],
            cwd=here,
            capture_output=True,
            text=True,
            timeout=60,
        )
        self.assertEqual((done.stdout, done.stderr), ("as before\n", ""))


class Log(unittest.TestCase):
    def test_levels(self):
        context = Context()
        mesh, patches = two_patches(context)
        seen = []
        context.set_log(lambda level, message: seen.append((level, message)))
        mesh.smooth(patches)
        self.assertTrue(any(level == "info" and message.startswith("smooth") for level, message in seen))
        seen.clear()
        context.set_log(lambda *line: seen.append(line), "warning")
        mesh.smooth(patches)
        context.set_log(None)
        mesh.smooth(patches)
        self.assertEqual(seen, [])
        self.assertRaises(alphamst.ArgumentError, lambda: context.set_log(print, 4))
        self.assertRaises(ValueError, lambda: context.set_log(print, "loud"))

    def test_an_exception_goes_on(self):
        context = Context()
        mesh, patches = two_patches(context)
        calls = []

        def throw(level, message):
            calls.append(level)
            raise Stop

        context.set_log(throw)
        self.assertRaises(Stop, lambda: mesh.smooth(patches))
        self.assertEqual(len(calls), 1)
        context.set_log(None)
        mesh.smooth(patches)

    def test_of_a_file(self):
        seen = []
        context = Context()
        context.set_log(lambda level, message: seen.append(level), "warning")
        self.assertEqual(list(module.LOG_LEVELS), ["off", "error", "warning", "info", "debug"])
        alphamst.Mesh([[0, 0], [1, 0], [1, 1], [0, 1]], [[3, 2, 1, 0]], context=context)  # turned over
        self.assertEqual(set(seen), {"warning"})


class Cancel(unittest.TestCase):
    def test_until_lowered(self):
        context = Context()
        mesh, patches = two_patches(context)
        before = mesh.checksum()
        context.set_cancel()
        for operation in OPERATIONS:
            self.assertRaises(alphamst.CancelledError, lambda: operation(mesh, patches))
        context.set_cancel(False)
        context.set_progress(lambda *_: context.set_cancel())
        self.assertRaises(alphamst.CancelledError, lambda: mesh.adapt(2, patches))
        self.assertEqual(mesh.checksum(), before)
        context.set_progress(None)
        context.set_cancel(False)
        self.assertEqual(mesh.adapt(2, patches).faces_after, 64)

    def test_threads(self):
        Context(threads=2).set_threads(0)
        self.assertRaises(alphamst.RangeError, lambda: Context(threads=-1))
        self.assertRaises(TypeError, lambda: Context().set_threads(1.5))
        self.assertRaises(OverflowError, lambda: Context().set_threads(2**40))
