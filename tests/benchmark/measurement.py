"""Whole meshes by this library: how each came about and what the judge says of it, one row a mesh."""
import dataclasses
import json
import math

import judge
import process

LIMIT = 900  # seconds for one mesh by AlphaMST


@dataclasses.dataclass
class Row:
    name: str
    run: process.Run = None  # None: a mesh that was given
    numbers: dict = None     # None: there is no mesh
    changed: int = 0         # boundary edges that only this mesh or only the input has
    inside: float = None     # seconds of the operation alone
    on_two: float = None     # seconds of the program on two threads, where that was tried
    alpha: float = None      # of a mesh by AlphaMST
    fault: str = ""


class Measurement:
    def __init__(self, program, folder, seed):
        self.program, self.folder, self.seed = program, folder, seed
        self.judge = judge.Judge(program)
        folder.mkdir(parents=True, exist_ok=True)

    def add_mesh(self, row, path, edges=None, reference=None):
        try:
            row.numbers = self.judge.numbers(path, reference)
        except judge.Refusal as refusal:
            row.fault = str(refusal)
        row.changed = 0 if edges is None else len(judge.boundary(path) ^ edges)

    def read(self, path):
        """The mesh of any file as the library takes it, in MSH."""
        given = self.folder / f"{path.stem}.msh"
        return given, process.run([self.program, path, given], LIMIT)

    def adapt(self, given, path, alpha, threads):
        row = Row(f"AlphaMST alpha = {alpha:.4g}", alpha=alpha)
        process.say(f"{given.name}: {row.name}, threads {threads}")
        path.unlink(missing_ok=True)
        row.run = process.run([self.program, given, path, alpha, self.seed, threads], LIMIT)
        row.fault = row.run.fault
        if not row.fault:
            row.inside = json.loads(row.run.output)["seconds"]
        return row

    def check(self, row, path, edges, faces, reference=None):
        """What is wrong with a mesh by AlphaMST, of one with that boundary and so many faces."""
        if not row.fault:
            self.add_mesh(row, path, edges, reference)
            row.fault = row.fault or fault_of(row, math.floor(row.alpha * faces + 0.5))

    def draw(self, mesh, picture):
        return process.run([self.program, mesh, picture], LIMIT).fault


def fault_of(row, wanted):
    faults = []
    if row.numbers["inverted"] > 0:
        faults.append(f"{row.numbers['inverted']} inverted quads")
    if (row.numbers["quad"], row.numbers["F"]) != (wanted, wanted):
        faults.append(f"{row.numbers['F']} faces instead of {wanted}")
    if row.changed > 0:
        faults.append(f"{row.changed} boundary edges changed")
    return ", ".join(faults)


def print_rows(head, rows):
    print("\n| " + " | ".join(head) + " |\n| --- |" + " ---: |" * (len(head) - 1))
    for row in rows:
        print("| " + " | ".join(row) + " |")
