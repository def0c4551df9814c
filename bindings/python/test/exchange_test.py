import importlib.util
import unittest

import meshio
import numpy as np
from grid import faces, grid, grid_with_square, points

from alphamst import Mesh


class Meshio(unittest.TestCase):
    def test_there_and_back(self):
        mesh, _ = grid_with_square()
        mesh.set_markers("face", [3, 4], 5)
        mesh.set_markers("edge", mesh.find_edges([[0, 1], [1, 2]]), 7)
        mesh.set_markers("vertex", [120], 9)
        mesh.set_marker_name("edge", 7, "inlet")
        mesh.set_marker_name("face", 5, "sand")
        mesh.set_field("vertex", "depth", mesh.points()[:, 0] / 3, carry="linear")
        mesh.set_field("face", "speed", np.ones((100, 2)), carry="conserve")
        given = mesh.to_meshio(vertex_fields=["depth"], face_fields=["speed"])
        self.assertEqual(given.point_data["depth"].tolist(), mesh.field("vertex", "depth").tolist())
        self.assertEqual(given.cell_data["speed"][0].shape, (100, 2))
        back = Mesh.from_meshio(given)
        self.assertEqual(back.checksum(), mesh.checksum())
        self.assertEqual((back.marker_name("edge", 7), back.marker_name("face", 5)), ("inlet", "sand"))

    def test_triangles_and_regions(self):
        xy = points(4, 1) / 3
        triangles = np.vstack([faces(4, 1)[:, :3], faces(4, 1)[:, [0, 2, 3]]])
        regions = np.array([1, 1, 2, 2] * 2)
        given = meshio.Mesh(xy, [("triangle", triangles)], cell_data={"gmsh:physical": [regions]})
        mesh = Mesh.from_meshio(given)
        self.assertTrue((mesh.points() == xy).all())  # bit for bit
        self.assertEqual(sorted(mesh.markers("face")), [1, 1, 2, 2])
        split = Mesh.from_meshio(meshio.Mesh(xy, [("triangle", triangles)]), quadrangulate=1)
        self.assertEqual(split.n_faces, 24)

    def test_what_a_mesh_cannot_have_is_left_out(self):
        cells = [("quad", faces(2, 1)), ("line3", [[0, 1, 2]])]
        self.assertEqual(Mesh.from_meshio(meshio.Mesh(points(2, 1), cells)).n_faces, 2)


@unittest.skipUnless(importlib.util.find_spec("pyvista"), "pyvista is not there")
class Pyvista(unittest.TestCase):
    def test_faces(self):
        view = grid(3, 2).to_pyvista()
        self.assertEqual((view.n_points, view.n_cells), (12, 6))
        self.assertEqual(view.bounds[:4], (0, 3, 0, 2))
