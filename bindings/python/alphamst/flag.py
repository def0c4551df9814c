"""Flags of vertices, edges and faces."""

from __future__ import annotations

import enum

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Ids, filled, ids
from .error import ENTITIES, number_of
from .geometry import Geometry


class Flag(enum.IntFlag):
    """Bits of vertices, edges and faces."""

    FIXED = 1
    "neither moved, split nor removed"
    FEATURE = 2
    "on a curve that must survive; may slide along it"
    CORNER = 4
    "end or crossing of such curves; does not move"


class Flags(Geometry):
    """Of a `Mesh`."""

    __slots__ = ()

    def flags(self, entity: str | int, out: Ids | None = None) -> Ids:
        """Bits of `Flag` of every "vertex", "edge" or "face"."""
        kind = number_of(ENTITIES, entity)
        count = _alphamst.amst_mesh_get_count(self, kind)
        return filled(lambda array: _alphamst.amst_mesh_get_flags(self, kind, array), np.int32, (count,), out)

    def set_flags(self, entity: str | int, which: ArrayLike | None, mask: int, value: int) -> None:
        """Set the bits in ``mask`` as they are in ``value`` for the entities with these ids, None: for all.

        The revision stays. Raises `ArgumentError` (entity), `RangeError` (id, bits that are no flag).
        """
        given = None if which is None else ids(which)
        _alphamst.amst_mesh_set_flags(self, number_of(ENTITIES, entity), given, mask, value)

    def raise_flags(self, entity: str | int, which: ArrayLike | None, flags: int) -> None:
        """Raise these flags of the entities with these ids, None: of all; others stay."""
        self.set_flags(entity, which, flags, flags)

    def lower_flags(self, entity: str | int, which: ArrayLike | None, flags: int) -> None:
        """Lower these flags of the entities with these ids, None: of all; others stay."""
        self.set_flags(entity, which, flags, 0)

    def detect_features(self, angle: float) -> int:
        """Flag the edges whose two faces have normals more than ``angle`` degrees apart as features.

        And as corners the vertices where curves of feature edges, these and those of before, end, cross or turn
        by more than 60 degrees, but not right back. No flag is taken away. Gives the number of edges at more
        than ``angle``, 0 to 180. Raises `NotFiniteError`, `RangeError`.
        """
        return _alphamst.amst_mesh_detect_features(self, angle)
