"""Numeric settings."""

from __future__ import annotations

from typing import TypedDict

import numpy as np
from numpy.typing import ArrayLike

from . import _alphamst
from .array import Ids, as_long_as_the_answer, ids
from .handle import Handle

KEYS = {
    "seed": 0,
    "smooth_steps": 1,
    "repair_patches": 2,
    "candidates": 3,
    "node_limit": 4,
    "quadrangulate": 5,
    "edit_boundary": 6,
    "strategy": 7,
    "align": 8,
    "chart": 9,
    "keep_boundary": 10,
    "starts": 11,
    "buffer_layers": 12,
    "min_quality": 1000,
    "min_convexity": 1001,
    "patch_faces": 1002,
    "tolerance": 1003,
    "effort": 1004,
    "size_weight": 1005,
    "transition": 1006,
    "least_size": 1007,
    "sharp_angle": 1008,
    "size_band": 1009,
    "min_edge": 1010,
    "max_edge": 1011,
    "gradation": 1012,
    "error_order": 1013,
}


class Settings(TypedDict, total=False):
    """The keywords of `Options`, for type checkers."""

    seed: int
    smooth_steps: int
    repair_patches: int
    candidates: int
    node_limit: int
    quadrangulate: int
    edit_boundary: int
    strategy: int
    align: int
    chart: int
    keep_boundary: int
    starts: int
    buffer_layers: int
    min_quality: float
    min_convexity: float
    patch_faces: float
    tolerance: float
    effort: float
    size_weight: float
    transition: float
    least_size: float
    sharp_angle: float
    size_band: float
    min_edge: float
    max_edge: float
    gradation: float
    error_order: float
    edges: ArrayLike


class Options(Handle):
    """Settings of operations, each with a default.

    Wherever a function takes ``**settings``, these keywords may be given instead, or ``options=`` an
    `Options`, to use it again.

    | setting | default | |
    | --- | --- | --- |
    | `seed` | 0 | of every random choice |
    | `smooth_steps` | 20 | sweeps of shape optimisation, 0 to 1000 |
    | `repair_patches` | 1 | 0 or 1: fill small holes and cut pinches of new patches |
    | `candidates` | 16 | fillings to try in a patch before it is left, 1 to 1000 |
    | `node_limit` | 1000 | effort of one exact search, in quads laid, 0 to 10^9 |
    | `quadrangulate` | 0 | 0: triangles of a new mesh are paired, 1: every face is split |
    | `edit_boundary` | 0 | 1: vertices come and go on the boundary, see below |
    | `strategy` | 0 | 0: a whole mesh is adapted by windows, 1: by chords alone |
    | `align` | 0 | 0 or 1: edges of curved meshes follow their cross field |
    | `chart` | 0 | map of what is curved, 1: mean value, 2: conformal, 3: low stretch |
    | `keep_boundary` | 0 | 0 or 1: new meshes get no vertex on the boundary, or fail |
    | `starts` | 1 | searches of a whole mesh, a thread each; the best is kept, 1 to 1000 |
    | `buffer_layers` | 2 | layers of faces around each that get its "size" from an indicator, 0 to 1000 |
    | `min_quality` | 0.0 | no filling with a scaled Jacobian at or below, 0 to 1 |
    | `min_convexity` | 0.6 | a patch below has `Defect.NOT_CONVEX`, 0 to 1 |
    | `patch_faces` | 100.0 | aim of automatic decomposition, at least 1 |
    | `tolerance` | 0.5 | farthest from surface or boundary, in wanted edges, 0.01 to 100 |
    | `effort` | 1.0 | times as much is spent on better fillings, 0.01 to 100 |
    | `size_weight` | 0.7 | of wanted sizes against shapes, 0 to 1 |
    | `transition` | 0.5 | of a patch's depth, over which sizes change, 0.05 to 1 |
    | `least_size` | 0.125 | area over wanted area; no smaller face is made, 0 to 1 |
    | `sharp_angle` | 40.0 | triangles are not paired over sharper edges, 0 to 180 degrees |
    | `size_band` | 0.0 | log2 of area; faces off the field "size" by less stay, 0 to 8 |
    | `min_edge` | 0.0 | least "size" of an indicator, in units of length, 0 to 1e30 |
    | `max_edge` | 0.0 | largest one, 0 to 1e30; 0: the extent of the mesh |
    | `gradation` | 0.2 | growth of the "size" of an indicator over the length it grows in, 0.01 to 100 |
    | `error_order` | 1.0 | power of the edge length that an indicator is like, 0.1 to 16 |
    | `edges` | none | (n, 2) vertices: edges of a new mesh that no pair of triangles crosses |

    With ``edit_boundary=1`` vertices come and go on the boundary of a plane mesh where edges would be far from
    the wanted length, and where that saves singular vertices. Flagged ones, corners and ends of markers stay;
    new ones lie on the boundary as it was, or see `Mesh.set_projection`. On a curved mesh and with
    ``strategy=1`` it lets chords take vertices from features and boundary where these turn by less than 30
    degrees. ``size_band`` is for whole plane meshes.

    Raises `RangeError` for a value out of range, `NotFiniteError`, and AttributeError for a name that is none.

    >>> options = Options(seed=7)
    >>> options.effort = 4
    >>> options.seed, options.effort, options.candidates
    (7, 4.0, 16)
    """

    __slots__ = ("__weakref__",)

    seed: int
    smooth_steps: int
    repair_patches: int
    candidates: int
    node_limit: int
    quadrangulate: int
    edit_boundary: int
    strategy: int
    align: int
    chart: int
    keep_boundary: int
    starts: int
    buffer_layers: int
    min_quality: float
    min_convexity: float
    patch_faces: float
    tolerance: float
    effort: float
    size_weight: float
    transition: float
    least_size: float
    sharp_angle: float
    size_band: float
    min_edge: float
    max_edge: float
    gradation: float
    error_order: float

    def __init__(self, **settings: int | float | ArrayLike) -> None:
        _alphamst.amst_options_create(self)
        for name, value in settings.items():
            if name not in KEYS and name != "edges":
                raise TypeError(f"there is no setting {name!r}; there are {', '.join(KEYS)}, edges")
            setattr(self, name, value)

    def get(self, key: int) -> int | float:
        """The setting with that number in ``alphamst.h``; below 1000 they are whole."""
        if key < 1000:
            return _alphamst.amst_options_get_int(self, key)
        return _alphamst.amst_options_get_real(self, key)

    def set(self, key: int, value: float) -> None:
        """Likewise."""
        if key < 1000:
            _alphamst.amst_options_set_int(self, key, value)
        else:
            _alphamst.amst_options_set_real(self, key, value)

    @property
    def edges(self) -> Ids:
        """(n, 2) vertices: edges of a new mesh that no pair of triangles crosses."""
        return as_long_as_the_answer(lambda out: _alphamst.amst_options_get_edges(self, out)).reshape(-1, 2)

    @edges.setter
    def edges(self, edges: ArrayLike) -> None:
        given = ids(edges, None if np.size(edges) == 0 and np.ndim(edges) == 1 else 2)
        _alphamst.amst_options_set_edges(self, given)


def setting(name: str, key: int) -> property:
    return property(
        lambda self: self.get(key), lambda self, value: self.set(key, value), doc=f"The setting `{name}`."
    )


for _name, _key in KEYS.items():
    setattr(Options, _name, setting(_name, _key))


def chosen(options: Options | None, settings: Settings) -> Options | None:
    """What a function with the keywords ``options=None, **settings`` hands to the library."""
    if not settings:
        return options
    if options is not None:
        raise TypeError("give options or single settings, not both")
    return Options(**settings)
