"""Named numbers on vertices, edges and faces."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Ids, Reals, filled
from .error import ENTITIES, number_of
from .geometry import Geometry

if TYPE_CHECKING:
    from .mesh import Mesh

CARRIES = {"drop": 0, "inherit": 1, "linear": 2, "conserve": 3, "average": 4}


class Overlap(NamedTuple):
    """Three arrays with one element for each pair of faces that overlap."""

    before: Ids
    after: Ids
    area: Reals


class Fields(Geometry):
    """Of a `Mesh`."""

    __slots__ = ()

    def set_field(self, entity: str | int, name: str, values: ArrayLike, *, carry: str | int) -> None:
        """Give every "vertex", "edge" or "face" numbers under a name: (n,) or (n, components).

        A field of that name there is replaced. The revision stays. An operation keeps the values of what it
        keeps. New entities get theirs by ``carry``:

        * "drop": the field goes with an operation that changes connectivity
        * "inherit": from the nearest entity that was there
        * "linear", for vertices, also where they have moved: interpolated
        * "conserve", for faces and vertices: the mean over the face, or over the quarters of faces at the
          vertex; the sum of value times area stays. The field before is taken as linear on each of them
        * "average": as "conserve", but the field before is taken as constant there

        The library reads "size", one number above 0 at each vertex: the wanted edge length; and "cross",
        three at each face, see `compute_cross_field`. `adapt` and `reduce_singularities` write to "size error",
        one number at each face, if it is there, log2(area / wanted area) where they want sizes; pictures show
        it in colour. Raises `ArgumentError` (entity, name, carry not for this entity), `RangeError` (number of
        values, a size not above 0), `NotFiniteError`.
        """
        given = np.ascontiguousarray(values, np.float64)
        if given.ndim not in (1, 2):
            raise ValueError(f"an array (n,) or (n, components) is needed, not {given.shape}")
        components = 1 if given.ndim == 1 else given.shape[1]
        _alphamst.amst_mesh_set_field(
            self, number_of(ENTITIES, entity), name, components, number_of(CARRIES, carry), given
        )

    def field(self, entity: str | int, name: str, out: Reals | None = None) -> Reals:
        """The numbers of `set_field` as they are now, (n,) if each entity has one, else (n, components).

        In a new array or in that of the caller, which may be a view. Raises `ArgumentError` (entity, name),
        `NotFoundError`.
        """
        kind = number_of(ENTITIES, entity)
        count = _alphamst.amst_mesh_get_count(self, kind)
        components = _alphamst.amst_mesh_get_field(self, kind, name, None) // count
        one = components == 1 and (out is None or out.ndim == 1)
        shape = (count,) if one else (count, components)
        return filled(
            lambda array: _alphamst.amst_mesh_get_field(self, kind, name, array), np.float64, shape, out
        )

    def remove_field(self, entity: str | int, name: str) -> None:
        """Raises `ArgumentError` (entity, name), `NotFoundError`."""
        _alphamst.amst_mesh_remove_field(self, number_of(ENTITIES, entity), name)

    def overlap(self, after: Mesh) -> Overlap:
        """What the faces of this mesh share with those of ``after``, of the same domain.

        Such as a `copy` of a mesh and that mesh after an operation: `Overlap`, ascending by ``after``, then
        ``before``. In a plane the areas of a face sum up to its own where the other mesh covers it. Raises
        `ArgumentError` (one mesh has dim 2, the other 3).
        """
        # Mostly enough, so that the work is done once: a face meets about four, on either side.
        capacity = 4 * (self.n_faces + after.n_faces)
        while True:
            before, others = np.empty((2, capacity), np.int32)
            areas = np.empty(capacity)
            needed = _alphamst.amst_mesh_get_overlap(self, after, before, others, areas)
            if needed <= capacity:
                return Overlap(before[:needed].copy(), others[:needed].copy(), areas[:needed].copy())
            capacity = needed
