"""Sizes: what the report tells of the faces of two patches and of both together, for several alphas.

python3 examples/python/sizes.py examples/data/coast_small.msh [after_]
"""

import sys

from alphamst import Mesh, Patches


def print_row(alpha, name, at):
    reals = (
        at.size_error_before,
        at.size_error_after,
        at.least_area_after,
        at.shortest_edge_after,
        at.aspect_ratio_after,
        at.time_step,
    )
    print(
        f"{alpha:5.1f} {name:>5} {at.faces_after:6} {at.singular_after:9}",
        *(f"{real:7.2f}" for real in reals),
    )


def sizes(path, prefix=None):
    mesh = Mesh.read(path)
    begun = mesh.mark()

    names = ("before", "after", "area", "edge", "aspect", "step")
    print(f"{'alpha':>5} {'patch':>5} {'faces':>6} {'singular':>9}", *(f"{name:>7}" for name in names))
    for i, alpha in enumerate((0.5, 1, 2, 4)):
        mesh.rollback(begun)
        patches = Patches(mesh)
        patches.add_ball((4.2, 5.2), 0.7)
        patches.add_ball((6.0, 5.0), 0.7)
        report = mesh.adapt(alpha, patches)
        print_row(alpha, "1", report[0])
        print_row(alpha, "2", report[1])
        print_row(alpha, "both", report)
        if prefix:
            patches.write(f"{prefix}{i}.svg")


if len(sys.argv) < 2:
    sys.exit("usage: sizes.py MESH [PICTURE_PREFIX]")
sizes(*sys.argv[1:])
