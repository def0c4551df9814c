"""The triangles that a curved mesh keeps to."""

from __future__ import annotations

from numpy.typing import ArrayLike

from . import _alphamst
from .array import ids, reals
from .geometry import Geometry


class Surface(Geometry):
    """Of a `Mesh`."""

    __slots__ = ()

    def set_surface(self, points: ArrayLike, triangles: ArrayLike) -> None:
        """The surface that operations project the vertices to that they move or add.

        ``points`` is (n, dim), ``triangles`` is (m, 3) with numbers of these points, at least one. Until this
        is called it is the mesh as it is when the first operation on it begins. It is part of the mesh as fields
        are; the revision stays. Raises `RangeError` (no triangle, a corner that is no point), `NotFiniteError`.
        """
        _alphamst.amst_mesh_set_surface(self, reals(points, self.dim), ids(triangles, 3))

    def set_surface_to_mesh(self) -> None:
        """The mesh as it is now is the surface."""
        _alphamst.amst_mesh_set_surface(self, None, None)
