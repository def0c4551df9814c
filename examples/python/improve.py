"""Improve a region: fewer singular vertices and better corners with the same number of faces.

python3 examples/python/improve.py examples/data/coast_small.msh [after.svg]
"""

import sys

from alphamst import Mesh, Patches


def improve(path, picture=None):
    mesh = Mesh.read(path)
    patches = Patches(mesh)
    patches.add_box((3.8, 4.4), (6.2, 6.4))
    region = mesh.adapt(1, patches)[0]

    print(f"{'region':8} {'faces':>6} {'singular':>9} {'smallest SJ':>12}")
    print(f"{'before':8} {region.faces_before:6} {region.singular_before:9} {region.quality_before:12.4f}")
    print(f"{'after':8} {region.faces_after:6} {region.singular_after:9} {region.quality_after:12.4f}")
    if picture:
        patches.write(picture)


if len(sys.argv) < 2:
    sys.exit("usage: improve.py MESH [PICTURE]")
improve(*sys.argv[1:])
