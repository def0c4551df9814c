"""Quality of faces."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from . import _alphamst
from .array import Reals, filled
from .error import number_of
from .geometry import Geometry

METRICS = {
    "area": 0,
    "aspect_ratio": 1,
    "condition": 2,
    "distortion": 3,
    "edge_ratio": 4,
    "jacobian": 5,
    "max_angle": 6,
    "min_angle": 7,
    "oddy": 8,
    "radius_ratio": 9,
    "relative_size": 10,
    "scaled_jacobian": 11,
    "shape": 12,
    "shape_and_size": 13,
    "shear": 14,
    "shear_and_size": 15,
    "skew": 16,
    "stretch": 17,
    "taper": 18,
    "warpage": 19,
}


class Summary(NamedTuple):
    """Of a metric over all faces; ``acceptable`` counts those inside the metric's acceptable range."""

    count: int  # type: ignore[assignment]
    acceptable: int
    min: float
    max: float
    mean: float
    stddev: float


class Quality(Geometry):
    """Of a `Mesh`."""

    __slots__ = ()

    def quality(self, metric: str | int, out: Reals | None = None) -> Reals:
        """A Verdict metric of each face.

        "area", "aspect_ratio", "condition", "distortion", "edge_ratio", "jacobian", "max_angle", "min_angle",
        "oddy", "radius_ratio", "relative_size", "scaled_jacobian", "shape", "shape_and_size", "shear",
        "shear_and_size", "skew", "stretch", "taper" or "warpage". Areas and Jacobians are in squared units of
        the coordinates, angles in degrees, the others have no unit.
        """
        number = number_of(METRICS, metric)
        return filled(
            lambda array: _alphamst.amst_mesh_get_quality(self, number, array),
            np.float64,
            (self.n_faces,),
            out,
        )

    def summary(self, metric: str | int) -> Summary:
        """`Summary` of a metric of `quality` over all faces."""
        return Summary(*_alphamst.amst_mesh_get_summary(self, number_of(METRICS, metric)))
