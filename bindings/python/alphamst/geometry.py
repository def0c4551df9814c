"""How large a mesh is, where its vertices lie, and what a code needs of faces and edges that solves on it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Reals, filled, reals
from .error import number_of
from .handle import Handle

GEOMETRIES = {"centroids": 0, "lengths": 1, "normals": 2}


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

    def geometry(self, key: str | int, out: Reals | None = None) -> Reals:
        """"centroids" (n_faces, dim), "lengths" (n_edges,) or "normals" (n_edges, dim).

        Normals have length 1 and point out of the first face of `edge_faces`, so on the boundary outwards; on
        curved meshes they are at right angles to the mean normal of the faces. Areas are
        ``quality("area")``. Raises `ArgumentError`.
        """
        number = number_of(GEOMETRIES, key)
        n = self.n_faces if number == GEOMETRIES["centroids"] else self.n_edges
        shape = (n,) if number == GEOMETRIES["lengths"] else (n, self.dim)
        return filled(
            lambda array: _alphamst.amst_mesh_get_geometry(self, number, array), np.float64, shape, out
        )
