"""Meshes of meshio and pyvista."""

from __future__ import annotations

import pathlib
import tempfile
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from .connectivity import Connectivity
from .field import Fields
from .file import Files
from .markers import Markers

if TYPE_CHECKING:
    from typing import Self

    from typing_extensions import Unpack

    from .context import Context
    from .options import Options, Settings

GROUP = "gmsh:physical"  # what meshio calls the markers of cells


class Exchange(Files, Connectivity, Markers, Fields):
    """Of a `Mesh`."""

    __slots__ = ()

    @classmethod
    def from_meshio(
        cls,
        mesh: Any,
        *,
        context: Context | None = None,
        options: Options | None = None,
        **settings: Unpack[Settings],
    ) -> Self:
        """A mesh from one of meshio: its triangles, quads and lines.

        Cell data "gmsh:physical" become markers, their names in ``field_data`` come along. It goes through a
        file, so that triangles are paired as by `Mesh.read`. Raises as that.
        """
        import meshio

        kept = [
            k for k, block in enumerate(mesh.cells) if block.type in ("vertex", "line", "triangle", "quad")
        ]
        groups = mesh.cell_data.get(GROUP, [np.zeros(len(block.data), int) for block in mesh.cells])
        data = [np.asarray(groups[k], int) for k in kept]
        plain = meshio.Mesh(
            mesh.points,
            [(mesh.cells[k].type, mesh.cells[k].data) for k in kept],
            cell_data={GROUP: data, "gmsh:geometrical": data},
            field_data=mesh.field_data,
        )
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "mesh.msh")
            meshio.write(path, plain, file_format="gmsh22", binary=False)
            return cls.read(path, context=context, options=options, **settings)

    def to_meshio(self, *, vertex_fields: Iterable[str] = (), face_fields: Iterable[str] = ()) -> Any:
        """A mesh of meshio with the faces, the marked edges and vertices, and the fields of these names.

        Markers are cell data "gmsh:physical", their names are in ``field_data``.
        """
        import meshio

        marked = {entity: np.flatnonzero(self.markers(entity)) for entity in ("vertex", "edge")}
        found: list[tuple[str, Any, Any]] = [
            ("quad", self.faces(), self.markers("face")),
            ("line", self.edges()[marked["edge"]], self.markers("edge")[marked["edge"]]),
            ("vertex", marked["vertex"].reshape(-1, 1), self.markers("vertex")[marked["vertex"]]),
        ]
        blocks = [block for block in found if len(block[1])]
        cell_data: dict[str, list[Any]] = {GROUP: [groups for _, _, groups in blocks]}
        for name in face_fields:
            values = self.field("face", name)
            missing = [np.full((len(cells), *values.shape[1:]), np.nan) for _, cells, _ in blocks[1:]]
            cell_data[name] = [values, *missing]
        names = {
            self.marker_name(entity, marker): np.array([marker, dimension])
            for dimension, entity in enumerate(("vertex", "edge", "face"))
            for marker in self.marker_list(entity)
        }
        names.pop("", None)
        return meshio.Mesh(
            self.points(),
            [(kind, cells) for kind, cells, _ in blocks],
            point_data={name: self.field("vertex", name) for name in vertex_fields},
            cell_data=cell_data,
            field_data=names,
        )

    def to_pyvista(self) -> Any:
        """A ``pyvista.PolyData`` of points and faces, to be looked at with ``plot(show_edges=True)``."""
        import pyvista

        points = np.zeros((self.n_vertices, 3))
        points[:, : self.dim] = self.points()
        faces = np.column_stack([np.full(self.n_faces, 4), self.faces()])
        return pyvista.PolyData(points, faces.ravel())
