"""Adapts meshes of quadrilaterals patch by patch: the Python binding of the library AlphaMST.

    from alphamst import Mesh, Patches
    mesh = Mesh.read("coast.msh")
    patches = Patches(mesh)
    patches.add_ball((5.8, 4.8), 0.6)
    report = mesh.adapt(2, patches, seed=7)  # twice the faces
    print(report.faces_after)
    mesh.write("finer.vtk")

Rules that hold for everything here:

* Vertices, edges, faces and patches are numbered from 0 and index arrays directly; -1 is "none". Ids are
  valid for one revision of the mesh.
* Arrays are numpy's, with one row for each point, face or edge: ``points`` is (n, dim), ``faces`` is (n, 4),
  corners counter-clockwise. Lengths are in the unit of the given coordinates, angles in degrees.
* A failure raises an `AlphaMSTError` and leaves everything as it was.
* Contexts, options, meshes, patches and reports end with ``close()``, at the end of a ``with``, or when they
  are collected, in any order. Using one after ``close()`` raises ValueError.
* Calls that take long let other threads of Python run. Those that only ask may run on one mesh together; one
  that changes something needs its mesh, patches, options and context to itself, else there is a `StateError`.
* Ctrl-C stops an operation on the main thread; the mesh is as it was before.
* Names are strings, e.g. "vertex" or "scaled_jacobian". Where one is taken, so is the number it has in
  ``alphamst.h``, for what a later library knows and this package does not.
"""

from .chord import Chord, Refusal
from .context import Context, show_bar
from .error import (
    AlphaMSTError,
    ArgumentError,
    BufferTooSmallError,
    CancelledError,
    ChordError,
    FileError,
    FormatError,
    GeometryError,
    InternalError,
    NoFillingError,
    NoMemoryError,
    NotFiniteError,
    NotFoundError,
    NotManifoldError,
    NotQuadError,
    NullError,
    PatchError,
    ProjectionError,
    RangeError,
    StaleError,
    StateError,
    UnsupportedError,
)
from .field import Overlap
from .library import library_has, library_version, status_name
from .mesh import Flag, Mesh
from .options import Options
from .patches import Check, Defect, Patches, Prediction
from .quality import Summary
from .report import Outcome, Report

__version__ = "0.1.0"
__all__ = [
    "AlphaMSTError",
    "ArgumentError",
    "BufferTooSmallError",
    "CancelledError",
    "Check",
    "Chord",
    "ChordError",
    "Context",
    "Defect",
    "FileError",
    "Flag",
    "FormatError",
    "GeometryError",
    "InternalError",
    "Mesh",
    "NoFillingError",
    "NoMemoryError",
    "NotFiniteError",
    "NotFoundError",
    "NotManifoldError",
    "NotQuadError",
    "NullError",
    "Options",
    "Outcome",
    "Overlap",
    "PatchError",
    "Patches",
    "Prediction",
    "ProjectionError",
    "RangeError",
    "Refusal",
    "Report",
    "StaleError",
    "StateError",
    "Summary",
    "UnsupportedError",
    "library_has",
    "library_version",
    "show_bar",
    "status_name",
]
