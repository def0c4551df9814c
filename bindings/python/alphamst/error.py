"""Failures of the library as exceptions."""

from __future__ import annotations

from collections.abc import Mapping

from . import _alphamst
from .library import status_name

ENTITIES = {"vertex": 0, "edge": 1, "face": 2}


class AlphaMSTError(Exception):
    """What is raised when the library refuses or fails; everything is as it was before the call.

    Each status has a class of its own below this one, e.g. `StaleError`.

    * ``code``: the status, below 0; ``name`` has its name
    * ``text``: the library's sentence
    * ``entity``: what it is about, "vertex", "edge" or "face", or None
    * ``id``: number of that vertex, edge or face, None if none
    * ``patch``: number of the patch it is about, None if none
    """

    def __init__(
        self,
        code: int,
        text: str,
        entity: str | None = None,
        id: int | None = None,
        patch: int | None = None,
    ) -> None:
        super().__init__(code, text, entity, id, patch)
        self.code, self.text = code, text
        self.entity, self.id, self.patch = entity, id, patch

    @property
    def name(self) -> str:
        """Name of the status in ``alphamst.h``."""
        return status_name(self.code)

    def __str__(self) -> str:
        place = [] if self.entity is None else [f"{self.entity} {self.id}"]
        place += [] if self.patch is None else [f"patch {self.patch}"]
        return f"{self.name}: {self.text}" + (f" ({', '.join(place)})" if place else "")


class InternalError(AlphaMSTError):
    """A bug in the library."""


class NullError(AlphaMSTError, TypeError):
    """Something that is required was None."""


class ArgumentError(AlphaMSTError, ValueError):
    """An unacceptable argument."""


class RangeError(AlphaMSTError, ValueError):
    """An id, a count or a value is out of range."""


class BufferTooSmallError(AlphaMSTError, ValueError):
    """An array is too small for the answer."""


class NotFiniteError(AlphaMSTError, ValueError):
    """NaN or infinity in the input."""


class NotQuadError(AlphaMSTError, ValueError):
    """A face without 3 or 4 distinct corners."""


class NotManifoldError(AlphaMSTError, ValueError):
    """An edge of three or more faces, or faces that meet in a vertex alone."""


class PatchError(AlphaMSTError):
    """A patch is no usable disk, see `Patches.check`."""


class StaleError(AlphaMSTError):
    """Patches of an older revision of the mesh."""


class NotFoundError(AlphaMSTError, LookupError):
    """There is no such field, revision or key."""


class FileError(AlphaMSTError, OSError):
    """A file cannot be opened, read or written."""


class FormatError(AlphaMSTError, ValueError):
    """A file is malformed."""


class UnsupportedError(AlphaMSTError, ValueError):
    """A kind of file that this version does not know."""


class CancelledError(AlphaMSTError):
    """Cancelled; the mesh is as before the call."""


class NoMemoryError(AlphaMSTError, MemoryError):
    """There is not enough memory."""


class StateError(AlphaMSTError, RuntimeError):
    """A call that is not allowed now: from a callback, or while another thread works with the same mesh."""


class NoFillingError(AlphaMSTError):
    """No filling with the wanted faces was found."""


class GeometryError(AlphaMSTError):
    """No filling could be given a valid shape."""


class ChordError(AlphaMSTError):
    """A chord cannot be collapsed or split."""


class ProjectionError(AlphaMSTError):
    """The projection of the boundary failed."""


CLASSES = {
    -99: InternalError,
    -1: NullError,
    -2: ArgumentError,
    -3: RangeError,
    -4: BufferTooSmallError,
    -5: NotFiniteError,
    -6: NotQuadError,
    -7: NotManifoldError,
    -8: PatchError,
    -9: StaleError,
    -10: NotFoundError,
    -11: FileError,
    -12: FormatError,
    -13: UnsupportedError,
    -14: CancelledError,
    -15: NoMemoryError,
    -16: StateError,
    -17: NoFillingError,
    -18: GeometryError,
    -19: ChordError,
    -20: ProjectionError,
}


def make_failure(code: int, text: str, entity: int, id: int, patch: int) -> AlphaMSTError:
    """Called by the extension for every failure."""
    failure = CLASSES.get(code, AlphaMSTError)
    return failure(
        code, text, name_of(ENTITIES, entity), id if id >= 0 else None, patch if patch >= 0 else None
    )


_alphamst.set_failure(make_failure)


# -------------------------------------------------------------------------------- names of numbers


def number_of(table: Mapping[str, int], name: str | int) -> int:
    """The number of a name. Numbers pass, so that a table need not be complete."""
    if not isinstance(name, str):
        return name
    if name not in table:
        raise ValueError(f"there is no {name!r}; there are {', '.join(table)}")
    return table[name]


def name_of(table: Mapping[str, int], number: int) -> str | None:
    return next((name for name, value in table.items() if value == number), None)
