"""Numbers of a mesh, told by a program that is not ours where there is one.

That program is named by ALPHAMST_JUDGE, or is quadstats.py in shared/tools beside the repository.
It is called as `PROGRAM --json MESH`, and `--ref INPUT` for distances, and uses VTK's Verdict. Without
it, or with ALPHAMST_JUDGE empty, the numbers are those of our own library, which tells no distances."""
import json
import os
import pathlib
import subprocess
import sys

BESIDE = pathlib.Path(__file__).resolve().parents[3] / "shared/tools/quadstats.py"

METRICS = {"AspectRatio": "aspect ratio", "Condition": "condition", "Distortion": "distortion",
           "MinAngle": "min angle", "MaxAngle": "max angle", "Jacobian": "Jacobian",
           "ScaledJacobian": "scaled Jacobian", "Shape": "shape", "Shear": "shear", "Skew": "skew",
           "Taper": "taper", "Warpage": "warpage"}


OWN = "AlphaMST itself"


class Refusal(Exception):
    """The judge tells nothing about a mesh; our own library, say, of one with triangles."""


class Judge:
    def __init__(self, own):
        named = os.environ.get("ALPHAMST_JUDGE")
        path = BESIDE if named is None and BESIDE.exists() else pathlib.Path(named) if named else None
        if path is None:
            self.command, self.name = [str(own)], OWN
        elif os.access(path, os.X_OK):
            self.command, self.name = [str(path), "--json"], path.name
        else:
            self.command, self.name = [sys.executable, str(path), "--json"], path.name

    def numbers(self, mesh, reference=None):
        """With a reference mesh also d_max, d_rms, the largest and the root mean square distance of this
        mesh to it over its diagonal, and dr_max, dr_rms the other way."""
        against = [] if reference is None or self.name == OWN else ["--ref", str(reference)]
        done = subprocess.run([*self.command, *against, str(mesh)], text=True, capture_output=True, check=False)
        if done.returncode != 0 or not done.stdout:
            lines = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
            raise Refusal(f"{self.name} says: {lines[-1]}")
        return json.loads(done.stdout.splitlines()[-1])


def acceptable(numbers, metric):
    """Percent of the faces within the range that Verdict calls acceptable, or None."""
    told = numbers.get("verdict", {}).get(metric)
    if told is None:
        return None
    # Verdict's manual has a flat quad at 0 and accepts up to 0.7, which is 1 - warpage as VTK has it:
    # a flat quad is at 1. quadstats.py takes the manual's range for VTK's value, so only the smallest
    # value it tells is of use. Our own numbers come without that.
    if metric == "Warpage" and "min" in told:
        return 100.0 if told["min"] >= 0.3 else None
    return told["ok_pct"]


def boundary(path):
    """Edges of one face only, as pairs of points, of a mesh in MSH 2.2."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    first = lines.index("$Nodes") + 2
    points = {}
    for line in lines[first:first + int(lines[first - 1])]:
        tag, *point = line.split()
        points[tag] = tuple(map(float, point))
    first = lines.index("$Elements") + 2
    once = set()
    for line in lines[first:first + int(lines[first - 1])]:
        words = line.split()
        n_corners = {"2": 3, "3": 4}.get(words[1], 0)
        corners = words[len(words) - n_corners:]
        for edge in zip(corners, corners[1:] + corners[:1]):
            once ^= {frozenset(edge)}
    return {frozenset(points[tag] for tag in edge) for edge in once}
