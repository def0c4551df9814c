"""Wave: adapt while you solve. A ring around the middle of a square runs outwards; before each step the field
"size" asks for small faces near it, and the mesh changes only where its faces are off that. An energy and a
temperature come along: the sum of the one and the linear values of the other stay.

    python3 examples/python/wave.py 6 [wave_]
"""

import sys

import numpy as np

from alphamst import Mesh, Options

SIDE, MIDDLE = 32, 16.0
FIRST_RADIUS = 5


def square():
    """A square of unit squares with the two fields."""
    y, x = np.divmod(np.arange((SIDE + 1) ** 2), SIDE + 1)
    faces = np.arange(SIDE * SIDE)
    corners = (faces + faces // SIDE)[:, None] + [0, 1, SIDE + 2, SIDE + 1]
    mesh = Mesh(np.column_stack([x, y]), corners)
    y, x = np.divmod(faces, SIDE) + np.array(0.5 - MIDDLE)
    mesh.set_field("face", "energy", 1 / (1 + (x * x + y * y) / 32), carry="conserve")
    mesh.set_field("vertex", "temperature", mesh.points() @ [1, 2], carry="linear")
    return mesh


def want_sizes(mesh, radius):
    """The field "size" around the ring: half an edge within 1.5 of it, a whole one from 5 on."""
    x, y = mesh.points().T - MIDDLE
    away = abs(np.sqrt(x * x + y * y) - radius)
    sizes = np.clip(0.5 + 0.5 * (away - 1.5) / 3.5, 0.5, 1)
    mesh.set_field("vertex", "size", sizes, carry="linear")


def total_energy(mesh):
    return mesh.field("face", "energy") @ mesh.quality("area")


def temperature_error(mesh):
    return abs(mesh.field("vertex", "temperature") - mesh.points() @ [1, 2]).max()


def bound(value):
    """The power of ten above a value: its digits are those of rounding, and differ between languages."""
    power, limit = -12, 1e-12
    while power < 0 and not value < limit:
        power, limit = power + 1, 10 * limit
    return f"< 1e{power}"


def print_row(mesh, done, radius, energy):
    faces = f"{done.faces_before:6} {done.faces_wanted:6} {done.faces_after:6} {done.singular_after:9}"
    lost = bound(abs(total_energy(mesh) / energy - 1))
    print(f"{radius:6} {faces} {done.quality_after:12.4f} {lost:>8} {bound(temperature_error(mesh)):>12}")


def wave(steps, prefix=None):
    last_radius = FIRST_RADIUS + steps - 1
    mesh = square()
    energy = total_energy(mesh)
    options = Options(size_band=0.7)

    faces = f"{'before':>6} {'wanted':>6} {'after':>6} {'singular':>9}"
    print(f"{'radius':>6} {faces} {'smallest SJ':>12} {'energy':>8} {'temperature':>12}")
    for radius in range(FIRST_RADIUS, last_radius + 1):
        want_sizes(mesh, radius)
        print_row(mesh, mesh.adapt(1, options=options), radius, energy)
        if prefix:
            mesh.write(f"{prefix}{radius}.svg")
    want_sizes(mesh, last_radius)  # the last call again
    before = mesh.checksum()
    mesh.adapt(1, options=options)
    print("again:", "nothing changed" if mesh.checksum() == before else "the mesh changed")


if len(sys.argv) < 2:
    sys.exit("usage: wave.py STEPS [PICTURE_PREFIX]")
wave(int(sys.argv[1]), *sys.argv[2:])
