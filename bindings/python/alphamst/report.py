"""What an operation did."""

from __future__ import annotations

from . import _alphamst
from .array import Ids, as_long_as_the_answer, filled
from .error import ENTITIES, number_of
from .handle import Handle

ALL = -2
KEYS = {
    "status": 0,
    "faces_before": 1,
    "faces_after": 2,
    "faces_wanted": 3,
    "singular_before": 4,
    "singular_after": 5,
    "singular_bound": 6,
    "candidate": 7,
    "unused_option": 8,
    "alpha": 1000,
    "quality_before": 1001,
    "quality_after": 1002,
    "seconds": 1003,
    "size_error_before": 1004,
    "size_error_after": 1005,
    "least_area_before": 1006,
    "least_area_after": 1007,
    "time_step": 1008,
    "shortest_edge_before": 1009,
    "shortest_edge_after": 1010,
    "aspect_ratio_before": 1011,
    "aspect_ratio_after": 1012,
    "area_gained": 1013,
}


class Numbers:
    """What `Report` tells."""

    __slots__ = ()

    status: int
    faces_before: int
    faces_after: int
    faces_wanted: int
    singular_before: int
    singular_after: int
    singular_bound: int
    candidate: int
    unused_option: int
    alpha: float
    quality_before: float
    quality_after: float
    seconds: float
    size_error_before: float
    size_error_after: float
    least_area_before: float
    least_area_after: float
    time_step: float
    shortest_edge_before: float
    shortest_edge_after: float
    aspect_ratio_before: float
    aspect_ratio_after: float
    area_gained: float

    def get(self, key: int) -> int | float:
        raise NotImplementedError


class Report(Handle, Numbers):
    """What an operation did in all; ``report[patch]`` has the same of one patch, an `Outcome`.

    It outlives mesh and patches.

    | | |
    | --- | --- |
    | `status` | below 0 a patch was left as it was; `status_name` has the name |
    | `faces_before`, `faces_after`, `faces_wanted` | the last is alpha * before, rounded, or see `size_band` |
    | `singular_before`, `singular_after` | interior vertices of valence other than 4 |
    | `singular_bound` | least number that any filling of the boundary has |
    | `candidate` | 0: filling as predicted; n: geometry forced the n-th later one |
    | `unused_option` | number of the first setting that was given in vain, -1 if none |
    | `alpha` | after / before |
    | `quality_before`, `quality_after` | smallest scaled Jacobian |
    | `seconds` | time spent |
    | `size_error_before`, `size_error_after` | root mean square of log2(area / wanted area), NaN: none wanted |
    | `least_area_before`, `least_area_after` | smallest area / wanted area; NaN likewise |
    | `time_step` | smallest area / perimeter of a face, after over before |
    | `shortest_edge_before`, `shortest_edge_after` | smallest edge / root of the wanted area; NaN likewise |
    | `aspect_ratio_before`, `aspect_ratio_after` | largest aspect ratio of a face |
    | `area_gained` | area after less area before, with `edit_boundary`; else 0 |

    Over all patches counts are sums, singularities those of the whole mesh, qualities, areas and edges the
    smallest, aspect ratios the largest, the size error is the root mean square over the faces of all patches and
    the time step that of the whole mesh; an operation without patches has only that.
    """

    __slots__ = ("__weakref__",)

    def __getitem__(self, patch: int) -> Outcome:
        """Of one patch. Raises `RangeError`."""
        self.get(0, patch)
        return Outcome(self, patch)

    def get(self, key: int, patch: int = ALL) -> int | float:
        """What has that number in ``alphamst.h``; below 1000 it is whole. Raises `NotFoundError`."""
        if key < 1000:
            return _alphamst.amst_report_get_int(self, patch, key)
        return _alphamst.amst_report_get_real(self, patch, key)

    @property
    def is_partial(self) -> bool:
        """Whether some patch was left as it was or has not the wanted number of faces."""
        return self.status == 1

    def valence_before(self, valence: int, patch: int = ALL) -> int:
        """Interior vertices of one valence before the operation, in the whole mesh or in one patch."""
        return _alphamst.amst_report_get_valence(self, patch, 0, valence)

    def valence_after(self, valence: int, patch: int = ALL) -> int:
        """Likewise after it."""
        return _alphamst.amst_report_get_valence(self, patch, 1, valence)

    def origin(self, entity: str | int, out: Ids | None = None) -> Ids:
        """For each "vertex", "edge" or "face" after the operation the one it was before, -1 if none.

        Edges and faces are the same if their vertices are.
        """
        kind = number_of(ENTITIES, entity)

        def get(array: Ids | None) -> int:
            return _alphamst.amst_report_get_origin(self, kind, array)

        return as_long_as_the_answer(get) if out is None else filled(get, "int32", (get(None),), out)


class Outcome(Numbers):
    """What an operation did to one patch: the numbers of `Report`."""

    __slots__ = {"report": "What it is part of.", "patch": "The id of the patch."}

    def __init__(self, report: Report, patch: int) -> None:
        self.report, self.patch = report, patch

    def get(self, key: int) -> int | float:
        """What has that number in ``alphamst.h``, see `Report.get`."""
        return self.report.get(key, self.patch)


def number(name: str, key: int) -> property:
    return property(lambda self: self.get(key), doc=f"`{name}`, see `Report`.")


for _name, _key in KEYS.items():
    setattr(Numbers, _name, number(_name, _key))
