"""What the library says of itself."""

from . import _alphamst


def library_version() -> str:
    """Version of the library in use.

    >>> library_version()
    '0.1.0'
    """
    return _alphamst.amst_version_string()


def library_has(feature: str) -> bool:
    """Whether the library was built with a feature: "threads"."""
    return _alphamst.amst_has(feature) != 0


def status_name(code: int) -> str:
    """Name of a status in ``alphamst.h``.

    >>> status_name(-9)
    'AMST_ERR_STALE'
    """
    return _alphamst.amst_status_name(code)


def is_compatible(number: int) -> bool:
    """Before 1.0 the interface may change with the minor number; later libraries only add to it."""
    return number // 100 == 1  # 0.1


if not is_compatible(_alphamst.amst_version()):
    raise ImportError(f"The library is AlphaMST {library_version()}; this package needs 0.1.")
