#!/usr/bin/env python3
"""How time and memory of a whole plane mesh at alpha = 1 grow with its faces, on one thread and two.

The meshes are the coastline by gmsh, frontal and Blossom full-quad. Ends with 1 if a mesh has
another number of faces than before, or two threads give another mesh than one."""
import argparse
import json
import math
import pathlib
import sys

import outline
import process

COAST = pathlib.Path(__file__).resolve().parents[2] / "examples/data/coast.geo"
COAST_FACES = 4976  # at clscale 1
LIMIT = 7200        # seconds for one run


def adapt(program, given, threads):
    path = given.with_stem(f"{given.stem}_{threads}_threads")
    process.say(f"{given.name}: AlphaMST, threads {threads}")
    run = process.run([program, given, path, 1, 0, threads], LIMIT)
    return run, path, None if run.fault else json.loads(run.output)


def print_row(faces, threads, run, told, speed_up, exponent):
    print(f"| {faces} | {threads} | {run.seconds:.2f} | {told['seconds']:.2f} | {1e6 * told['seconds'] / faces:.0f} "
          f"| {'' if exponent is None else f'{exponent:.2f}'} | {'' if speed_up is None else f'{speed_up:.2f}'} "
          f"| {run.megabytes:.1f} | {1e6 * run.megabytes / faces:.0f} |")


def measure(program, wanted, folder, before):
    """Faults, and faces with the seconds on one thread for the exponent of the next size."""
    given = folder / f"growth_{wanted}.msh"
    process.say(f"{given.name}: gmsh")
    run, _ = outline.mesh_all_quads(COAST, round(math.sqrt(COAST_FACES / wanted), 4), given)
    if run.fault:
        return [f"{given.name}: {run.fault}"], before
    runs = {threads: adapt(program, given, threads) for threads in (1, 2)}
    faults = [f"{given.name}, threads {threads}: {run.fault}" for threads, (run, *_) in runs.items() if run.fault]
    if faults:
        return faults, before
    alone, faces = runs[1][2]["seconds"], runs[1][2]["wanted"]
    exponent = math.log(alone / before[1]) / math.log(faces / before[0]) if before else None
    for threads, (run, _, told) in runs.items():
        if told["faces"] != faces:
            faults.append(f"{given.name}, threads {threads}: {told['faces']} faces instead of {faces}")
        print_row(faces, threads, run, told, alone / told["seconds"] if threads > 1 else None,
                  exponent if threads == 1 else None)
    if runs[1][1].read_bytes() != runs[2][1].read_bytes():
        faults.append(f"{given.name}: two threads give another mesh than one")
    return faults, (faces, alone)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, required=True, help="whole_run as it was built")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the meshes")
    parser.add_argument("--full", action="store_true", help="a million faces, too")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    sys.stdout.reconfigure(line_buffering=True)
    print("| faces | threads | s | s alone | microseconds a face | exponent | speed-up | MB | bytes a face |\n"
          "|" + " ---: |" * 9)
    faults, before = [], None
    for wanted in [10**4, 10**5] + [10**6] * arguments.full:
        found, before = measure(arguments.program.resolve(), wanted, arguments.out, before)
        faults += found
    print("\ns, MB: wall time and most memory of the whole program, files included; s alone: of the operation.\n"
          "The exponent is that of time over faces since the row of one thread before; 1 is linear.")
    for fault in faults:
        print(f"FAULT {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
