"""Files of the library in the hands of VTK, meshio and Gmsh, and theirs in its own: points, faces, markers and fields are
the same. readers.py LIBRARY FOLDER GMSH, with the system's Python that has both."""

import ctypes
import os
import subprocess
import sys

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

VERTEX, EDGE, FACE = 0, 1, 2
LINEAR, INHERIT, CONSERVE = 2, 1, 3


class Library:
    def __init__(self, path):
        self.calls = ctypes.CDLL(path)
        self.calls.amst_last_error.restype = ctypes.c_char_p
        self.context = ctypes.c_void_p()
        self("context_create", 0, ctypes.byref(self.context))

    def __call__(self, name, *arguments):
        status = getattr(self.calls, "amst_" + name)(*arguments)
        if status != 0:
            raise RuntimeError(f"{name}: {status}, {self.calls.amst_last_error().decode()}")


class Mesh:
    def __init__(self, library):
        self.library, self.handle = library, ctypes.c_void_p()

    def __call__(self, name, *arguments):
        self.library("mesh_" + name, self.handle, *arguments)

    def read(self, path):
        self.library("mesh_read", self.library.context, path.encode(), None, ctypes.byref(self.handle))
        return self

    def create(self, points, faces):
        self.library("mesh_create", self.library.context, points.shape[1], pointer(points),
                     ctypes.c_int64(len(points)), ctypes.c_int64(0), ctypes.c_int64(0), pointer(faces),
                     ctypes.c_int64(len(faces)), ctypes.c_int64(0), ctypes.c_int64(0), 4, None,
                     ctypes.byref(self.handle))
        return self

    def array(self, name, kind, *arguments):
        needed = ctypes.c_int64()
        self(name, *arguments, None, ctypes.c_int64(0), ctypes.byref(needed))
        found = np.empty(needed.value, kind)
        self(name, *arguments, pointer(found), ctypes.c_int64(len(found)), ctypes.byref(needed))
        return found

    def field(self, entity, name):
        return self.array("get_field", np.float64, entity, name.encode())

    def markers(self, entity):
        return self.array("get_markers", np.int32, entity)

    def edges(self):
        """{ends: marker} of those with one"""
        pairs = self.array("get_edges", np.int32).reshape(-1, 2)
        return {tuple(map(int, pair)): int(m) for pair, m in zip(pairs, self.markers(EDGE)) if m != 0}


def pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


def sample():
    """3 x 2 squares: points, faces, and what else is to come back."""
    points = np.array([[i / 3 + 0.01 * j, j / 7, 0.1 * i * j] for j in range(3) for i in range(4)])
    faces = np.array([[v, v + 1, v + 5, v + 4] for v in (0, 1, 2, 4, 5, 6)], np.int32)
    return points, faces, {
        "heat": np.sqrt(np.arange(12.0)),
        "velocity": np.arange(36.0).reshape(12, 3) / 7,
        "load": np.arange(6.0) / 3,
        "region": np.array([1, 1, 2, 2, 3, 3], np.int32),
        "edges": {(0, 1): 5, (1, 2): 5, (2, 3): 7},
    }


def full(library):
    points, faces, more = sample()
    mesh = Mesh(library).create(points, faces)
    for f, marker in enumerate(more["region"]):
        mesh("set_markers", FACE, pointer(np.array([f], np.int32)), ctypes.c_int64(1), int(marker))
    for ends, marker in more["edges"].items():
        edge = np.empty(1, np.int32)
        mesh("find_edges", pointer(np.array(ends, np.int32)), ctypes.c_int64(1), pointer(edge))
        mesh("set_markers", EDGE, pointer(edge), ctypes.c_int64(1), marker)
    mesh("set_marker_name", EDGE, 5, "the inlet".encode())
    for entity, name, carry in ((VERTEX, "heat", LINEAR), (VERTEX, "velocity", LINEAR), (FACE, "load", CONSERVE)):
        values = np.ascontiguousarray(more[name])
        width = values.shape[1] if values.ndim == 2 else 1
        mesh("set_field", entity, name.encode(), width, carry, pointer(values), ctypes.c_int64(len(values)))
    return mesh


def same(found, wanted, what):
    if not np.array_equal(np.asarray(found).ravel(), np.asarray(wanted).ravel()):
        raise AssertionError(f"{what}: {found} in place of {wanted}")


def test_vtk_reads(library, folder):
    for extension, reader in (("vtu", vtk.vtkXMLUnstructuredGridReader()), ("vtk", vtk.vtkUnstructuredGridReader())):
        points, faces, more = sample()
        path = f"{folder}/ours.{extension}"
        full(library)("write", path.encode())
        reader.SetFileName(path)
        if extension == "vtk":
            reader.ReadAllFieldsOn()
        reader.Update()
        grid = reader.GetOutput()
        same(vtk_to_numpy(grid.GetPoints().GetData()), points, path)
        same([[grid.GetCell(f).GetPointId(k) for k in range(4)] for f in range(6)], faces, path)
        for name in ("heat", "velocity"):
            same(vtk_to_numpy(grid.GetPointData().GetArray(name)), more[name], name)
        same(vtk_to_numpy(grid.GetCellData().GetArray("load"))[:6], more["load"], "load")
        markers = vtk_to_numpy(grid.GetCellData().GetArray("marker"))
        same(markers[:6], more["region"], "marker")
        lines = {tuple(sorted(grid.GetCell(c).GetPointId(k) for k in range(2))): int(markers[c])
                 for c in range(6, grid.GetNumberOfCells())}
        assert lines == more["edges"], lines
        name = grid.GetFieldData().GetArray("marker edge the inlet")
        same(vtk_to_numpy(name), [5], "name")


def test_meshio_reads(library, folder):
    points, faces, more = sample()
    for extension in ("vtu", "vtk", "msh", "msh4"):
        path = f"{folder}/ours.{extension}"
        full(library)("write", path.encode())
        found = meshio.read(path, file_format="gmsh" if extension.startswith("msh") else extension)
        same(found.points, points, path)
        same(found.cells_dict["quad"], faces, path)
        markers = found.cell_data_dict["gmsh:physical" if extension.startswith("msh") else "marker"]
        same(markers["quad"], more["region"], path)
        lines = {tuple(sorted(map(int, ends))): int(marker)
                 for ends, marker in zip(found.cells_dict["line"], markers["line"])}
        assert lines == more["edges"], lines
        if not extension.startswith("msh"):
            same(found.point_data["heat"], more["heat"], "heat")
            same(found.point_data["velocity"], more["velocity"], "velocity")
            same(found.cell_data_dict["load"]["quad"], more["load"], "load")


def grid_of_vtk():
    points, faces, more = sample()
    grid, of_grid = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
    of_grid.SetData(numpy_to_vtk(points, deep=True))
    grid.SetPoints(of_grid)
    for face in faces:
        grid.InsertNextCell(vtk.VTK_QUAD, 4, [int(v) for v in face])
    for ends in more["edges"]:
        grid.InsertNextCell(vtk.VTK_LINE, 2, list(ends))

    def add(data, name, values):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.AddArray(array)

    add(grid.GetPointData(), "heat", more["heat"])
    add(grid.GetPointData(), "velocity", more["velocity"])
    add(grid.GetCellData(), "load", np.concatenate([more["load"], np.zeros(3)]))
    add(grid.GetCellData(), "marker", np.concatenate([more["region"], list(more["edges"].values())]).astype(np.int32))
    return grid


def written_by_vtk(folder):
    grid = grid_of_vtk()
    for mode in ("Ascii", "Binary", "Appended"):
        for compressor in (None, vtk.vtkZLibDataCompressor()):
            for words in ("32", "64"):
                for encode in (True, False) if mode == "Appended" else (True,):
                    for order in ("LittleEndian", "BigEndian"):
                        path = f"{folder}/{mode}{compressor is not None}{words}{encode}{order}.vtu"
                        writer = vtk.vtkXMLUnstructuredGridWriter()
                        writer.SetInputData(grid)
                        writer.SetFileName(path)
                        getattr(writer, "SetDataModeTo" + mode)()
                        writer.SetCompressor(compressor)
                        getattr(writer, f"SetHeaderTypeToUInt{words}")()
                        writer.SetEncodeAppendedData(encode)
                        getattr(writer, "SetByteOrderTo" + order)()
                        writer.SetBlockSize(64)
                        writer.Write()
                        yield path
    for binary in (False, True):
        for version in (42, 51):
            path = f"{folder}/legacy{binary}{version}.vtk"
            writer = vtk.vtkUnstructuredGridWriter()
            writer.SetInputData(grid)
            writer.SetFileName(path)
            writer.SetFileType(vtk.VTK_BINARY if binary else vtk.VTK_ASCII)
            writer.SetFileVersion(version)
            writer.Write()
            yield path


def written_by_meshio(folder):
    points, faces, more = sample()
    mesh = meshio.Mesh(points, [("quad", faces), ("line", np.array(list(more["edges"])))],
                       point_data={"heat": more["heat"], "velocity": more["velocity"]},
                       cell_data={"load": [more["load"], np.zeros(3)],
                                  "marker": [more["region"], np.array(list(more["edges"].values()), np.int32)]})
    for extension, more_arguments in (("vtu", {"compression": None}), ("vtu", {"compression": "zlib"}),
                                      ("vtu", {"binary": False}), ("vtk", {"binary": False}),
                                      ("vtk", {"binary": True})):
        path = f"{folder}/meshio{len(os.listdir(folder))}.{extension}"
        meshio.write(path, mesh, **more_arguments)
        yield path


def test_library_reads(library, folder):
    points, faces, more = sample()
    for path in [*written_by_vtk(folder), *written_by_meshio(folder)]:
        mesh = Mesh(library).read(path)
        # VTK and meshio write words with eleven digits and more
        close = np.allclose(mesh.array("get_points", np.float64), points.ravel(), rtol=1e-9, atol=1e-12)
        assert close, path
        same(mesh.array("get_faces", np.int32), faces, path)
        same(mesh.markers(FACE), more["region"], path)
        assert mesh.edges() == more["edges"], path
        for entity, name in ((VERTEX, "heat"), (VERTEX, "velocity"), (FACE, "load")):
            assert np.allclose(mesh.field(entity, name), more[name].ravel(), rtol=1e-5), (path, name)
        mesh.library.calls.amst_mesh_destroy(mesh.handle)


def test_gmsh_reads_and_writes(library, folder):
    """In binary, and in 4.1 what is written in 2.2 and the other way round."""
    points, faces, more = sample()
    for extension in ("msh", "msh4"):
        ours = f"{folder}/for_gmsh.{extension}"
        full(library)("write", ours.encode())
        for version in ("msh22", "msh41"):
            for more_arguments in ([], ["-bin"]):
                path = f"{folder}/{extension}_{version}{''.join(more_arguments)}.msh"
                subprocess.run([sys.argv[3], ours, "-save", "-format", version, "-o", path, "-v", "2", *more_arguments],
                               check=True)
                mesh = Mesh(library).read(path)
                assert np.allclose(mesh.array("get_points", np.float64), points.ravel(), rtol=1e-15, atol=0), path
                assert sorted(mesh.markers(FACE)) == sorted(more["region"]), path
                assert mesh.edges() == more["edges"], path
                library.calls.amst_mesh_destroy(mesh.handle)


def main():
    path, folder = sys.argv[1:3]
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    library = Library(path)
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test(library, folder)
            print(name, "passed")


main()
