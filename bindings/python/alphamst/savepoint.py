"""Savepoints, to undo what was done."""

from __future__ import annotations

from . import _alphamst
from .handle import Handle


class Savepoints(Handle):
    """Of a `Mesh`."""

    __slots__ = ()

    def mark(self) -> int:
        """Remember points, connectivity, flags, markers and fields; gives the revision that names it.

        Savepoints nest; of several with one name the latest is meant.
        """
        return _alphamst.amst_mesh_mark(self)

    def rollback(self, revision: int) -> None:
        """Back to a savepoint, which stays; later ones are forgotten.

        Patches of its revision are current again. Raises `NotFoundError`.
        """
        _alphamst.amst_mesh_rollback(self, revision)

    def forget(self, revision: int) -> None:
        """Give up one savepoint; the mesh stays as it is. Raises `NotFoundError`."""
        _alphamst.amst_mesh_forget(self, revision)
