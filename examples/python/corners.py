"""Choose the faces of a patch by hand and ask what would come with corners set by hand and with those of the
library; then take the latter.

    python3 examples/python/corners.py examples/data/coast_small.msh [after.svg]
"""

import sys

import numpy as np

from alphamst import Mesh, Patches


def choose(mesh):
    """Faces whose centroid is in the ellipse around (4.9, 5.3)."""
    x, y = mesh.points()[mesh.faces()].mean(axis=1).T
    return np.flatnonzero((x - 4.9) ** 2 / 1.2 + (y - 5.3) ** 2 / 0.7 < 1)


def quarters(patches, patch):
    """Four boundary vertices, a quarter of the boundary from one to the next."""
    loop = patches.boundary(patch)
    return [loop[k * len(loop) // 4] for k in range(4)]


def compare(path, picture=None):
    mesh = Mesh.read(path)
    chosen = choose(mesh)
    patches = Patches(mesh)
    patch = patches.add_faces(chosen)
    defects, convexity = patches.check(patch)
    print(f"{len(chosen)} faces chosen, defects {defects:d}, convexity {convexity:.3f}")

    print(f"{'alpha':>5} {'faces':>6} {'singular, by hand':>18} {'by the library':>18}")
    for alpha in (0.75, 1, 1.5, 2):
        patches.set_corners(patch, quarters(patches, patch))
        by_hand = patches.predict(patch, alpha)
        patches.set_corners(patch, [])
        foreseen = patches.predict(patch, alpha)
        print(f"{alpha:5.2f} {foreseen.faces:6} {by_hand.singularities:18} {foreseen.singularities:18}")
    done = mesh.adapt(1.5, patches)[patch]
    print(f"{'done':>5} {done.faces_after:6} {'':18} {done.singular_after:18}")
    if picture:
        patches.write(picture)


if len(sys.argv) < 2:
    sys.exit("usage: corners.py MESH [PICTURE]")
compare(*sys.argv[1:])
