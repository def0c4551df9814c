"""How large a mesh is, and where its vertices lie."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Reals, filled, reals
from .handle import Handle


class Geometry(Handle):
    """Of a `Mesh`."""

    __slots__ = ()

    @property
    def dim(self) -> int:
        """Coordinates of a point, 2 or 3."""
        return _alphamst.amst_mesh_get_dim(self)

    @property
    def n_vertices(self) -> int:
        """Number of vertices."""
        return _alphamst.amst_mesh_get_count(self, 0)

    @property
    def n_edges(self) -> int:
        """Number of edges."""
        return _alphamst.amst_mesh_get_count(self, 1)

    @property
    def n_faces(self) -> int:
        """Number of faces."""
        return _alphamst.amst_mesh_get_count(self, 2)

    def points(self, out: Reals | None = None) -> Reals:
        """(n, dim) coordinates, in a new array or in that of the caller, which may be a view."""
        return filled(
            lambda array: _alphamst.amst_mesh_get_points(self, array),
            np.float64,
            (self.n_vertices, self.dim),
            out,
        )

    def set_points(self, points: ArrayLike) -> None:
        """New positions (n, dim) for all vertices; connectivity and revision stay.

        Raises `RangeError` for another number of vertices, `NotFiniteError`.
        """
        _alphamst.amst_mesh_set_points(self, reals(points, self.dim))
