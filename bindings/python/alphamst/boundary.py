"""The boundary as the caller knows it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Ids, Reals
from .geometry import Geometry

Projected = Callable[[Ids, Reals], "ArrayLike | None"]


class Boundary(Geometry):
    """Of a `Mesh`."""

    __slots__ = ()

    def set_projection(self, project: Projected | None) -> None:
        """Say where the boundary runs, for operations with ``edit_boundary=1``; None: as the edges do.

        ``project(markers, points)`` gives the points of the boundary, (n, dim), that belong to ``points``,
        (n, dim), which are on or near edges with these ``markers``, (n,). Such an operation calls it once when
        it begins, to learn where the boundary runs, and once in the end, for new vertices, which come to lie
        where it says, bit for bit. Copies of the mesh have it, too; files do not.

            def project(markers, points):  # the circle of radius 1
                return points / np.linalg.norm(points, axis=1, keepdims=True)

        The operation fails with `ProjectionError` if it gives None, if a result is not finite or farther off
        than ``tolerance`` edges, and if a new vertex turned a face over there. If it raises, the exception goes
        on. All leave the mesh as it was. It is called on the thread of the operation, gives equal results for
        equal points, and is bound like that of `Context.set_progress`. Raises `StateError` (in a callback).
        """
        if project is None:
            _alphamst.amst_mesh_set_projection(self, None, 0)
            return
        dim = self.dim

        def into(markers: memoryview, points: memoryview, projected: memoryview) -> bool:
            # The library's memory is copied: project may keep what it is given.
            given = np.frombuffer(points).reshape(-1, dim).copy()
            result = project(np.frombuffer(markers, np.int32).copy(), given)
            if result is None:
                return True
            found = np.asarray(result, np.float64)
            if found.shape != given.shape:
                raise ValueError(f"the projection of {given.shape} numbers gives {found.shape}")
            np.frombuffer(projected).reshape(-1, dim)[...] = found
            return False

        _alphamst.amst_mesh_set_projection(self, into, dim)
