"""Arrays that go in, and arrays that the library fills.

``get(out)`` is a getter of the header with its other arguments bound; it gives the number of elements.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

Ids = NDArray[np.int32]
Reals = NDArray[np.float64]


def filled(
    get: Callable[[NDArray | None], int], dtype: DTypeLike, shape: tuple[int, ...], out: NDArray | None = None
) -> NDArray:
    """A new array, or the caller's: in place if it is packed and of that type."""
    if out is None:
        out = np.empty(shape, dtype)
        get(out)
        return out
    if out.shape != shape:
        raise ValueError(f"the array is {out.shape}, but there are {shape} numbers")
    if out.dtype == dtype and out.flags.c_contiguous:
        get(out)
    else:
        out[...] = filled(get, dtype, shape)
    return out


def as_long_as_the_answer(get: Callable[[NDArray | None], int], dtype: DTypeLike = np.int32) -> NDArray:
    out = np.empty(get(None), dtype)
    get(out)
    return out


def reals(values: ArrayLike, columns: int | None = None) -> Reals:
    """A packed array of float64, the same one if it is that already; (n, columns) if columns are given."""
    return checked(np.ascontiguousarray(values, np.float64), columns)


def ids(values: ArrayLike, columns: int | None = None) -> Ids:
    """Likewise of int32. Numbers that are not whole, or too large, are an error."""
    given = np.asarray(values)
    if given.dtype != np.int32:
        if given.size == 0:
            given = given.astype(np.int32)
        elif given.dtype.kind not in "iu":
            raise TypeError(f"ids are whole numbers, not {given.dtype}")
        elif given.min() < -(2**31) or given.max() >= 2**31:
            raise OverflowError("ids need no more than 32 bits")
    return checked(np.ascontiguousarray(given, np.int32), columns)


def checked(array: NDArray, columns: int | None) -> NDArray:
    if columns is not None and (array.ndim != 2 or array.shape[1] != columns):
        raise ValueError(f"an array (n, {columns}) is needed, not {array.shape}")
    if columns is None and array.ndim != 1:
        raise ValueError(f"an array (n,) is needed, not {array.shape}")
    return array


def by_strides(values: ArrayLike, dtype: DTypeLike) -> tuple[NDArray, int, int]:
    """A matrix as it lies in memory, and its strides in elements.

    The library wants strides above 0; what runs backwards, or is of another type, is copied.
    """
    given = np.asarray(values)
    if given.ndim != 2:
        raise ValueError(f"a matrix is needed, not {given.shape}")
    array = np.asarray(given, dtype)
    if any(stride <= 0 or stride % array.itemsize for stride in array.strides):
        array = np.array(array, order="C")
    return array, array.strides[0] // array.itemsize, array.strides[1] // array.itemsize


def three_coordinates(point: ArrayLike) -> Reals:
    """z = 0 if there are two."""
    given = reals(point)
    if given.size not in (2, 3):
        raise ValueError("a point has 2 or 3 coordinates")
    return given if given.size == 3 else np.append(given, 0.0)
