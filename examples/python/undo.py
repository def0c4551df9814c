"""Undo: two changes, each taken back, and the mesh is bit for bit what it was.

python3 examples/python/undo.py examples/data/coast_small.msh
"""

import sys

from alphamst import Mesh, Patches


def undo(path):
    mesh = Mesh.read(path)
    digest = mesh.checksum()

    def row(what):
        state = "as at the start" if mesh.checksum() == digest else "changed"
        print(f"{what:16} {mesh.n_faces:6} {len(mesh.singularities()):9}   {state}")

    print(f"{'mesh':16} {'faces':>6} {'singular':>9}")
    row("read")

    first = mesh.mark()
    patches = Patches(mesh)
    patches.add_ball((4.9, 5.3), 0.8)
    mesh.adapt(3, patches)
    row("refined")
    second = mesh.mark()
    mesh.smooth()
    row("smoothed")
    mesh.rollback(second)
    row("not smoothed")
    mesh.rollback(first)
    row("not refined")
    mesh.forget(first)


if len(sys.argv) < 2:
    sys.exit("usage: undo.py MESH")
undo(sys.argv[1])
