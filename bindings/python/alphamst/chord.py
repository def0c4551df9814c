"""Chords: the rows of faces met when each is left through the edge opposite to the one it was entered by."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _alphamst
from .array import Ids, as_long_as_the_answer
from .error import number_of
from .handle import Handle
from .options import Options, chosen
from .report import Report

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Settings
    from .patches import Patches

PROPERTIES = {
    "edge": 0,
    "closed": 1,
    "length": 2,
    "faces": 3,
    "crossings": 4,
    "touches": 5,
    "singularities": 6,
    "refusal": 7,
    "singular_after": 8,
}


class Refusal(enum.IntFlag):
    """Bits of why a chord cannot be collapsed."""

    CROSSING = 1
    "it crosses itself"
    CLOSED = 2
    "its borders meet"
    BOUNDARY = 4
    "it would join boundary vertices or, not allowed, change the boundary"
    FIXED = 8
    FEATURE = 16
    VALENCE = 32
    "below 3 or above 6"
    DOUBLE = 64
    "two edges would have the same vertices"


class Chord(NamedTuple):
    """The edges it crosses, in order; ``crossings`` counts the faces it passes twice."""

    edges: Ids
    closed: bool
    crossings: int


class Chords(Handle):
    """Of a `Mesh`."""

    __slots__ = ()

    def chord(self, edge: int) -> Chord:
        """The chord through an edge, from that edge round if closed, else from its end with the smaller edge.

        Raises `RangeError`.
        """
        closed, crossings, needed = _alphamst.amst_mesh_get_chord(self, edge, None)
        edges = np.empty(needed, np.int32)
        _alphamst.amst_mesh_get_chord(self, edge, edges)
        return Chord(edges, closed != 0, crossings)

    def chord_ids(self) -> Ids:
        """(n_edges,) number of the chord of each edge, in the order of their smallest edges.

        As an edge field "chord" they are drawn in colour by `write`.
        """
        return as_long_as_the_answer(lambda out: _alphamst.amst_mesh_get_chord_ids(self, out)[1])

    def chords(
        self, property: str | int, *, options: Options | None = None, **settings: Unpack[Settings]
    ) -> NDArray[np.int64]:
        """A property of each chord.

        "edge" (its smallest one), "closed" (1 or 0), "length" (faces it passes, those passed twice counted
        twice), "faces" (counted once), "crossings", "touches" (vertices at more than one of its edges),
        "singularities" (at its edges), "refusal" (bits of `Refusal`, 0 if it can be collapsed),
        "singular_after" (singular vertices of the mesh once it is). Of the settings ``edit_boundary`` counts.
        """
        number, given = number_of(PROPERTIES, property), chosen(options, settings)
        return as_long_as_the_answer(
            lambda out: _alphamst.amst_mesh_get_chords(self, number, given, out), np.int64
        )

    def collapse_chord(
        self, edge: int, *, options: Options | None = None, **settings: Unpack[Settings]
    ) -> Report:
        """Remove the chord through an edge: the two ends of each of its edges become one vertex.

        The faces around it are smoothed. Raises as `adapt`, and `ChordError` with the reason, `GeometryError`.
        """
        report = Report()
        _alphamst.amst_collapse_chord(self, edge, chosen(options, settings), report)
        return report

    def split_chord(
        self, edge: int, n: int = 1, *, options: Options | None = None, **settings: Unpack[Settings]
    ) -> Report:
        """Cut the chord through an edge into n + 1 parallel ones; no vertex becomes singular.

        One that ends on the boundary needs ``edit_boundary=1``. Raises as `collapse_chord`.
        """
        report = Report()
        _alphamst.amst_split_chord(self, edge, n, chosen(options, settings), report)
        return report

    def insert_chords(
        self, patches: Patches, n: int = 1, *, options: Options | None = None, **settings: Unpack[Settings]
    ) -> Report:
        """Lay n rings of faces between the boundary of each patch, which stays, and its faces.

        A patch needs 3 to 6 corners (boundary vertices with one of its faces), or none, and two of its faces at
        all other boundary vertices; others are left, see `Report.is_partial`. Raises as `adapt`, and
        `RangeError` (n).
        """
        report = Report()
        _alphamst.amst_insert_chords(self, patches, n, chosen(options, settings), report)
        return report
