#!/usr/bin/env python3
"""Whole plane meshes: this library beside gmsh on the same outlines, as tables in Markdown.

Of an outline (.geo) gmsh makes meshes in several ways; the one by frontal triangles and full-quad
Blossom is what AlphaMST starts from. A mesh file is that itself. Ends with 1 if a mesh by AlphaMST
has an inverted quad, another number of faces than asked for, or a changed boundary."""
import argparse
import math
import pathlib
import sys

import judge
import outline
import process
from measurement import Measurement, Row, print_rows

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
BESIDE = REPOSITORY.parent / "shared/data/planar_quad"
BESIDE_MESHES = ["produced_wales_F7594_S574", "lake_F3093_S613", "lake_F10790_S1740",
                 "produced_river_F8866_S391", "produced_lake_F8326_S461", "dealii_hole8170"]
ALPHAS = {1: "improve", 1.5: "refine", 0.8: "simplify"}
SCALES = [1, 0.5]
PICTURE_SCALE = 2.4


class Comparison(Measurement):
    def __init__(self, program, folder, seed, threads):
        super().__init__(program, folder, seed)
        self.threads = threads

    def by_gmsh(self, geo, scale, rows, edges):
        for algorithm, way in outline.ALGORITHMS.items():
            for recombination, how in outline.RECOMBINATIONS.items():
                if (algorithm, recombination) == (6, 3):
                    continue  # the input
                row = Row(f"gmsh {way}, {how}")
                process.say(f"{geo.name}: {row.name}")
                path = self.folder / f"{geo.stem}_{scale}_{algorithm}_{recombination}.msh"
                row.run = outline.mesh(geo, scale, algorithm, recombination, path)
                row.fault = row.run.fault
                if not row.fault:
                    self.add_mesh(row, path, edges)
                if recombination != 2 and outline.is_without_blossom(row.run):
                    row.name += " (odd number of triangles, so without Blossom)"
                rows.append(row)

    def by_alphamst(self, given, rows, edges):
        faces = rows[0].numbers["F"]
        for alpha in ALPHAS:
            path = self.folder / f"{given.stem}_alpha_{alpha}.msh"
            row = self.adapt(given, path, alpha, self.threads)
            self.check(row, path, edges, faces)
            rows.append(row)

    def of_outline(self, geo, scale):
        given = self.folder / f"{geo.stem}_{scale}.msh"
        process.say(f"{geo.name}: gmsh frontal, Blossom full-quad, clscale {scale}")
        run, taken = outline.mesh_all_quads(geo, scale, given)
        rows = [Row("input: gmsh frontal, Blossom full-quad", run, fault=run.fault)]
        self.of_input(given, rows, lambda edges: self.by_gmsh(geo, taken, rows, edges))
        return given, taken, rows

    def of_mesh(self, path):
        given, run = self.read(path)
        rows = [Row("input", fault=run.fault)]
        self.of_input(given, rows)
        return rows

    def of_input(self, given, rows, add_peers=None):
        if not rows[0].fault:
            self.add_mesh(rows[0], given)
        if rows[0].fault:
            return
        edges = judge.boundary(given)
        if add_peers:
            add_peers(edges)
        self.by_alphamst(given, rows, edges)

    def of_picture(self, geo, folder):
        """The input and what becomes of it, small enough for a page."""
        given, scale, rows = self.of_outline(geo, PICTURE_SCALE)
        if not any(row.fault for row in rows if row.alpha or row is rows[0]):
            meshes = {"before": given}
            meshes |= {f"alpha_{a}": self.folder / f"{given.stem}_alpha_{a}.msh" for a in ALPHAS}
            for name, mesh in meshes.items():
                rows[0].fault = rows[0].fault or self.draw(mesh, folder / f"{geo.stem}_{name}.svg")
        return scale, rows


def percent(numbers, metric):
    value = judge.acceptable(numbers, metric)
    return "" if value is None else f"{math.floor(100 * value) / 100:.2f}"  # 100 is all


def measured(row):
    if row.run is None:
        return ["", "", ""]
    inside = "" if row.inside is None else f"{row.inside:.2f}"
    return [f"{row.run.seconds:.2f}", inside, f"{row.run.megabytes:.1f}"]


def print_section(title, rows):
    print(f"\n### {title}")
    lines, quality = [], []
    for row in rows:
        name = row.name + (f": **{row.fault}**" if row.fault else "")
        n = row.numbers
        if n is None:
            lines.append([name] + [""] * 7 + measured(row))
            continue
        triangles = n["F"] - n["quad"]
        lines.append([name, str(n["V"]), f"{n['quad']} + {triangles} triangles" if triangles else str(n["F"]),
                      str(n["irr"]), str(row.changed), str(n["inverted"]), f"{n['SJ_min']:.3f}",
                      f"{n['SJ_mean']:.3f}", *measured(row)])
        quality.append([row.name] + [percent(n, metric) for metric in judge.METRICS])
    print_rows(["", "V", "F", "S", "boundary", "inverted", "SJ least", "SJ mean", "s", "s alone", "MB"], lines)
    print("\nFaces that Verdict calls acceptable, percent, rounded down:")
    print_rows(["", *judge.METRICS.values()], quality)


def print_table_1(rows):
    """As in the paper on alpha MST: one metric a row."""
    by_alpha = {row.alpha: row.numbers for row in rows if row.numbers is not None}
    columns = [alpha for alpha in (None, *ALPHAS) if alpha in by_alpha]
    names = ["input" if alpha is None else f"{ALPHAS[alpha]} (alpha = {alpha})" for alpha in columns]
    lines = [[title, *(percent(by_alpha[alpha], metric) for alpha in columns)]
             for metric, title in judge.METRICS.items()]
    for title, key in (("faces", "F"), ("singular vertices", "irr")):
        lines.append([title, *(str(by_alpha[alpha][key]) for alpha in columns)])
    print("\n### Table 1 of the paper, acceptable faces of the Wales mesh in percent")
    print_rows(["metric", *names], lines)


def print_legend(comparison):
    print(f"Judge: {comparison.judge.name}. gmsh {outline.version()}. AlphaMST: seed {comparison.seed}, "
          f"threads {comparison.threads}.\n\n"
          "S: interior vertices of valence other than 4. boundary: boundary edges that this mesh or the input\n"
          "has and the other has not. SJ: scaled Jacobian. s, MB: wall time and most memory of the whole\n"
          "program, files included; s alone: of the operation. AlphaMST starts from the input, whose seconds\n"
          "come before its own; gmsh starts from the outline and chooses boundary points itself.")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("subjects", nargs="*", type=pathlib.Path, metavar="outline.geo | mesh")
    parser.add_argument("--program", type=pathlib.Path, required=True, help="whole_run as it was built")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the meshes")
    parser.add_argument("--pictures", type=pathlib.Path, help="only draw before and after, into this folder")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=1)
    arguments = parser.parse_args()
    for path in [arguments.program, *arguments.subjects]:
        if not path.exists():
            parser.error(f"there is no {path}")
    return arguments


def main():
    arguments = parse()
    sys.stdout.reconfigure(line_buffering=True)
    comparison = Comparison(arguments.program.resolve(), arguments.out, arguments.seed, arguments.threads)
    outlines = sorted((REPOSITORY / "examples/data").glob("*.geo"))
    beside = [path for name in BESIDE_MESHES if (path := BESIDE / f"{name}.msh").exists()]
    subjects = arguments.subjects or (outlines if arguments.pictures else outlines + beside)
    print_legend(comparison)
    everything = []
    for subject in subjects:
        if arguments.pictures and subject.suffix == ".geo":
            sections = [comparison.of_picture(subject, arguments.pictures)]
        elif subject.suffix == ".geo":
            sections = [comparison.of_outline(subject, scale)[1:] for scale in SCALES]
        else:
            sections = [(None, comparison.of_mesh(subject))]
        for scale, rows in sections:
            print_section(subject.name + (f", clscale {scale}" if scale else ""), rows)
            if "wales" in subject.name:
                print_table_1(rows)
            everything += rows
    faults = [row for row in everything if row.fault and not row.name.startswith("gmsh")]
    print(f"\n{sum(1 for row in everything if row.alpha)} meshes by AlphaMST, {len(faults)} faults.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
