"""Closed surfaces of triangles, made up: where these are merged in pairs there are many singularities."""
import itertools
import math
import random


def write_knot(path, around=12, tube=0.55):
    """A tube around a trefoil, which is a curve on a torus of radii 2 and 1; rows of about equilateral
    triangles, each row half a triangle on, all vertices thrown about a little."""
    def centre(t):
        wide = 2 + math.cos(3 * t)
        return [wide * math.cos(2 * t), wide * math.sin(2 * t), math.sin(3 * t)]

    times = [2 * math.pi * i / 4000 for i in range(4001)]
    lengths = list(itertools.accumulate((math.dist(centre(s), centre(t)) for s, t in itertools.pairwise(times)),
                                        initial=0))
    rows = 2 * round(lengths[-1] / (math.sqrt(3) * math.pi * tube / around) / 2)
    throw = random.Random(1)
    points = []
    for i, j in itertools.product(range(rows), range(around)):
        length = (i + throw.uniform(-0.2, 0.2)) / rows * lengths[-1] % lengths[-1]
        t = next(time for time, at in zip(times, lengths) if at >= length)
        angle = 2 * math.pi * (j + i % 2 / 2 + throw.uniform(-0.2, 0.2)) / around
        out = [math.cos(3 * t) * math.cos(2 * t), math.cos(3 * t) * math.sin(2 * t), math.sin(3 * t)]
        along = [b - a for a, b in zip(centre(t - 1e-4), centre(t + 1e-4))]
        side = unit(cross(out, along))
        points.append([c + tube * (math.cos(angle) * o + math.sin(angle) * s)
                       for c, o, s in zip(centre(t), out, side)])
    triangles = []
    for i, j in itertools.product(range(rows), range(around)):
        a, d = i * around + j, i * around + (j + 1) % around
        b, c = (i + 1) % rows * around + j, (i + 1) % rows * around + (j + 1) % around
        triangles += [(a, b, d), (b, c, d)] if i % 2 == 0 else [(a, b, c), (a, c, d)]
    write(path, points, triangles)


def write_pebble(path, parts=10):
    """An icosahedron with its edges in so many parts, blown up and dented."""
    golden = (1 + math.sqrt(5)) / 2
    corners = [p[k:] + p[:k] for p in ([0, s, t * golden] for s in (1, -1) for t in (1, -1)) for k in range(3)]
    faces = [f for f in itertools.combinations(range(12), 3)
             if all(math.dist(corners[a], corners[b]) < 2.1 for a, b in itertools.combinations(f, 2))]
    faces = [(a, b, c) if dot(corners[a], cross(corners[b], corners[c])) > 0 else (a, c, b) for a, b, c in faces]
    numbers, points, triangles = {}, [], []

    def vertex(face, weights):
        key = tuple(sorted((corner, weight) for corner, weight in zip(face, weights) if weight))
        if key not in numbers:
            numbers[key] = len(points)
            x, y, z = unit([sum(w * corners[corner][k] for corner, w in key) for k in range(3)])
            size = 1 + 0.2 * math.sin(4 * x) * math.sin(3 * y + z) + 0.1 * math.sin(5 * z)
            points.append([1.4 * size * x, size * y, 0.9 * size * z])
        return numbers[key]

    for face in faces:
        for i, j in itertools.product(range(parts), repeat=2):
            k = parts - 1 - i - j
            if k >= 0:
                triangles.append([vertex(face, w) for w in ((i + 1, j, k), (i, j + 1, k), (i, j, k + 1))])
            if k >= 1:
                triangles.append([vertex(face, w) for w in ((i, j + 1, k), (i + 1, j, k), (i + 1, j + 1, k - 1))])
    write(path, points, triangles)


SHAPES = {"knot": write_knot, "pebble": write_pebble}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def write(path, points, triangles):
    lines = ["OFF", f"{len(points)} {len(triangles)} 0", *(" ".join(f"{x:.9f}" for x in p) for p in points),
             *(f"3 {a} {b} {c}" for a, b, c in triangles)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
