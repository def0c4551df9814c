"""Which way edges should run, and which way they do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _alphamst
from .handle import Handle
from .options import Options, chosen

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Settings


class CrossField(Handle):
    """Of a `Mesh`."""

    __slots__ = ()

    def compute_cross_field(self, *, options: Options | None = None, **settings: Unpack[Settings]) -> None:
        """Give the faces a new field "cross", three numbers also in the plane.

        A direction of length 1 that edges shall have there, or one at right angles to it. Along the boundary,
        features and borders of markers it is that of the edges, elsewhere a principal direction, the more the
        curvatures in them differ; and between that it is as smooth as can be. New faces inherit it. Of the
        settings ``smooth_steps`` counts. Raises `StateError` (in a callback).
        """
        _alphamst.amst_mesh_compute_cross_field(self, chosen(options, settings))

    def alignment(self) -> float:
        """Mean angle, 0 to 45 degrees, between the sides of faces and the nearest direction of "cross".

        0 where edges follow it, 22.5 where they do not know of it. Raises `NotFoundError`.
        """
        return _alphamst.amst_mesh_get_alignment(self)
