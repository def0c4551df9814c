"""Threads, callbacks and cancelling."""

from __future__ import annotations

import sys
from collections.abc import Callable

from . import _alphamst
from .error import name_of, number_of
from .handle import Handle

LOG_LEVELS = {"off": -1, "error": 0, "warning": 1, "info": 2, "debug": 3}

Progress = Callable[[float, str], object]
Log = Callable[[str, str], object]


class Context(Handle):
    """What meshes are made in: number of threads, progress, log and cancelling.

    One context serves one thread at a time; different contexts share nothing.

    >>> from alphamst import Mesh
    >>> context = Context()
    >>> context.set_log(lambda level, message: print(level))
    >>> mesh = Mesh([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2, 3]], context=context)
    >>> mesh.context is context
    True
    """

    __slots__ = ("__weakref__",)

    def __init__(self, *, threads: int = 1, progress: Progress | None = None) -> None:
        _alphamst.amst_context_create(0, self)
        self.set_progress(progress)
        if threads != 1:
            self.set_threads(threads)

    def set_threads(self, n: int) -> None:
        """Threads that an operation works with; 0 is all cores. Results do not depend on it."""
        _alphamst.amst_context_set_threads(self, n)

    def set_progress(self, progress: Progress | None) -> None:
        """Have ``progress(fraction, stage)`` called while an operation runs, or no longer.

        `show_bar` is such a function; ``fraction`` is from 0 to 1. If it gives something true the operation
        stops with a `CancelledError`; if it raises, the operation stops and the exception goes on to its
        caller. Both leave the mesh as it was. It is called on the thread of the operation; it may ask and
        close, but not change anything of this context.
        """
        _alphamst.amst_context_set_progress(self, progress)

    def set_log(self, log: Log | None, level: str | int = "info") -> None:
        """Have ``log(level, message)`` called with messages up to a level, or no longer.

        Levels are "error", "warning", "info" (one a stage) and "debug" (one a patch or window). It is bound
        like the function of `set_progress`, but cannot cancel: if it raises, the exception goes on when the
        operation has ended, which may have changed the mesh.
        """
        if log is None:
            _alphamst.amst_context_set_log(self, -1, None)
            return

        def by_name(number: int, message: str) -> None:
            log(name_of(LOG_LEVELS, number) or "debug", message)

        _alphamst.amst_context_set_log(self, number_of(LOG_LEVELS, level), by_name)

    def set_cancel(self, flag: bool = True) -> None:
        """Stop the operation that runs now and all later ones with `CancelledError`, until lowered.

        May be called from any thread.
        """
        _alphamst.amst_context_set_cancel(self, flag)

    @property
    def progress(self) -> float:
        """Fraction, 0 to 1, of the operation under way or else of the last one, from any thread."""
        return _alphamst.amst_context_get_progress(self)


def show_bar(fraction: float, stage: str) -> None:
    """A bar on standard error, if that is a terminal, for ``Context(progress=show_bar)``."""
    if not sys.stderr.isatty():
        return
    width = 40
    bar = "#" * int(width * fraction)
    end = "\n" if fraction >= 1 else ""
    print(f"\r[{bar:{width}}] {fraction:4.0%} {stage:20.20}", end=end, file=sys.stderr, flush=True)
