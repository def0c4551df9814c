"""Meshes that the tests share."""

import numpy as np

from alphamst import Mesh, Patches


def points(nx, ny):
    """Vertex (i, j) has row j * (nx + 1) + i and lies at (i, j)."""
    return np.array([(float(i), float(j)) for j in range(ny + 1) for i in range(nx + 1)])


def faces(nx, ny, dtype=np.int32):
    """Face (i, j) has row j * nx + i."""
    first = np.array([j * (nx + 1) + i for j in range(ny) for i in range(nx)], dtype)
    return np.stack([first, first + 1, first + nx + 2, first + nx + 1], axis=1).astype(dtype)


def grid(nx, ny=None, **keywords):
    ny = nx if ny is None else ny
    return Mesh(points(nx, ny), faces(nx, ny), **keywords)


def square(nx, low, high):
    """The faces (i, j) with low <= i, j < high of a grid of nx columns."""
    return [j * nx + i for j in range(low, high) for i in range(low, high)]


def grid_with_square(**keywords):
    """A mesh of 10 x 10 faces with one patch in the middle."""
    mesh = grid(10, **keywords)
    patches = Patches(mesh)
    patches.add_faces(square(10, 2, 8))
    return mesh, patches


def two_patches(context):
    mesh = grid(10, context=context)
    patches = Patches(mesh)
    patches.add_faces(square(10, 0, 4))
    patches.add_faces(square(10, 4, 8))
    return mesh, patches
