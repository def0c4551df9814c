"""Numbers of boundaries, regions and points, and their names."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Ids, as_long_as_the_answer, filled, ids
from .error import ENTITIES, number_of
from .geometry import Geometry


class Markers(Geometry):
    """Of a `Mesh`."""

    __slots__ = ()

    def markers(self, entity: str | int, out: Ids | None = None) -> Ids:
        """The marker of every "vertex", "edge" or "face", 0 for none.

        The number of a point, of a boundary or line inside, of a region. Operations keep what is marked;
        vertices with a marker are `Flag.CORNER`.
        """
        kind = number_of(ENTITIES, entity)
        count = _alphamst.amst_mesh_get_count(self, kind)
        return filled(
            lambda array: _alphamst.amst_mesh_get_markers(self, kind, array), np.int32, (count,), out
        )

    def set_markers(self, entity: str | int, which: ArrayLike | None, value: int) -> None:
        """Give the entities with these ids, None: all, the marker ``value``, 0 for none.

        The revision stays. Raises `ArgumentError` (entity), `RangeError` (id).
        """
        given = None if which is None else ids(which)
        _alphamst.amst_mesh_set_markers(self, number_of(ENTITIES, entity), given, value)

    def marker_list(self, entity: str | int) -> Ids:
        """The markers that some "vertex", "edge" or "face" has, ascending, without 0."""
        kind = number_of(ENTITIES, entity)
        return as_long_as_the_answer(lambda out: _alphamst.amst_mesh_get_marker_list(self, kind, out))

    def marker_name(self, entity: str | int, marker: int) -> str:
        """What the marker is called; "" if it has no name."""
        kind = number_of(ENTITIES, entity)
        text = as_long_as_the_answer(
            lambda out: _alphamst.amst_mesh_get_marker_name(self, kind, marker, out), np.uint8
        )
        return text[:-1].tobytes().decode()  # without the zero that ends it

    def set_marker_name(self, entity: str | int, marker: int, name: str) -> None:
        """Call a marker of vertices, edges or faces by a name; "" takes the name away.

        Raises `ArgumentError` (entity, marker 0, a name with double quotes or control characters).
        """
        _alphamst.amst_mesh_set_marker_name(self, number_of(ENTITIES, entity), marker, name)
