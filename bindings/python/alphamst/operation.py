"""Operations.

Each changes the mesh or, on failure and on cancel, not at all; the patches given to it move along. All take the
settings of `Options` as keywords and give a `Report`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _alphamst
from .handle import Handle
from .options import Options, chosen
from .report import Report

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Settings
    from .patches import Patches


class Operations(Handle):
    """Of a `Mesh`."""

    __slots__ = ()

    def adapt(
        self,
        alpha: float,
        patches: Patches | None = None,
        *,
        options: Options | None = None,
        **settings: Unpack[Settings],
    ) -> Report:
        """Fill each patch anew with round(alpha * faces) faces and few singularities.

        ``alpha`` is the wanted ratio of face counts for the patches that have none of their own: below 1
        coarser, above 1 finer, 1 only better. Patches with defects are left, see `Report.is_partial`.

        Without patches the whole mesh, plane or curved, with windows that the library chooses: round(alpha *
        faces) faces, as few singular vertices as it can, boundary and features kept. A vertex field "size" says
        where the faces go. A curved mesh keeps to its surface; features of one lose and get vertices only where
        they are straight. With ``edit_boundary=1`` the boundary may change, see `Options`.

        Raises `ArgumentError` (alpha <= 0, patches of another mesh), `NotFiniteError`, `StaleError`,
        `StateError` (in a callback), `CancelledError`.
        """
        report = Report()
        _alphamst.amst_adapt(self, patches, alpha, chosen(options, settings), report)
        return report

    def reduce_singularities(
        self, patches: Patches | None = None, *, options: Options | None = None, **settings: Unpack[Settings]
    ) -> Report:
        """Fill each patch anew with the fewest singularities that its boundary allows.

        Without patches the whole mesh; its number of faces stays within a few percent. Raises as `adapt`.
        """
        report = Report()
        _alphamst.amst_reduce_singularities(self, patches, chosen(options, settings), report)
        return report

    def smooth(
        self, patches: Patches | None = None, *, options: Options | None = None, **settings: Unpack[Settings]
    ) -> Report:
        """Move the interior vertices of the patches, or of the whole mesh.

        Flagged ones stay, but for those on straight features of a curved mesh, which slide along them; the
        revision stays, too. Raises as `adapt`.
        """
        report = Report()
        _alphamst.amst_smooth(self, patches, chosen(options, settings), report)
        return report

    def clean(self, *, options: Options | None = None, **settings: Unpack[Settings]) -> Report:
        """Remove doublets and split valences above 5. The revision rises if there were any. Raises as `adapt`."""
        report = Report()
        _alphamst.amst_clean(self, chosen(options, settings), report)
        return report
