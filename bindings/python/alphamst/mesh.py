"""Meshes: arrays and files in and out, and what a mesh is asked."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import by_strides
from .boundary import Boundary
from .chord import Chords
from .context import Context
from .cross_field import CrossField
from .exchange import Exchange
from .flag import Flag, Flags
from .indicator import Indicator
from .operation import Operations
from .options import Options, chosen
from .quality import Quality
from .savepoint import Savepoints
from .surface import Surface

if TYPE_CHECKING:
    from typing import Self

    from typing_extensions import Unpack

    from .options import Settings

__all__ = ["Flag", "Mesh"]


class Mesh(
    Exchange,
    Flags,
    CrossField,
    Surface,
    Boundary,
    Savepoints,
    Quality,
    Operations,
    Indicator,
    Chords,
):
    """A mesh of quadrilaterals from arrays; `Mesh.read` takes one from a file.

    ``points`` is (n, dim) with dim 2 or 3. ``faces`` is (m, 4) or (m, 3), corners counter-clockwise, at least
    one face; -1 as the last of four corners makes a triangle. Triangles are merged in pairs, or split with
    ``quadrangulate=1``; all given vertices keep their ids. Faces that run another way round than their
    neighbours, or clockwise in the plane, are turned over, and the log tells how many. Arrays of float64 and
    of int32 or int64 with any strides are read where they lie; others are converted first. Nothing is kept of
    them.

    Raises `ArgumentError`, `RangeError` (corner), `NotFiniteError`, `NotQuadError`, `NotManifoldError`.

    >>> mesh = Mesh([[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]], [[0, 1, 4, 3], [1, 2, 5, 4]])
    >>> mesh
    <Mesh: 6 vertices, 2 faces>
    >>> mesh.adapt(1.0).faces_after
    2
    """

    __slots__ = ("__weakref__",)

    def __init__(
        self,
        points: ArrayLike,
        faces: ArrayLike,
        *,
        context: Context | None = None,
        options: Options | None = None,
        **settings: Unpack[Settings],
    ) -> None:
        coords, vertex_stride, component_stride = by_strides(points, np.float64)
        given = np.asarray(faces)
        if given.size > 0 and given.dtype.kind not in "iu":
            raise TypeError(f"corners are whole numbers, not {given.dtype}")
        corners, face_stride, corner_stride = by_strides(
            given, np.int32 if given.dtype == np.int32 else np.int64
        )
        create = _alphamst.amst_mesh_create if corners.dtype == np.int32 else _alphamst.amst_mesh_create_i64
        create(
            Context() if context is None else context,
            coords.shape[1],
            coords,
            vertex_stride,
            component_stride,
            corners,
            face_stride,
            corner_stride,
            corners.shape[1],
            chosen(options, settings),
            self,
        )

    def copy(self, context: Context | None = None) -> Self:
        """A mesh of its own with all but the savepoints, in the same context or in another one.

        For threads that work at the same time, each on a copy in a context of its own. Into a given context no
        function of `set_projection` comes along, as it might be called on several threads at once.
        """
        mesh = type(self).__new__(type(self))
        if context is None:
            _alphamst.amst_mesh_clone(self, mesh)
        else:
            _alphamst.amst_mesh_clone_into(self, context, mesh)
        return mesh

    def __repr__(self) -> str:
        return (
            super().__repr__() if self.closed else f"<Mesh: {self.n_vertices} vertices, {self.n_faces} faces>"
        )

    @property
    def context(self) -> Context:
        """What it was made in."""
        return self.parent

    @property
    def revision(self) -> int:
        """Rises with every change of connectivity and never repeats, but that `rollback` returns to one."""
        return _alphamst.amst_mesh_get_revision(self)

    def checksum(self) -> int:
        """64-bit digest of coordinates, connectivity, flags and markers: equal for equal meshes."""
        return _alphamst.amst_mesh_get_checksum(self)

    def check(self) -> None:
        """Raise an `AlphaMSTError` with the first fault of the connectivity or, for dim 2, the orientation."""
        _alphamst.amst_mesh_check(self)
