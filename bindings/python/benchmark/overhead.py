"""What the binding costs over the library: nanoseconds of a question with one number for an answer over the raw
call, and the time of filling arrays of a mesh with 10^6 vertices over that of copying as many bytes.

    PYTHONPATH=build/release/bindings/python python3 bindings/python/benchmark/overhead.py
"""

import timeit

import numpy as np

from alphamst import Mesh, _alphamst

N = 999  # 10^6 vertices
CALLS = 10**6


def large_mesh():
    x, y = np.meshgrid(np.arange(N + 1.0), np.arange(N + 1.0))
    first = (np.arange(N)[:, None] * (N + 1) + np.arange(N)).ravel()
    return Mesh(
        np.column_stack([x.ravel(), y.ravel()]), np.stack([first, first + 1, first + N + 2, first + N + 1], 1)
    )


def least(call, number, rounds=10):
    """Seconds of a call; the least of several rounds: what is above is the machine's other work."""
    return min(timeit.repeat(call, number=number, repeat=rounds)) / number


def compare(name, out, get):
    get(out)
    target = np.empty_like(out)
    copying, getting = least(lambda: np.copyto(target, out), 5), least(lambda: get(out), 5)
    print(
        f"{name:12} {1e3 * getting:8.3f} ms   copy {1e3 * copying:8.3f} ms   ratio {getting / copying:5.2f}"
    )


def main():
    mesh = large_mesh()
    names = {"mesh": mesh, "get": _alphamst.amst_mesh_get_revision}

    def nanoseconds(text):
        return 1e9 * min(timeit.repeat(text, globals=names, number=CALLS, repeat=10)) / CALLS

    empty, raw, property = nanoseconds("mesh"), nanoseconds("get(mesh)"), nanoseconds("mesh.revision")
    print(f"revision     {property - empty:8.1f} ns   raw  {raw - empty:8.1f} ns")
    compare("points", np.empty((mesh.n_vertices, 2)), mesh.points)
    compare("faces", np.empty((mesh.n_faces, 4), np.int32), mesh.faces)


if __name__ == "__main__":
    main()
