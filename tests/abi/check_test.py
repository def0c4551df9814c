#!/usr/bin/env python3
"""Shows that the checkers see the mistakes they are for: each is made in a copy of the
header or of a binding, and has to be named in a line that the untouched copy does not give.
"""

import collections
import functools
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import check
import header

COPIED = ["include", "tests/abi", "bindings"]
H = "include/alphamst/alphamst.h"
FORTRAN_TYPES, FORTRAN_CONTEXT, FORTRAN_MESH = (f"bindings/fortran/src/amst_c_{part}.f90"
                                                for part in ("types", "context", "mesh"))
JULIA = "bindings/julia/src/LibAlphaMST.jl"
PYTHON = "bindings/python/src/module.cpp"
RUST = "bindings/rust/alphamst-sys/src/bindings.rs"

# In the file, after the first place of `after`, the next `old` becomes `new`; then the check says so.
Mistake = collections.namedtuple("Mistake", "what check file after old new says")

HEADER_MISTAKES = [
    Mistake("function removed", "symbols", H, "",
            "AMST_TRY amst_status amst_mesh_check(const amst_mesh *mesh);", "",
            "exported: unexpected amst_mesh_check"),
    Mistake("function removed", "abi", H, "",
            "AMST_TRY amst_status amst_mesh_check(const amst_mesh *mesh);", "",
            "function amst_status amst_mesh_check(const amst_mesh*)"),
    Mistake("function not listed", "symbols", H, "", "AMST_API void amst_mesh_destroy",
            "AMST_API int32_t amst_new(void);\nAMST_API void amst_mesh_destroy",
            "symbols.txt: missing amst_new"),
    Mistake("function not exported", "symbols", H, "", "AMST_API void amst_mesh_destroy",
            "AMST_API int32_t amst_new(void);\nAMST_API void amst_mesh_destroy",
            "exported: missing amst_new"),
    Mistake("struct grown", "abi", H, "struct amst_summary {", "double stddev;",
            "double stddev, median;", "median"),
    Mistake("members swapped", "abi", H, "struct amst_summary {", "double min;\n    double max;",
            "double max;\n    double min;", "'double max'"),
    Mistake("argument widened", "abi", H, "amst_context_set_cancel(", "int32_t", "int64_t",
            "amst_context_set_cancel(amst_context*, int32_t)"),
    Mistake("result widened", "abi", H, "", "AMST_API int32_t amst_has(",
            "AMST_API int64_t amst_has(", "amst_has"),
    Mistake("array widened", "abi", H, "amst_mesh_get_edges(", "amst_id *out", "int64_t *out",
            "amst_mesh_get_edges"),
    Mistake("callback changed", "abi", H, "(*amst_log_fn)", "int32_t level", "int64_t level",
            "amst_context_set_log"),
    Mistake("equal types swapped", "abi", H, "amst_mesh_set_flags(", "int32_t mask, int32_t value",
            "int32_t value, int32_t mask", "amst_mesh_set_flags: arguments were"),
    Mistake("values swapped", "constants", H, "", "AMST_LOG_OFF = -1,\n    AMST_LOG_ERROR = 0",
            "AMST_LOG_ERROR = -1,\n    AMST_LOG_OFF = 0", "constants.txt: missing AMST_LOG_ERROR -1"),
    Mistake("constant removed", "constants", H, "", "AMST_LOG_DEBUG = 3,", "",
            "constants.txt: unexpected AMST_LOG_DEBUG 3"),
    Mistake("constant not listed", "constants", H, "", "AMST_LOG_DEBUG = 3,",
            "AMST_LOG_DEBUG = 3, AMST_LOG_ALL = 4,",
            "constants.txt: missing AMST_LOG_ALL 4"),
    Mistake("default changed", "defaults", H, "AMST_OPT_SMOOTH_STEPS", "/* int, 20:", "/* int, 21:",
            "AMST_OPT_SMOOTH_STEPS: 21 in the header"),
    Mistake("default not told", "defaults", H, "AMST_OPT_CANDIDATES", "/* int, 16: fillings", "/* fillings",
            "AMST_OPT_CANDIDATES: no default"),
    Mistake("function removed and recorded", "update", H, "",
            "AMST_TRY amst_status amst_mesh_check(const amst_mesh *mesh);", "",
            "symbols.txt: the header no longer has 'amst_mesh_check'"),
    Mistake("argument widened and recorded", "update", H, "amst_context_set_cancel(", "int32_t", "int64_t",
            "amst_context_set_cancel(amst_context*, int32_t)"),
    Mistake("value changed and recorded", "update", H, "", "AMST_LOG_DEBUG = 3", "AMST_LOG_DEBUG = 4",
            "constants.txt: the header no longer has 'AMST_LOG_DEBUG 3'"),
]

FORTRAN_MISTAKES = [
    Mistake("integer too narrow", "fortran", FORTRAN_MESH, "function amst_mesh_rollback(",
            "integer(c_int64_t)", "integer(4)",
            "amst_mesh_rollback: argument 2, revision, is int32, not int64"),
    Mistake("integer for real", "fortran", FORTRAN_CONTEXT, "function amst_options_set_real(",
            "real(c_double)", "integer(8)",
            "amst_options_set_real: argument 3, value, is int64, not double"),
    Mistake("array too wide", "fortran", FORTRAN_MESH, "function amst_mesh_create(",
            "integer(c_int32_t), intent(in)",
            "integer(c_int64_t), intent(in)", "amst_mesh_create: argument 7, faces, is int64*, not int32*"),
    Mistake("value missing, number", "fortran", FORTRAN_CONTEXT, "function amst_context_set_cancel(",
            "integer(c_int32_t), value", "integer(c_int32_t), intent(in)",
            "amst_context_set_cancel: argument 2, flag, is int32*, not int32"),
    Mistake("value missing, handle", "fortran", FORTRAN_MESH, "subroutine amst_mesh_destroy(",
            "type(c_ptr), value",
            "type(c_ptr), intent(in)", "amst_mesh_destroy: argument 1, mesh, is ?**, not amst_mesh*"),
    Mistake("value missing, callback", "fortran", FORTRAN_CONTEXT, "function amst_context_set_log(",
            "type(c_funptr), value", "type(c_funptr), intent(in)",
            "amst_context_set_log: argument 3, fn, is ?**, not amst_log_fn"),
    Mistake("value too much", "fortran", FORTRAN_MESH, "function amst_mesh_clone(",
            "type(c_ptr), intent(inout) ::",
            "type(c_ptr), value ::", "amst_mesh_clone: argument 2, out, is ?*, not amst_mesh**"),
    Mistake("kind of the machine", "fortran", FORTRAN_CONTEXT, "", "only: c_char", "only: c_long, c_char",
            "c_long: not of one width everywhere"),
    Mistake("array with descriptor", "fortran", FORTRAN_MESH, "function amst_mesh_find_edges(",
            "pairs(*)", "pairs(:)",
            "amst_mesh_find_edges: is no argument of C: "),
    Mistake("string with length", "fortran", FORTRAN_MESH, "function amst_mesh_read(",
            "character(kind=c_char), intent(in) :: path(*)",
            "character(kind=c_char, len=*), intent(in) :: path", "amst_mesh_read: is no argument of C: "),
    Mistake("equal types swapped", "fortran", FORTRAN_MESH, "",
            "vertex_stride, &\n                component_stride,",
            "component_stride, &\n                vertex_stride,",
            "amst_mesh_create: argument 5 is named component_stride, not vertex_stride"),
    Mistake("argument too many", "fortran", FORTRAN_CONTEXT, "function amst_context_set_threads(",
            ") bind(c)\n            import :: c_int32_t, c_ptr\n            implicit none\n",
            ", m) bind(c)\n            import :: c_int32_t, c_ptr\n            implicit none\n"
            "            integer(c_int32_t), value :: m\n",
            "amst_context_set_threads: 3 arguments, not 2"),
    Mistake("result widened", "fortran", FORTRAN_CONTEXT, "", "integer(c_int32_t) function amst_version()",
            "integer(8) function amst_version()", "amst_version: returns int64, not int32"),
    Mistake("function missing", "fortran", FORTRAN_MESH, "function amst_mesh_check(", "bind(c)", "",
            "amst_mesh_check: missing"),
    Mistake("wrong function called", "fortran", FORTRAN_MESH, "function amst_mesh_get_edges(", "bind(c)",
            'bind(c, name="amst_mesh_get_edge_faces")',
            "amst_mesh_get_edges: calls amst_mesh_get_edge_faces"),
    Mistake("no such function", "fortran", FORTRAN_MESH, "function amst_mesh_get_edges(", "bind(c)",
            'bind(c, name="amst_mesh_get_edgs")', "amst_mesh_get_edgs: no such function in the header"),
    Mistake("callback changed", "fortran", FORTRAN_TYPES, "subroutine amst_log_fn(", "integer(c_int32_t)",
            "integer(8)", "amst_log_fn: argument 2, level, is int64, not int32"),
    Mistake("wrong constant", "fortran", FORTRAN_TYPES, "", "AMST_ERR_RANGE = -3", "AMST_ERR_RANGE = -4",
            "AMST_ERR_RANGE: -4, not -3"),
    Mistake("no such constant", "fortran", FORTRAN_TYPES, "", "AMST_ERR_RANGE = -3", "AMST_ERR_RNGE = -3",
            "AMST_ERR_RANGE: missing"),
    Mistake("member too narrow", "fortran", FORTRAN_TYPES, "bind(c) :: amst_summary", "integer(c_int64_t)",
            "integer(c_int32_t)", "amst_summary: members"),
]

JULIA_MISTAKES = [
    Mistake("integer too narrow", "julia", JULIA, "@ccall amst_mesh_rollback(", "Int64", "Int32",
            "amst_mesh_rollback: argument 2, revision, is int32, not int64"),
    Mistake("integer for real", "julia", JULIA, "@ccall amst_options_set_real(", "Float64", "Cint",
            "amst_options_set_real: argument 3, value, is int32, not double"),
    Mistake("array too wide", "julia", JULIA, "@ccall amst_mesh_create(", "faces::Ptr{Int32}",
            "faces::Ptr{Int64}",
            "amst_mesh_create: argument 7, faces, is int64*, not int32*"),
    Mistake("pointer missing", "julia", JULIA, "@ccall amst_mesh_get_count(", "count::Ptr{Int64}",
            "count::Int64",
            "amst_mesh_get_count: argument 3, count, is int64, not int64*"),
    Mistake("another handle", "julia", JULIA, "@ccall amst_mesh_check(", "amst_mesh}", "amst_patches}",
            "amst_mesh_check: argument 1, mesh, is amst_patches*, not amst_mesh*"),
    Mistake("handle for output", "julia", JULIA, "@ccall amst_mesh_clone(", "Ptr{Ptr{amst_mesh}}",
            "Ptr{amst_mesh}",
            "amst_mesh_clone: argument 2, out, is amst_mesh*, not amst_mesh**"),
    Mistake("equal types swapped", "julia", JULIA, "@ccall amst_mesh_set_flags(",
            "mask::Int32, value::Int32",
            "value::Int32, mask::Int32", "amst_mesh_set_flags: argument 5 is named value, not mask"),
    Mistake("handed on in another order", "julia", JULIA, "",
            "amst_mesh_set_flags(mesh, entity, ids, n, mask, value)",
            "amst_mesh_set_flags(mesh, entity, ids, n, value, mask)", "amst_mesh_set_flags: takes mesh"),
    Mistake("argument missing", "julia", JULIA, "@ccall amst_mesh_find_edges(", "n::Int64, ", "",
            "amst_mesh_find_edges: 3 arguments, not 4"),
    Mistake("result widened", "julia", JULIA, "@ccall amst_version(", "Int32", "Int64",
            "amst_version: returns int64, not int32"),
    Mistake("function missing", "julia", JULIA, "", "amst_mesh_check(mesh) = @ccall", "# @ccall",
            "amst_mesh_check: missing"),
    Mistake("wrong function called", "julia", JULIA, "", "@ccall amst_mesh_get_edges(",
            "@ccall amst_mesh_get_edge_faces(", "amst_mesh_get_edges: calls amst_mesh_get_edge_faces"),
    Mistake("no such function", "julia", JULIA, "", "@ccall amst_mesh_get_edges(",
            "@ccall amst_mesh_get_edgs(",
            "amst_mesh_get_edgs: no such function in the header"),
    Mistake("wrong constant", "julia", JULIA, "", "AMST_ERR_RANGE = Int32(-3)",
            "AMST_ERR_RANGE = Int32(-4)",
            "AMST_ERR_RANGE: -4, not -3"),
    Mistake("no such constant", "julia", JULIA, "", "const AMST_ERR_RANGE", "const AMST_ERR_RNGE",
            "AMST_ERR_RNGE: no such constant in the header"),
    Mistake("callback changed", "julia", "bindings/julia/src/context.jl", "@cfunction(log_thunk",
            "Int32", "Int64",
            "log_thunk: like no callback of the header"),
    Mistake("default changed", "julia", "bindings/julia/src/options.jl", "", "| `min_convexity` | 0.6 |",
            "| `min_convexity` | 0.7 |", "AMST_OPT_MIN_CONVEXITY: default 0.7, not 0.6"),
    Mistake("members swapped", "julia", JULIA, "struct amst_summary", "min::Float64\n    max::Float64",
            "max::Float64\n    min::Float64", "amst_summary: members"),
]

RUST_MISTAKES = [
    Mistake("edited by hand", "rust", RUST, "pub fn amst_mesh_rollback(", "i64", "i32",
            "bindings.rs: unexpected"),
    Mistake("function missing", "rust", RUST, "", "pub fn amst_mesh_check(", "pub fn check_mesh(",
            "bindings.rs: missing 'pub fn amst_mesh_check("),
    Mistake("default changed", "rust", "bindings/rust/alphamst/src/options.rs", "", "/// Integer, 1000: effort",
            "/// Integer, 900: effort", "AMST_OPT_NODE_LIMIT: default 900.0, not 1000.0"),
    Mistake("header has moved on", "rust", H, "", "AMST_LOG_DEBUG = 3,",
            "AMST_LOG_DEBUG = 3, AMST_LOG_ALL = 4,",
            "bindings.rs: missing 'pub const AMST_LOG_ALL"),
]

PYTHON_MISTAKES = [
    Mistake("function missing", "python", PYTHON, "", "    SLOW(amst_mesh_check),\n", "", "amst_mesh_check: missing"),
    Mistake("function missing", "python", PYTHON, "", "SLOW(amst_mesh_check)", "// SLOW(amst_mesh_check)",
            "amst_mesh_check: missing"),
    Mistake("under another name", "python", PYTHON, "", 'method<find_edges, Way::quick>("amst_mesh_find_edges")',
            'method<find_edges, Way::quick>("amst_mesh_get_edges")', "amst_mesh_find_edges: missing"),
    Mistake("another function under the name", "python", PYTHON, "amst_status find_edges", "amst_mesh_find_edges(",
            "amst_mesh_get_edges(", "amst_mesh_find_edges: not called"),
    Mistake("wrong constant", "python", "bindings/python/alphamst/flag.py", "", "FEATURE = 2", "FEATURE = 8",
            "AMST_FLAG_FEATURE: 8, not 2"),
    Mistake("constant missing", "python", "bindings/python/alphamst/quality.py", "", '"taper": 18,', "",
            "AMST_METRIC_TAPER: missing"),
    Mistake("exception missing", "python", "bindings/python/alphamst/error.py", "", "-9: StaleError,", "",
            "AMST_ERR_STALE: missing"),
    Mistake("default changed", "python", "bindings/python/alphamst/options.py", "", "`node_limit` | 1000 |",
            "`node_limit` | 900 |", "AMST_OPT_NODE_LIMIT: default 900.0, not 1000.0"),
    Mistake("header has moved on", "python", H, "", "AMST_LOG_DEBUG = 3,", "AMST_LOG_DEBUG = 3, AMST_LOG_ALL = 4,",
            "AMST_LOG_ALL: missing"),
    Mistake("header has moved on", "python", H, "", "AMST_API void amst_mesh_destroy",
            "AMST_API int32_t amst_new(void);\nAMST_API void amst_mesh_destroy", "amst_new: missing"),
]

# Where the idiomatic layer is, and the raw file with the functions of meshes, which does not count.
IDIOMATIC = {"fortran": ("bindings/fortran/src", FORTRAN_MESH), "julia": ("bindings/julia/src", JULIA),
             "python": ("bindings/python/alphamst", PYTHON), "rust": ("bindings/rust/alphamst/src", RUST)}


class Copy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.root = pathlib.Path(directory.name, "copy")
        for name in COPIED:
            shutil.copytree(header.ROOT / name, cls.root / name,
                            ignore=shutil.ignore_patterns("target", "__pycache__"))
        check.dump(directory.name)
        cls.library = f"{directory.name}/stub.so"

    def run_check(self, name):
        if name in check.CHECKS:
            command = ["check.py", name, "--library", self.library]
        else:
            command = ["check_bindings.py", name]
        script = self.root / "tests/abi" / command[0]
        done = header.run([sys.executable, "-B", script, *command[1:]])
        return done.returncode, done.stdout + done.stderr

    @functools.cache
    def untouched(self, name):
        return self.run_check(name)

    def run_edited(self, name, edits):
        """The check's answer with some files given another text; they get the old one back."""
        before = {path: path.read_bytes() for path in edits}
        try:
            for path, text in edits.items():
                path.write_text(text, encoding="utf-8")
            return self.run_check(name)
        finally:
            for path, data in before.items():
                path.write_bytes(data)

    def expect(self, name, edits, says):
        code, output = self.run_edited(name, edits)
        lines = set(output.splitlines()) - set(self.untouched(name)[1].splitlines())
        self.assertEqual(code, 1, output)
        self.assertTrue([line for line in lines if says in line], output)

    def test_untouched(self):
        for name in ["symbols", "constants", "abi", "bindgen", "update", *IDIOMATIC]:
            with self.subTest(name):
                code, output = self.untouched(name)
                self.assertEqual(code, 0, output)

    def test_mistakes(self):
        for mistake in HEADER_MISTAKES + FORTRAN_MISTAKES + JULIA_MISTAKES + PYTHON_MISTAKES + RUST_MISTAKES:
            with self.subTest(f"{mistake.check}: {mistake.what}"):
                path = self.root / mistake.file
                before, after, rest = path.read_text(encoding="utf-8").partition(mistake.after or "\n")
                self.assertIn(mistake.old, rest, f"{mistake.file} has changed: adapt the mistake")
                edited = before + after + rest.replace(mistake.old, mistake.new, 1)
                self.expect(mistake.check, {path: edited}, mistake.says)

    def test_function_without_use(self):
        for language, (directory, raw) in IDIOMATIC.items():
            with self.subTest(language):
                texts = {path: path.read_text(encoding="utf-8")
                         for path in (self.root / directory).rglob("*.*") if path != self.root / raw}
                edits = {path: re.sub(r"\bamst_mesh_find_edges\b", "nothing", text)
                         for path, text in texts.items()}
                self.expect(language, edits, "amst_mesh_find_edges: not used")

    def test_additions_are_welcome(self):
        path = self.root / H
        text = path.read_text(encoding="utf-8")
        edited = text.replace("AMST_LOG_DEBUG = 3,", "AMST_LOG_DEBUG = 3, AMST_LOG_ALL = 4,").replace(
            "AMST_API int32_t amst_version(void);",
            "AMST_API int32_t amst_version(void);\nAMST_API int32_t amst_new(void);")
        baselines = {self.root / "tests/abi" / file.name: file.read_text(encoding="utf-8")
                     for file in (check.SYMBOLS, check.CONSTANTS, check.ABI)}
        code, output = self.run_edited("abi", {path: edited})
        self.assertEqual(code, 0, output)
        code, output = self.run_edited("update", {path: edited, **baselines})
        self.assertEqual(code, 0, output)
        listed = len(check.listed(check.SYMBOLS))
        self.assertIn(f"symbols.txt: {listed + 1} lines", output)

    def test_dump_is_the_same_everywhere(self):
        with tempfile.TemporaryDirectory() as directory:
            self.assertEqual(check.dump(directory), check.ABI.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
