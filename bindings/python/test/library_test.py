import doctest
import importlib
import inspect
import pkgutil
import unittest

import alphamst
from alphamst import _alphamst, library


class Library(unittest.TestCase):
    def test_version_and_features(self):
        self.assertEqual(alphamst.library_version(), alphamst.__version__)
        self.assertTrue(library.is_compatible(100) and library.is_compatible(199))
        self.assertFalse(library.is_compatible(200) or library.is_compatible(10100))
        self.assertTrue(alphamst.library_has("threads"))
        self.assertFalse(alphamst.library_has("teleport"))
        self.assertEqual(alphamst.status_name(-10), "AMST_ERR_NOT_FOUND")

    def test_wrong_arguments_are_exceptions(self):
        """Every function of the extension with too few arguments and with strange ones."""
        functions = [getattr(_alphamst, name) for name in dir(_alphamst) if name.startswith("amst_")]
        self.assertGreater(len(functions), 85)
        for function in functions:
            if function.__name__ in ("amst_version", "amst_version_string", "amst_options_create"):
                continue  # which take nothing, or what is given here
            self.assertRaises(TypeError, function)
            self.assertRaises(TypeError, lambda: function(*[object()] * 20))
            for n in range(1, 12):
                self.assertRaises((TypeError, ValueError), lambda: function(*[object()] * n))
                self.assertRaises((TypeError, ValueError), lambda: function(*[_alphamst.Handle()] * n))

    def test_everything_public_is_documented(self):
        for name in alphamst.__all__:
            thing = getattr(alphamst, name)
            self.assertTrue(inspect.getdoc(thing), name)
            ours = (
                [kind for kind in inspect.getmro(thing) if kind.__module__.startswith("alphamst")]
                if (inspect.isclass(thing))
                else []
            )
            for member in {member for kind in ours for member in vars(kind) if not member.startswith("_")}:
                self.assertTrue(inspect.getdoc(getattr(thing, member)), f"{name}.{member}")


def load_tests(loader, tests, pattern):
    """The examples in the documentation are tests, too."""
    for module in pkgutil.iter_modules(alphamst.__path__):
        if not module.name.startswith("_"):
            tests.addTests(doctest.DocTestSuite(importlib.import_module(f"alphamst.{module.name}")))
    return tests
