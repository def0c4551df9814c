"""Surface: a torus of triangles that lie at random becomes quads, and a fraction alpha of these, with few singular
vertices; all vertices stay on the surface.

    python3 examples/python/surface.py 0.5 [after.svg]
"""

import sys

import numpy as np

from alphamst import Mesh

AROUND, ACROSS = 64, 24
RADIUS, TUBE = 1.0, 0.4  # from the axis to the middle of the tube; its radius


def noise():
    """Numbers of -0.5 to 0.5 at random, the same in every language."""
    state = 1
    while True:
        state = (1103515245 * state + 12345) % 2147483648
        yield state / 2147483648 - 0.5


def distance(points):
    x, y, z = points.T
    off = np.sqrt(x * x + y * y) - RADIUS
    return abs(np.sqrt(off * off + z * z) - TUBE)


def projected(points):
    """The points of the torus that are nearest."""
    x, y, z = points.T
    away = np.sqrt(x * x + y * y)
    off = away - RADIUS
    height = np.sqrt(off * off + z * z)
    wide = (RADIUS + off / height * TUBE) / away
    return np.column_stack([x * wide, y * wide, z / height * TUBE])


def divided(n, cosine, sine):
    """Of a circle in n parts, by turning from each to the next: sine and cosine are not the same to the last digit
    in every language."""
    circle = [(1.0, 0.0)]
    for _ in range(n - 1):
        x, y = circle[-1]
        circle.append((cosine * x - sine * y, sine * x + cosine * y))
    return circle


def torus():
    long_way = divided(AROUND, 0.9951847266721969, 0.0980171403295606)
    short_way = divided(2 * ACROSS, 0.9914448613738104, 0.13052619222005157)
    points, triangles, random = [], [], noise()

    def number(i, j):
        return i % AROUND * ACROSS + j % ACROSS

    for i in range(AROUND):
        for j in range(ACROSS):
            x, y = short_way[2 * j + i % 2]  # every other row by half a cell
            wide = RADIUS + TUBE * x
            at = (wide * long_way[i][0], wide * long_way[i][1], TUBE * y)
            points.append([coordinate + 0.04 * next(random) for coordinate in at])
            a, b, c, d = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
            # In even rows the short diagonals are those from b to d.
            triangles += [(a, b, d), (b, c, d)] if i % 2 == 0 else [(a, b, c), (a, c, d)]
    return projected(np.array(points)), np.array(triangles)


def adapt_torus(alpha, picture=None):
    vertices, triangles = torus()
    mesh = Mesh(vertices, triangles)
    n_sharp = mesh.detect_features(60)
    mesh.set_surface(vertices, triangles)
    report = mesh.adapt(alpha)

    print(f"{len(triangles)} triangles, {n_sharp} sharp edges")
    print(f"{'':24} {'before':>6} {'after':>6}")
    print(f"{'faces':24} {report.faces_before:6} {report.faces_after:6}")
    print(f"{'singular vertices':24} {report.singular_before:6} {report.singular_after:6}")
    print(f"{'smallest scaled Jacobian':24} {report.quality_before:6.3f} {report.quality_after:6.3f}")
    print(f"{distance(mesh.points()).max():.4f} from the torus at most")
    if picture:
        mesh.write(picture)


if len(sys.argv) < 2:
    sys.exit("usage: surface.py ALPHA [PICTURE]")
adapt_torus(float(sys.argv[1]), *sys.argv[2:])
