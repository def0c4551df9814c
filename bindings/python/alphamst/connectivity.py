"""Vertices, edges and faces of a mesh, and who is beside whom."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Ids, as_long_as_the_answer, filled, ids
from .geometry import Geometry


class VertexFaces(NamedTuple):
    """Faces around all vertices in a row, and where those of each vertex begin."""

    offsets: Ids
    faces: Ids


class Connectivity(Geometry):
    """Of a `Mesh`. Arrays are new, or those of the caller, which may be views."""

    __slots__ = ()

    def faces(self, out: Ids | None = None) -> Ids:
        """(n_faces, 4) vertices of every face, counter-clockwise."""
        return filled(
            lambda array: _alphamst.amst_mesh_get_faces(self, array), np.int32, (self.n_faces, 4), out
        )

    def edges(self, out: Ids | None = None) -> Ids:
        """(n_edges, 2) vertices of every edge, the smaller id first."""
        return filled(
            lambda array: _alphamst.amst_mesh_get_edges(self, array), np.int32, (self.n_edges, 2), out
        )

    def edge_faces(self, out: Ids | None = None) -> Ids:
        """(n_edges, 2) faces left and right of every edge; on the boundary the one there is, then -1."""
        return filled(
            lambda array: _alphamst.amst_mesh_get_edge_faces(self, array), np.int32, (self.n_edges, 2), out
        )

    def vertex_faces(self) -> VertexFaces:
        """Faces around every vertex, counter-clockwise, on the boundary from one of its edges to the other.

        Those of vertex v are ``faces[offsets[v] : offsets[v + 1]]``.

        >>> from alphamst import Mesh
        >>> mesh = Mesh([[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]], [[0, 1, 4, 3], [1, 2, 5, 4]])
        >>> offsets, faces = mesh.vertex_faces()
        >>> [faces[offsets[v] : offsets[v + 1]].tolist() for v in (0, 1)]
        [[0], [1, 0]]
        """
        offsets = np.empty(self.n_vertices + 1, np.int32)
        around = np.empty(4 * self.n_faces, np.int32)
        _alphamst.amst_mesh_get_vertex_faces(self, offsets, around)
        return VertexFaces(offsets, around)

    def find_edges(self, pairs: ArrayLike) -> Ids:
        """(n,) edge of each of (n, 2) pairs of vertices, -1 where there is none. Raises `RangeError`."""
        given = ids(pairs, 2)
        found = np.empty(len(given), np.int32)
        _alphamst.amst_mesh_find_edges(self, given, found)
        return found

    def crossed_edges(self) -> Ids:
        """(n, 2) vertices of sharp edges that pairs of triangles have been made over.

        Ids here and in `split_edges` are those when the mesh was created or read, whatever became of it.
        """
        return as_long_as_the_answer(lambda out: _alphamst.amst_mesh_get_crossed_edges(self, out)).reshape(
            -1, 2
        )

    def split_edges(self) -> Ids:
        """(n, 3): two vertices and the new one at the midpoint of the edge between them.

        That edge may be half of another one.
        """
        return as_long_as_the_answer(lambda out: _alphamst.amst_mesh_get_split_edges(self, out)).reshape(
            -1, 3
        )

    def valences(self, out: Ids | None = None) -> Ids:
        """(n_vertices,) number of edges at each vertex."""
        return filled(
            lambda array: _alphamst.amst_mesh_get_valences(self, array), np.int32, (self.n_vertices,), out
        )

    def singularities(self) -> Ids:
        """Interior vertices of valence other than 4, ascending."""
        return as_long_as_the_answer(lambda out: _alphamst.amst_mesh_get_singularities(self, out))
