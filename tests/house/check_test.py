#!/usr/bin/env python3
"""Shows that check.py sees the mistakes it is for, and takes what is right: each mistake is
made in a small tree that breaks no rule, and has to be named.
"""

import collections
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import check

HERE = pathlib.Path(__file__).resolve().parent

# In the tree, file gets text at its end, or is written if it does not exist; then the rule says so.
Mistake = collections.namedtuple("Mistake", "what rule file text says")


def function(lines, head="int long_one(int x) {"):
    """A function of so many lines, with braces that are none."""
    body = ["    x += 1'000; // }", "    /* { */ x += \"}}{\"[0] + '}';"]
    body += ["    x += 1;"] * (lines - len(body) - 3)
    return "\n".join([head, *body, "    return x;", "}"]) + "\n"


# What looks wrong to a hasty reader and is not.
TREE = {
    "src/failure.h": "#pragma once\nclass Failure {};\n",
    "src/capi/mesh.cpp":
        '#include <alphamst/alphamst.h>\n\n#include "mesh/mesh.h"\n#include "patch/patch.h"\n',
    "src/adapt/whole.h": "#pragma once\nclass Mesh;\nstruct Patch;\nenum class Kind : int;\n"
                         "template <class T> class Grid;\nstruct Whole {\n    int size() const;\n};\n",
    "src/patch/patch.h": '#pragma once\n#include "failure.h"\n#include "mesh/mesh.h"\nstruct Patch {\n'
                         "    int size() const;\n    using Side = int;\n};\n",
    "src/patch/patch.cpp": '#include "patch/patch.h"\n\n#include <cmath>\n\n// #include "adapt/whole.h"\n'
                           "int Patch::size() const { return 1; }\n",
    "src/mesh/mesh.h": '#pragma once\n#include "surface/surface.h"\nclass Mesh {\npublic:\n'
                       "    Mesh() : size_{0}, side_(1) {}\n"
                       "    int side() const { return side_ + size_; }\n\n"
                       "private:\n    int size_, side_;\n};\nenum class Kind : int { one, two };\n"
                       "template <class T> class Grid { T corner{}; };\nint rows(int);\nint rows(double);\n",
    "src/mesh/mesh.cpp": '#include "mesh/mesh.h"\n\n' + function(check.MOST_LINES_OF_FUNCTION),
    "src/mesh/long.h": "#pragma once\n" + "// A line.\n" * (check.MOST_LINES - 1),
    "src/surface/surface.h": "#pragma once\nusing Side = int;\nint size(int x = int{2});\n"
                             "int size(double x);\nconstexpr int most[] = {1, 2};\n",
    "src/io/file.h": "#pragma once\n",
    "src/geometry/heavy.h": "#pragma once\n#include <Eigen/Core>\n",
    "src/geometry/heavy.cpp": '#include "geometry/heavy.h"\n',
    "include/alphamst/alphamst.h": "int amst_version(void);\n",
    "libraries/Eigen/Core": "",
    "tests/capi/mesh_test.c": "",
    "tests/geometry/heavy_test.cpp": "",
    "tests/mesh/mesh_test.cpp": "",
    "tests/patch/patch_test.cpp": "",
}

MISTAKES = [
    Mistake("upwards", "includes", "src/patch/patch.cpp", '#include "adapt/whole.h"\n',
            "src/patch/patch.cpp:7: patch is not above adapt and must not include adapt/whole.h"),
    Mistake("sideways, the wrong way", "includes", "src/surface/surface.h", '#  include "mesh/mesh.h"\n',
            "src/surface/surface.h:6: surface is not above mesh and must not include mesh/mesh.h"),
    Mistake("sideways, not listed", "includes", "src/patch/patch.cpp", '#include "geometry/heavy.h"\n',
            "src/patch/patch.cpp:7: patch is not above geometry and must not include geometry/heavy.h"),
    Mistake("from the headers of all", "includes", "src/failure.h", '#include "mesh/mesh.h"\n',
            "src/failure.h:3: . is not above mesh and must not include mesh/mesh.h"),
    Mistake("C header inside", "includes", "src/mesh/mesh.cpp", "#include <alphamst/alphamst.h>\n",
            "src/mesh/mesh.cpp:63: only capi may include alphamst/alphamst.h"),
    Mistake("unknown folder", "includes", "src/misc/tools.h", "", "src/misc:1: is unknown"),
    Mistake("unknown folder included", "includes", "src/mesh/mesh.cpp", '#include "misc/tools.h"\n',
            "src/mesh/mesh.cpp:63: includes misc/tools.h of the unknown folder misc"),
    Mistake("listed for nothing", "includes", "src/draw/svg.h", "", "src/draw:1: no longer includes io"),

    Mistake("struct", "names", "src/patch/patch.h", "struct Mesh {};\n",
            "src/patch/patch.h:8: Mesh is also declared at src/mesh/mesh.h:3"),
    Mistake("enum", "names", "src/patch/patch.h", "enum Kind { three };\n",
            "src/patch/patch.h:8: Kind is also declared"),
    Mistake("template", "names", "src/patch/patch.h", "template <class T, int n>\nstruct Grid {};\n",
            "src/patch/patch.h:9: Grid is also declared"),
    Mistake("alias", "names", "src/patch/patch.h", "using Side = double;\n",
            "src/surface/surface.h:2: Side is also declared at src/patch/patch.h:8"),
    Mistake("function declared", "names", "src/patch/patch.h",
            "namespace patch {\n[[nodiscard]] std::vector<int> size(std::function<void(int)> f = {});\n}\n",
            "src/surface/surface.h:3: size is also declared at src/patch/patch.h:9"),
    Mistake("function defined", "names", "src/patch/patch.h", "inline int size() { return 1; }\n",
            "size is also declared at src/patch/patch.h:8"),
    Mistake("constant", "names", "src/patch/patch.h", "inline constexpr double most = 1;\n",
            "most is also declared at src/patch/patch.h:8"),
    Mistake("name of src itself", "names", "src/patch/patch.h", "struct Failure {};\n",
            "src/patch/patch.h:8: Failure is also declared at src/failure.h:2"),

    Mistake("file", "lengths", "src/mesh/long.h", "// One more.\n",
            "src/mesh/long.h:401: the file has 401 lines"),
    Mistake("function", "lengths", "src/patch/patch.cpp", function(61),
            "src/patch/patch.cpp:7: long_one has 61 lines"),
    Mistake("member", "lengths", "src/patch/patch.cpp", function(61, "int Patch::long_one(int x) const {"),
            "src/patch/patch.cpp:7: Patch::long_one has 61 lines"),
    Mistake("member in its class", "lengths", "src/patch/patch.cpp",
            "namespace a::b {\nclass C {\npublic:\n" + function(61, "int inner(int x) {") + "};\n}\n",
            "src/patch/patch.cpp:10: inner has 61 lines"),
    Mistake("constructor", "lengths", "src/patch/patch.cpp",
            function(61, "C::C(int x) : a{x}, b(x), c{} {").replace("return x;", "x += 1;"),
            "src/patch/patch.cpp:7: C::C has 61 lines"),
    Mistake("template", "lengths", "src/patch/patch.cpp",
            "template <class T>\n"
            + function(61, "std::map<T, T> long_one(std::vector<T> x = {}) noexcept {"),
            "src/patch/patch.cpp:8: long_one has 61 lines"),
    Mistake("lambdas inside", "lengths", "src/patch/patch.cpp",
            "int outer() {\n" + function(40, "auto one = [](int x) {") * 2 + "}\n",
            "src/patch/patch.cpp:7: outer has 82 lines"),
    Mistake("named lambda", "lengths", "src/patch/patch.cpp", function(61, "const auto named = [](int x) {"),
            "src/patch/patch.cpp:7: named has 61 lines"),
    Mistake("named lambda without arguments", "lengths", "src/patch/patch.cpp",
            function(61, "const auto named = [] {"), "src/patch/patch.cpp:7: named has 61 lines"),

    Mistake("source without test", "tests", "src/mesh/row.cpp", "",
            "src/mesh/row.cpp:1: has no test, write tests/mesh/row_test.cpp"),
    Mistake("source of capi without test", "tests", "src/capi/file.cpp", "",
            "src/capi/file.cpp:1: has no test, write tests/capi/file_test.c or tests/capi/file_test.cpp"),

    Mistake("source", "format", "src/patch/patch.cpp", "int  x;\n",
            "src/patch/patch.cpp:7: is not formatted"),
    Mistake("example", "format", "examples/c/one.c", "int x = 1 ;\n", "examples/c/one.c:1: is not formatted"),

    Mistake("source", "tidy", "src/patch/patch.cpp", "int *nothing = 0;\n",
            "src/patch/patch.cpp:7: use nullptr"),
    Mistake("header", "tidy", "src/patch/patch.h", "inline int *nothing = 0;\n",
            "src/patch/patch.h:8: use nullptr"),
    Mistake("does not compile", "tidy", "src/patch/patch.cpp", "int x = y;\n",
            "src/patch/patch.cpp:7: use of"),
    Mistake("source that reads Eigen", "tidy --full", "src/geometry/heavy.cpp", "int *nothing = 0;\n",
            "src/geometry/heavy.cpp:2: use nullptr"),
]

# New files and additions that break no rule.
GOOD = [
    Mistake("test in C++ for capi", "tests", "tests/capi/mesh_test.cpp", "", ""),
    Mistake("header without test", "tests", "src/mesh/row.h", "inline int row() { return 1; }\n", ""),
    Mistake("operator of two folders", "names", "src/patch/patch.h",
            "inline bool operator<(Patch, Patch) { return false; }\n", ""),
    Mistake("name of a member", "names", "src/patch/patch.h",
            "struct Other {\n    struct Mesh {};\n};\n", ""),
    Mistake("member defined outside", "names", "src/patch/patch.h",
            "inline int Other::size() { return 1; }\n", ""),
    Mistake("built files", "format", "bindings/rust/target/made.c", "int  x;\n", ""),
    Mistake("source that reads Eigen", "tidy", "src/geometry/heavy.cpp", "int *nothing = 0;\n", ""),
]


class Tree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.root = pathlib.Path(directory.name).resolve()
        for name, text in TREE.items():
            cls.write(cls.root / name, text)
        shutil.copy(check.ROOT / ".clang-tidy", cls.root)
        shutil.copy(check.ROOT / ".clang-format", cls.root)
        commands = [cls.command(path) for path in cls.root.glob("src/*/*.cpp")]
        cls.write(cls.root / "compile_commands.json", json.dumps(commands))

    @staticmethod
    def write(path, text):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    @classmethod
    def command(cls, path):
        """As CMake writes it where gcc has a precompiled header and ccache starts it."""
        flags = (f"-I{cls.root}/include -I{cls.root}/src -isystem libraries "
                 "-std=c++20 -Winvalid-pch -include made/cmake_pch.hxx")
        return {"directory": str(cls.root), "file": str(path), "command": f"ccache c++ {flags} -c {path}"}

    def run_check(self, rule):
        command = [sys.executable, "-B", HERE / "check.py", *rule.split(), "--root", self.root,
                   "--build", self.root]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def run_edited(self, mistake):
        """The rule's answer with the mistake in the tree, which gets its old text back."""
        path = self.root / mistake.file
        before = path.read_text(encoding="utf-8") if path.exists() else None
        self.write(path, (before or "") + mistake.text)
        try:
            return self.run_check(mistake.rule)
        finally:
            if before is None:
                path.unlink()
                self.remove_empty(path.parent)
            else:
                path.write_text(before, encoding="utf-8")

    def remove_empty(self, folder):
        while not any(folder.iterdir()):
            folder.rmdir()
            folder = folder.parent

    def test_untouched(self):
        for rule in check.RULES:
            with self.subTest(rule):
                self.assertEqual(self.run_check(rule), (0, "0 violations\n"))

    def test_mistakes(self):
        for mistake in MISTAKES:
            with self.subTest(f"{mistake.rule}: {mistake.what}"):
                code, output = self.run_edited(mistake)
                self.assertEqual(code, 1, output)
                self.assertTrue([line for line in output.splitlines() if mistake.says in line], output)
                self.assertEqual(output.splitlines()[-1], "1 violations", output)

    def test_good(self):
        for good in GOOD:
            with self.subTest(f"{good.rule}: {good.what}"):
                self.assertEqual(self.run_edited(good), (0, "0 violations\n"))

    def test_tidy_without_sources(self):
        path = self.root / "compile_commands.json"
        before = path.read_text(encoding="utf-8")
        path.write_text("[]", encoding="utf-8")
        self.addCleanup(path.write_text, before, encoding="utf-8")
        self.assertEqual(self.run_check("tidy")[0], 1)


if __name__ == "__main__":
    unittest.main()
