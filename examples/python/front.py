"""Refine around a moving front: at every step the mesh is fine where the front is and as it was everywhere else.

python3 examples/python/front.py examples/data/coast_small.msh [front_]
"""

import sys

from alphamst import Mesh, Patches


def front(path, prefix=None):
    mesh = Mesh.read(path)
    coarse = mesh.mark()

    print(f"{'step':>4} {'near':>6} {'faces':>6} {'singular':>9} {'smallest SJ':>12}")
    for step in range(5):
        mesh.rollback(coarse)  # the front has moved on
        patches = Patches(mesh)
        patches.add_ball((4.2 + 0.3 * step, 5.2 + 0.05 * step), 0.8)
        done = mesh.adapt(2, patches)
        print(
            f"{step:4} {done.faces_after:6} {mesh.n_faces:6} {done.singular_after:9} {done.quality_after:12.4f}"
        )
        if prefix:
            patches.write(f"{prefix}{step}.svg")


if len(sys.argv) < 2:
    sys.exit("usage: front.py MESH [PICTURE_PREFIX]")
front(*sys.argv[1:])
