"""Chords: those of a plate with a hole in colour; two rings more around the hole, and one less.

python3 examples/python/chords.py examples/data/plate.off [chords_]
"""

import sys

import numpy as np

from alphamst import Mesh


def rings(mesh):
    """The shortest closed chords first."""
    closed = np.flatnonzero(mesh.chords("closed"))
    return closed[np.argsort(mesh.chords("length")[closed], kind="stable")]


def ring(mesh):
    return mesh.chords("edge")[rings(mesh)[0]]


def show_chords(what, mesh, prefix, name):
    ids = mesh.chord_ids()
    print(f"{what:16} {mesh.n_faces:6} {len(mesh.singularities()):9} {ids.max() + 1:7} {len(rings(mesh)):7}")
    if prefix:
        mesh.set_field("edge", "chord", ids, carry="drop")
        mesh.write(f"{prefix}{name}.svg")


def draw(path, prefix=None):
    mesh = Mesh.read(path)
    print(f"{'mesh':16} {'faces':>6} {'singular':>9} {'chords':>7} {'closed':>7}")
    show_chords("read", mesh, prefix, "read")
    mesh.split_chord(ring(mesh), 2)
    show_chords("two rings in", mesh, prefix, "in")
    mesh.collapse_chord(ring(mesh))
    show_chords("one ring out", mesh, prefix, "out")


if len(sys.argv) < 2:
    sys.exit("usage: chords.py MESH [PREFIX]")
draw(*sys.argv[1:])
