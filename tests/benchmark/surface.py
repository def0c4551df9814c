#!/usr/bin/env python3
"""Meshes of curved surfaces by this library on one thread and on two, as a table in Markdown.

A subject is a mesh file with what is wanted of it: MESH:xALPHA, MESH:VERTICES, or MESH alone, which is
alpha 1. Several of one file share its rows. Without subjects: two surfaces of triangles, made here.
Ends with 1 if a mesh by AlphaMST has an inverted quad, another number of faces than asked for or a
changed boundary, or if two threads give another mesh than one."""
import argparse
import json
import pathlib
import sys

import judge
import shape
from measurement import Measurement, Row, print_rows

OWN = ["x1", "x0.5"]  # of each surface that is made here
DISTANCES = ["d_max", "d_rms", "dr_max", "dr_rms"]
HEAD = ["", "V", "F", "S", "inverted", "SJ least", "SJ mean", "to input, most", "rms", "from input, most", "rms",
        "s", "s on 2", "s alone", "MB"]


def alpha_of(wanted, numbers):
    """Vertices and faces of a quad mesh differ by a number that its surface and boundary fix."""
    if wanted.startswith("x"):
        return float(wanted[1:])
    return (int(wanted) + numbers["F"] - numbers["V"]) / numbers["F"]


def measure(bench, path, wishes, peers, pictures):
    """Rows of the input, of peers, and of what becomes of it by each wish."""
    given, run = bench.read(path)
    rows = [Row("input", fault=run.fault)]
    if not run.fault:
        bench.add_mesh(rows[0], given, reference=path)
    if rows[0].fault:
        return rows
    rows += [Row(peer["name"], numbers=peer["numbers"]) for peer in peers]
    drawn = {"before": given}
    for wanted in wishes:
        alpha = alpha_of(wanted, rows[0].numbers)
        row, mesh = adapt(bench, path, given, alpha, rows[0].numbers["F"])
        rows.append(row)
        drawn[f"alpha_{alpha:.4g}"] = mesh
    if pictures and not any(row.fault for row in rows):
        for name, mesh in drawn.items():
            rows[0].fault = rows[0].fault or bench.draw(mesh, pictures / f"{path.stem}_{name}.svg")
    return rows


def adapt(bench, path, given, alpha, faces):
    meshes = {threads: given.with_stem(f"{given.stem}_alpha_{alpha:.4g}_{threads}") for threads in (1, 2)}
    row, other = (bench.adapt(given, mesh, alpha, threads) for threads, mesh in meshes.items())
    bench.check(row, meshes[1], judge.boundary(given), faces, path)
    row.fault = row.fault or other.fault
    row.on_two = other.run.seconds
    if not row.fault and meshes[1].read_bytes() != meshes[2].read_bytes():
        row.fault = "two threads give another mesh than one"
    return row, meshes[1]


def cells(row):
    n = row.numbers
    name = row.name + (f": **{row.fault}**" if row.fault else "")
    line = [name] + [""] * (len(HEAD) - 1)
    if n is not None:
        line[1:7] = [str(n["V"]), str(n["F"]), str(n["irr"]), str(n["inverted"]), f"{n['SJ_min']:.3f}",
                     f"{n['SJ_mean']:.3f}"]
        line[7:11] = [f"{100 * n[key]:.3f}" if key in n else "" for key in DISTANCES]
    if row.run is not None:
        line[11:] = [f"{row.run.seconds:.2f}", f"{row.on_two:.2f}", "" if row.inside is None else f"{row.inside:.2f}",
                     f"{row.run.megabytes:.1f}"]
    return line


def print_legend(bench):
    print(f"Judge: {bench.judge.name}. AlphaMST: seed {bench.seed}.\n\n"
          "S: interior vertices of valence other than 4. SJ: scaled Jacobian. to input, from input: distance of\n"
          "the mesh to the input and of the input to the mesh, largest and root mean square, in percent of the\n"
          "diagonal of the input. s, s on 2, MB: wall time on one thread and on two and most memory of the whole\n"
          "program, files included; s alone: of the operation on one thread.")


def made(folder):
    folder.mkdir(parents=True, exist_ok=True)
    paths = {folder / f"{name}.off": write for name, write in shape.SHAPES.items()}
    for path, write in paths.items():
        write(path)
    return {path: OWN for path in paths}


def subjects_of(words):
    subjects = {}
    for word in words:
        path, _, wanted = word.rpartition(":")
        if not path:
            path, wanted = word, "x1"
        subjects.setdefault(pathlib.Path(path), []).append(wanted)
    return subjects


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("subjects", nargs="*", metavar="MESH[:VERTICES | :xALPHA]")
    parser.add_argument("--program", type=pathlib.Path, required=True, help="whole_run as it was built")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the meshes")
    parser.add_argument("--pictures", type=pathlib.Path, help="draw before and after, into this folder")
    parser.add_argument("--peers", type=pathlib.Path,
                        help="JSON: for the name of a mesh file a list of {name, numbers} by other programs, "
                             "numbers with the keys that the judge gives")
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    arguments.subjects = subjects_of(arguments.subjects)
    for path in [arguments.program, *arguments.subjects]:
        if not path.exists():
            parser.error(f"there is no {path}")
    for wanted in sum(arguments.subjects.values(), []):
        try:
            alpha_of(wanted, {"V": 1, "F": 1})
        except ValueError:
            parser.error(f"after the colon is a number of vertices or x and alpha, not {wanted}")
    return arguments


def main():
    arguments = parse()
    sys.stdout.reconfigure(line_buffering=True)
    bench = Measurement(arguments.program.resolve(), arguments.out, arguments.seed)
    peers = json.loads(arguments.peers.read_text(encoding="utf-8")) if arguments.peers else {}
    print_legend(bench)
    everything = []
    for path, wishes in (arguments.subjects or made(arguments.out / "made")).items():
        rows = measure(bench, path, wishes, peers.get(path.name, []), arguments.pictures)
        print(f"\n### {path.name}")
        print_rows(HEAD, [cells(row) for row in rows])
        everything += rows
    faults = [row for row in everything if row.fault]
    print(f"\n{sum(1 for row in everything if row.alpha)} meshes by AlphaMST, {len(faults)} faults.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
