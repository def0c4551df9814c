"""Wall: a shock runs around a bend between two circles. Under its foot on the outer wall the mesh is refined,
wall and all, and behind it made coarser again; all vertices of the wall stay on the circle.

    python3 examples/python/wall.py 4 [wall_]
"""

import sys

import numpy as np

from alphamst import Mesh

ALONG, ACROSS = 64, 16
INNER, OUTER = 1.0, 2.0


def distance(points):
    """From the origin."""
    x, y = points.T
    return np.sqrt(x * x + y * y)


def divided():
    """Of the bend in parts, by turning from each to the next: sine and cosine are not the same to the last digit
    in every language."""
    cosine, sine = 0.9987954562051724, 0.04906767432741801
    circle = [(1.0, 0.0)]
    for _ in range(ALONG):
        x, y = circle[-1]
        circle.append((cosine * x - sine * y, sine * x + cosine * y))
    circle[-1] = (circle[-1][0], 0.0)
    return np.array(circle)


def bend(circle):
    radii = INNER + (OUTER - INNER) * np.arange(ACROSS + 1) / ACROSS
    faces = np.arange(ALONG * ACROSS)
    corners = (faces + faces // ACROSS)[:, None] + [0, 1, ACROSS + 2, ACROSS + 1]
    return Mesh((circle[:, None, :] * radii[:, None]).reshape(-1, 2), corners)


def projected(markers, points):
    """The two ends of the bend are on y = 0, the rest of its boundary on the two circles."""
    radius = distance(points)
    factor = np.where(radius < (INNER + OUTER) / 2, INNER, OUTER) / radius
    return np.where(points[:, 1:] <= 0, points, points * factor[:, None])


def want_sizes(mesh, foot):
    """The field "size" around the foot of the shock; how many faces that asks for."""
    sizes = np.minimum(0.02 + 0.2 * distance(mesh.points() - foot), 0.08)
    mesh.set_field("vertex", "size", sizes, carry="linear")
    a, b, c, d = sizes[mesh.faces()].T
    length = (a + b + c + d) / 4
    # One after the other, as in every language.
    return np.cumsum(mesh.quality("area") / (length * length))[-1]


def print_row(mesh, step):
    ends = mesh.points()[mesh.edges()]
    boundary = (mesh.edge_faces() == -1).any(axis=1) & (ends[:, 0, 1] + ends[:, 1, 1] > 0)
    wall = ends[boundary & (distance(ends[:, 0]) >= (INNER + OUTER) / 2)]
    farthest = abs(distance(wall.reshape(-1, 2)) - OUTER).max()
    least = mesh.summary("scaled_jacobian").min
    print(f"{step:4} {mesh.n_faces:6} {len(wall):6} {farthest:15.12f} {least:12.4f}")


def run(steps, prefix=None):
    circle = divided()
    mesh = bend(circle)
    mesh.set_projection(projected)

    print(f"{'step':>4} {'faces':>6} {'edges':>6} {'from the wall':>15} {'smallest SJ':>12}")
    for step in range(steps + 1):
        if step > 0:  # 0: as it was made
            foot = OUTER * circle[step * ALONG // (steps + 1)]
            mesh.adapt(want_sizes(mesh, foot) / mesh.n_faces, edit_boundary=1)
        print_row(mesh, step)
        if prefix:
            mesh.write(f"{prefix}{step}.svg")


if len(sys.argv) < 2:
    sys.exit("usage: wall.py STEPS [PICTURE_PREFIX]")
run(int(sys.argv[1]), *sys.argv[2:])
