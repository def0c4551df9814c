"""What contexts, options, meshes, patches and reports have in common."""

from __future__ import annotations

from typing import TypeVar

from . import _alphamst

T = TypeVar("T", bound="Handle")


class Handle(_alphamst.Handle):
    """A handle of the library that is destroyed once, by ``close()``, by ``with`` or when it is collected.

    >>> from alphamst import Options
    >>> with Options(seed=7) as options:
    ...     options.seed
    7
    >>> options
    <Options, closed>
    """

    __slots__ = ()

    def __enter__(self: T) -> T:
        return self

    def __exit__(self, *failure: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<{type(self).__name__}{', closed' if self.closed else ''}>"
