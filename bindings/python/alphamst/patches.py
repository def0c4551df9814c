"""Disjoint patches of a mesh."""

from __future__ import annotations

import enum
import os
from typing import TYPE_CHECKING, NamedTuple

from numpy.typing import ArrayLike

from . import _alphamst
from .array import Ids, as_long_as_the_answer, ids, three_coordinates
from .error import number_of
from .handle import Handle
from .mesh import Mesh
from .options import Options, chosen

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Settings

DECOMPOSITIONS = {"clusters": 0, "partition": 1, "voronoi": 2, "medial": 3, "singularities": 4}
ALL = -2


class Defect(enum.IntFlag):
    """Bits of what is wrong with a patch."""

    EMPTY = 1
    NOT_CONNECTED = 2
    NOT_DISK = 4
    PINCHED = 8
    "the boundary touches itself"
    OVERLAP = 16
    CROSSES_FEATURE = 32
    "a flagged entity or border of regions inside"
    ODD_BOUNDARY = 64
    CORNERS = 128
    "given ones not on the boundary or not in its order"
    NOT_CONVEX = 256
    "only a remark"


class Check(NamedTuple):
    """What is wrong with a patch, and its area over that of its convex hull, 0 if it is no disk."""

    defects: Defect
    convexity: float


class Prediction(NamedTuple):
    """What `Mesh.adapt` would deliver: exact numbers, the singularities interior ones."""

    faces: int
    singularities: int


class Patches(Handle):
    """An empty set of patches of the mesh's revision now.

    Operations that are given the set move it along; other changes make it stale, and its use a `StaleError`.
    The settings that count are ``repair_patches``, ``patch_faces``, ``min_convexity`` and ``seed``.
    """

    __slots__ = ("__weakref__",)

    def __init__(self, mesh: Mesh, *, options: Options | None = None, **settings: Unpack[Settings]) -> None:
        _alphamst.amst_patches_create(mesh, chosen(options, settings), self)

    def __len__(self) -> int:
        """Number of patches in the set."""
        return _alphamst.amst_patches_get_count(self)

    def __bool__(self) -> bool:
        return True  # also without a patch: None stands for the whole mesh

    # ---------------------------------------------------------------------------------- adding

    def add_faces(self, faces: ArrayLike) -> int:
        """A new patch of these faces, in any order; gives its id.

        Faces that an earlier patch has, or that are fixed, are left out, and the patch is made a disk if it can;
        with the setting ``repair_patches=0`` such a face is an error. Raises `RangeError` (face), `PatchError`
        (none left).
        """
        return _alphamst.amst_patches_add_faces(self, ids(faces))

    def add_rings(self, vertex: int, rings: int) -> int:
        """A new patch of the faces within so many layers of a vertex, 1 for those at it; gives its id.

        Raises `RangeError`, `PatchError` (no face left).
        """
        return _alphamst.amst_patches_add_rings(self, vertex, rings)

    def add_ball(self, center: ArrayLike, radius: float) -> int:
        """A new patch of the connected faces around the one nearest to ``center``; gives its id.

        Those that have their centroid within ``radius``. ``center`` has 2 or 3 coordinates; a mesh of dim 2 lies
        in the plane z = 0. Raises `ArgumentError` (radius < 0), `NotFiniteError`, `PatchError` (no face left).
        """
        return _alphamst.amst_patches_add_ball(self, three_coordinates(center), radius)

    def add_box(self, low: ArrayLike, high: ArrayLike) -> int:
        """A new patch of the faces with their centroid in the box between two points; gives its id.

        Of them the largest connected part. Raises `ArgumentError` (low above high), `NotFiniteError`,
        `PatchError` (no face left).
        """
        return _alphamst.amst_patches_add_box(self, three_coordinates(low), three_coordinates(high))

    def decompose(self, method: str | int = "clusters") -> int:
        """Patches of about ``patch_faces`` faces over the faces not yet taken; gives how many.

        By "clusters" (compact ones), "partition" (balanced graph partition), "voronoi" (geodesic cells of faces
        far from one another), "medial" (discs: faces within the largest inscribed circles; not every face is in
        one) or "singularities" (faces around singular vertices that lie together; no others).
        """
        return _alphamst.amst_patches_decompose(self, number_of(DECOMPOSITIONS, method))

    # ---------------------------------------------------------------------------------- setting

    def set_corners(self, patch: int, vertices: ArrayLike) -> None:
        """Corners of a patch: 3 to 6 vertices of its boundary in counter-clockwise order.

        With none the library chooses. Whether they are that is told by `check`. Raises `RangeError`.
        """
        _alphamst.amst_patches_set_corners(self, patch, ids(vertices))

    def set_alpha(self, patch: int, alpha: float) -> None:
        """Wanted ratio of face counts of one patch; 0 means that of the operation.

        Raises `ArgumentError` (alpha < 0), `NotFiniteError`, `RangeError`.
        """
        _alphamst.amst_patches_set_alpha(self, patch, alpha)

    def set_all_alphas(self, alpha: float) -> None:
        """Likewise of all patches that are in the set now."""
        _alphamst.amst_patches_set_alpha(self, ALL, alpha)

    # ---------------------------------------------------------------------------------- asking

    def faces(self, patch: int) -> Ids:
        """Faces of a patch, ascending."""
        return as_long_as_the_answer(lambda out: _alphamst.amst_patches_get_faces(self, patch, out))

    def boundary(self, patch: int) -> Ids:
        """Vertices of a patch's boundary, counter-clockwise from the first corner.

        Raises `PatchError` if the patch is no disk.
        """
        return as_long_as_the_answer(lambda out: _alphamst.amst_patches_get_boundary(self, patch, out))

    def corners(self, patch: int) -> Ids:
        """The corners that were set, otherwise the boundary vertices where one face fits.

        Raises `PatchError` if the patch is no disk.
        """
        return as_long_as_the_answer(lambda out: _alphamst.amst_patches_get_corners(self, patch, out))

    def check(self, patch: int) -> Check:
        """`Check` of a patch; without defects it is usable."""
        defects, convexity = _alphamst.amst_patches_check(self, patch)
        return Check(Defect(defects), convexity)

    def predict(
        self, patch: int, alpha: float, *, options: Options | None = None, **settings: Unpack[Settings]
    ) -> Prediction:
        """`Prediction` of what `Mesh.adapt` would deliver for that patch and alpha.

        Raises `ArgumentError` (alpha <= 0), `NotFiniteError`, `PatchError`, `NoFillingError`.
        """
        return Prediction(*_alphamst.amst_patches_predict(self, patch, alpha, chosen(options, settings)))

    def write(self, path: str | os.PathLike[str]) -> None:
        """Picture (.svg) of the mesh with the patch outlines and the singularities.

        Raises `FileError`, `UnsupportedError` (extension).
        """
        _alphamst.amst_patches_write(self, os.fspath(path))
