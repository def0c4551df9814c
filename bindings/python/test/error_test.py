import pickle
import unittest

from grid import grid

import alphamst
from alphamst import Mesh, Options, Patches, error


class Errors(unittest.TestCase):
    def failure(self, call):
        with self.assertRaises(alphamst.AlphaMSTError) as caught:
            call()
        return caught.exception

    def test_code_sentence_and_place(self):
        mesh = grid(3)
        failure = self.failure(lambda: mesh.find_edges([[0, 1], [1, 98]]))
        self.assertIsInstance(failure, (alphamst.RangeError, ValueError))
        self.assertEqual((failure.code, failure.entity, failure.id, failure.patch), (-3, "vertex", 98, None))
        self.assertEqual(str(failure), f"AMST_ERR_RANGE: {failure.text} (vertex 98)")
        self.assertIn("98", failure.text)

        patches = Patches(mesh, repair_patches=0)
        patches.add_faces([3, 4])
        failure = self.failure(lambda: patches.add_faces([5, 4, 6]))
        self.assertEqual(
            (type(failure), failure.entity, failure.id, failure.patch), (alphamst.PatchError, "face", 4, 0)
        )
        self.assertTrue(str(failure).endswith("(face 4, patch 0)"))

        failure = self.failure(lambda: Mesh.read("nowhere.msh"))
        self.assertIsInstance(failure, (alphamst.FileError, OSError))
        self.assertEqual((failure.code, failure.entity, failure.id, failure.patch), (-11, None, None, None))
        self.assertIn("nowhere.msh", str(failure))
        self.assertIsInstance(self.failure(lambda: Options().get(42)), LookupError)

    def test_a_class_for_each_status(self):
        named = {code: alphamst.status_name(code) for code in range(-99, 0)}
        known = {code for code, name in named.items() if "UNKNOWN" not in name.upper()}
        self.assertEqual(known, set(error.CLASSES))
        for code, kind in error.CLASSES.items():
            failure = error.make_failure(code, "words", -1, -1, 3)
            self.assertIs(type(failure), kind)
            self.assertEqual(str(failure), f"{named[code]}: words (patch 3)")
            again = pickle.loads(pickle.dumps(failure))
            self.assertEqual((type(again), str(again)), (kind, str(failure)))
        self.assertIs(type(error.make_failure(-50, "new", -1, -1, -1)), alphamst.AlphaMSTError)

    def test_names_and_numbers(self):
        mesh = grid(2)
        self.assertRaises(ValueError, lambda: mesh.flags("corner"))
        self.assertEqual(mesh.flags(2).tolist(), mesh.flags("face").tolist())
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.flags(3))
        self.assertRaises(alphamst.ArgumentError, lambda: mesh.quality(20))
        self.assertIsNone(error.name_of(error.ENTITIES, 9))
