"""Simplify: three faces where there were four, patch by patch over the whole mesh. A patch that cannot have its
wanted faces is left as it was.

    python3 examples/python/simplify.py examples/data/coast_small.msh [after.svg]
"""

import sys

from alphamst import Mesh, Options, Patches


def simplify(path, picture=None):
    options = Options(patch_faces=80, seed=7)
    mesh = Mesh.read(path, options=options)
    patches = Patches(mesh, options=options)
    n = patches.decompose("clusters")
    report = mesh.adapt(0.75, patches, options=options)

    left = 0
    print(f"{'patch':>5} {'before':>6} {'wanted':>6} {'after':>6} {'singular':>9}")
    for patch in range(n):
        done = report[patch]
        is_left = done.status < 0
        left += is_left
        numbers = f"{done.faces_before:6} {done.faces_wanted:6} {done.faces_after:6} {done.singular_after:9}"
        print(f"{patch + 1:5} {numbers}{'  left' if is_left else ''}")
    print(f"{left} of {n} patches left")
    if picture:
        patches.write(picture)


if len(sys.argv) < 2:
    sys.exit("usage: simplify.py MESH [PICTURE]")
simplify(*sys.argv[1:])
