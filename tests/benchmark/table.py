"""table.py REPORT: Google Benchmark's JSON as lines of measured value and bound."""
import json
import sys

# Benchmark name begins with, counter (None: its time in ms), what it is, bound or None.
ROWS = [
    ("create_million", "ratio", "create 10^6 quads / bare OpenMesh add_face loop", 1.5),
    ("create_million", "bytes_per_face", "  bytes a face, afterwards", 400),
    ("create_million", "bytes_per_face_most", "  bytes a face, at the most on the way", None),
    ("get_back/dim:2", "points_ratio", "get points / memcpy, 2 coordinates", 3),
    ("get_back/dim:3", "points_ratio", "get points / memcpy, 3 coordinates", 3),
    ("get_back/dim:3", "faces_ratio", "get faces / memcpy", 3),
    ("chord/labels", "seconds", "chord labels of 10^6 faces: s", 0.5),
    ("chord/removal/grid", "seconds", "every chord that can go out of 10^5 faces: s", 5),
    ("chord/removal/grid", "left", "  faces left", None),
    ("growth", "exponent", "growth of time with faces, 10^3 to 10^5", 1.1),
]
for mesh in ("made", "file"):
    where = {"made": "random triangles in three", "file": "gmsh"}[mesh]
    for alpha in ("0.5", "1", "2", "4"):
        name = f"adapt/{mesh}/faces:100/alpha:{alpha}/"
        ROWS += [
            (name, "patch_ms", f"100 faces, alpha {alpha}, {where}: ms in the patch, median", 3),
            (name, None, "  ms of predict and adapt, median", None),
            (name, "worst_ms", "  ms of predict and adapt, worst", None),
            (name, "left", "  patches left as they were", None),
        ]
    name = f"adapt/{mesh}/faces:10000/alpha:2/"
    ROWS += [
        (name, None, f"10,000 faces, alpha 2, {where}: ms of predict and adapt, median", 500),
        (name, "worst_ms", "  ms, worst", None),
        (name, "left", "  patches left as they were", None),
    ]
for tools in ("chords", "templates", "both"):
    for alpha in ("0.5", "0.25"):
        name = f"chord/coarsen/{tools}/alpha:{alpha}/"
        ROWS += [
            (name, "faces", f"5,000 faces coarsened by {tools}, alpha {alpha}: faces", None),
            (name, "singular", "  singular vertices", None),
            (name, "scaled_jacobian", "  least scaled Jacobian", None),
            (name, None, "  ms", None),
        ]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        measured = json.load(file)["benchmarks"]
    print(f"\n{'':66}{'measured':>10}{'at most':>9}")
    for name, counter, text, bound in ROWS:
        run = next((run for run in measured if run["name"].startswith(name)), None)
        if run is None:
            continue
        if run.get("error_occurred"):
            print(f"{text:66}{run['error_message']:>10}")
            continue
        value = run["real_time"] if counter is None else run[counter]
        verdict = "" if bound is None else f"{bound:>9g}  {'ok' if value <= bound else 'MISSED'}"
        print(f"{text:66}{value:>10.2f}{verdict}")


main()
