"""From error to mesh."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy.typing import ArrayLike

from . import _alphamst
from .array import reals
from .handle import Handle
from .options import Options, chosen

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Settings


class Indicator(Handle):
    """Of a `Mesh`."""

    __slots__ = ()

    def size_from_indicator(
        self,
        indicator: ArrayLike,
        *,
        tolerance: float = 0.0,
        faces: int = 0,
        options: Options | None = None,
        **settings: Unpack[Settings],
    ) -> float:
        """Write the vertex field "size" that `adapt` goes by; gives how many faces it asks for.

        The indicator (n_faces,) is what a face contributes to the error, at least 0, like h to the power
        ``error_order`` for edges of length h; where fronts are sharp the jump across the face will do. Given a
        ``tolerance``, each face asks for edges at which its indicator is that, and ``faces`` is a limit of
        their number, 0: none; without one there will be as many ``faces``, with equal error everywhere. Of the
        settings ``error_order``, ``min_edge``, ``max_edge``, ``gradation`` and ``buffer_layers`` count.

        Raises `RangeError`, `ArgumentError` (max_edge below min_edge), `NotFiniteError`.
        """
        return _alphamst.amst_mesh_size_from_indicator(
            self, reals(indicator), tolerance, faces, chosen(options, settings)
        )
