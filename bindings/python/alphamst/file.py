"""Files in and out."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from . import _alphamst
from .context import Context
from .handle import Handle
from .options import Options, chosen

if TYPE_CHECKING:
    from typing import Self

    from typing_extensions import Unpack

    from .options import Settings


class Files(Handle):
    """Of a `Mesh`."""

    __slots__ = ()

    @classmethod
    def read(
        cls,
        path: str | os.PathLike[str],
        *,
        context: Context | None = None,
        options: Options | None = None,
        **settings: Unpack[Settings],
    ) -> Self:
        """A mesh from a file.

        The format is told by the extension: .off, .obj, .ply, .msh (Gmsh 1, 2.2, 4.0 and 4.1 ASCII), .su2,
        .vtk (legacy). Dim is 2 when every z is 0. Numbers of points, boundaries and regions are `markers`,
        with their names; the boundaries of an .su2 file get the numbers 1, 2, ... in the order of the file.
        What numbers could not be kept is told by the log. Raises as `Mesh`, and `FileError`, `FormatError`,
        `UnsupportedError`.
        """
        mesh = cls.__new__(cls)
        given = Context() if context is None else context
        _alphamst.amst_mesh_read(given, os.fspath(path), chosen(options, settings), mesh)
        return mesh

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write to a file of one of the formats that are read, or to an .svg, a picture.

        All markers and names are kept by .msh; what another format has no place for is told by the log. Raises
        `FileError`, `UnsupportedError` (extension).
        """
        _alphamst.amst_mesh_write(self, os.fspath(path))
