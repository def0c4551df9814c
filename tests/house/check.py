#!/usr/bin/env python3
"""Holds the rules of the house; each line that it prints is one place that breaks the rule.

includes    a folder of src includes only itself and what is below it in LAYERS; the C header
            is the business of capi alone
names       no name at namespace level is declared in the headers of two folders of src
lengths     no file is longer than 400 lines, and no function of src longer than 60
tests       every source of src has a test of its name in the folder of its name
format      clang-format would change nothing
tidy        clang-tidy finds nothing of what .clang-tidy names. Reading Eigen, OpenMesh, Boost
            and TBB takes most of its time, so without --full only the sources are read that
            include none of them, directly or not.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import source

ROOT = pathlib.Path(__file__).resolve().parents[2]

# The folders of src from top to bottom; "." are the headers of src itself.
LAYERS = [
    ["capi"],
    ["adapt"],
    ["refill", "chords"],
    ["smooth", "transfer"],
    ["reference"],
    ["patch", "chord", "fill", "geometry"],
    ["quadrangulate", "draw", "io"],
    ["mesh", "surface"],
    ["quality", "parallel"],
    ["."],
]
# Who includes whom in one row. Whatever is no longer needed has to go.
SIDEWAYS = [("chords", "refill"), ("draw", "io"), ("mesh", "surface")]

MOST_LINES = 400
MOST_LINES_OF_FUNCTION = 60
MEASURED = ["src"]  # the folders whose files are measured; functions are measured in src only
MEASURED_SUFFIXES = {".c", ".cpp", ".h", ".hpp", ".f90", ".rs", ".jl", ".py"}

FORMATTED = ["src", "include", "tests", "examples", "bindings"]
C_SUFFIXES = {".c", ".cpp", ".h", ".hpp"}
BUILT = {"target", "build"}  # folders that are no source
HEAVY = {"Eigen", "OpenMesh", "boost", "oneapi", "tbb"}


def files(root, folders, suffixes):
    return [path for folder in folders for path in sorted((root / folder).rglob("*"))
            if path.suffix in suffixes and not BUILT.intersection(path.relative_to(root).parts)]


def read(path):
    return path.read_text(encoding="utf-8")


def folder_of(root, path):
    """The folder of src that a file is in, "." for src itself."""
    parts = path.relative_to(root / "src").parts
    return parts[0] if len(parts) > 1 else "."


def place(root, path, line):
    return f"{path.relative_to(root)}:{line}"


# ---------------------------------------------------------------- includes


def rows():
    return {folder: row for row, folders in enumerate(LAYERS) for folder in folders}


def wrong_include(here, sign, name):
    """What is wrong with an include in folder `here`, or None."""
    if name.startswith("alphamst/"):
        return None if here == "capi" else f"only capi may include {name}"
    if sign == "<":
        return None
    row, there = rows(), name.split("/")[0] if "/" in name else "."
    if there not in row:
        return f"includes {name} of the unknown folder {there}, add it to LAYERS in tests/house/check.py"
    if here == there or here not in row or row[there] > row[here] or (here, there) in SIDEWAYS:
        return None
    return f"{here} is not above {there} and must not include {name}, move what is needed or the user of it"


def unknown_folders(root):
    folders = sorted(path.name for path in (root / "src").iterdir() if path.is_dir())
    return [f"src/{folder}:1: is unknown, add it to LAYERS in tests/house/check.py"
            for folder in folders if folder not in rows()]


def unused_sideways(root, used):
    present = {folder for folder in rows() if (root / "src" / folder).is_dir()}
    return [f"src/{here}:1: no longer includes {there}, delete that from SIDEWAYS in tests/house/check.py"
            for here, there in SIDEWAYS if present.issuperset((here, there)) and (here, there) not in used]


def includes(root, _):
    wrong, used = unknown_folders(root), set()
    for path in files(root, ["src"], C_SUFFIXES):
        here = folder_of(root, path)
        for line, sign, name in source.includes(read(path)):
            used.add((here, name.split("/")[0]))
            if what := wrong_include(here, sign, name):
                wrong.append(f"{place(root, path, line)}: {what}")
    return wrong + unused_sideways(root, used)


# ------------------------------------------------------------------- names


def names(root, _):
    first, wrong = collections.defaultdict(dict), []  # where each name is first declared, by folder
    for path in files(root, ["src"], {".h", ".hpp"}):
        here = folder_of(root, path)
        for declaration in source.declarations(read(path)):
            if declaration.level == "namespace" and (name := source.declared_name(declaration)):
                first[name].setdefault(here, place(root, path, declaration.first))
    for name, folders in first.items():
        one, *others = folders.values()
        wrong += [f"{other}: {name} is also declared at {one}, rename one of them" for other in others]
    return wrong


# ----------------------------------------------------------------- lengths


def long_functions(root, path):
    wrong = []
    for kind, _, head, first, last in source.declarations(read(path)):
        length = last - first + 1
        if kind == "function" and length > MOST_LINES_OF_FUNCTION:
            wrong.append(f"{place(root, path, first)}: {source.function_name(head)} has {length} lines, "
                         f"split it into functions of at most {MOST_LINES_OF_FUNCTION}")
    return wrong


def lengths(root, _):
    wrong = []
    for path in files(root, MEASURED, MEASURED_SUFFIXES):
        count = len(read(path).splitlines())
        if count > MOST_LINES:
            wrong.append(f"{place(root, path, count)}: the file has {count} lines, "
                         f"split it into files of at most {MOST_LINES}")
    for path in files(root, ["src"], C_SUFFIXES):
        wrong += long_functions(root, path)
    return wrong


# ------------------------------------------------------------------- tests


def tests(root, _):
    wrong = []
    for path in files(root, ["src"], {".cpp"}):
        here = folder_of(root, path)
        test = f"tests/{path.relative_to(root / 'src').with_suffix('')}_test"
        choice = [test + ".c", test + ".cpp"] if here == "capi" else [test + ".cpp"]
        if not any((root / name).exists() for name in choice):
            wrong.append(f"{place(root, path, 1)}: has no test, write {' or '.join(choice)}")
    return wrong


# ------------------------------------------------------------------ format


def format_kept(root, _):
    paths = files(root, FORMATTED, C_SUFFIXES)
    done = subprocess.run(["clang-format", "--dry-run", "-Werror", *map(str, paths)], cwd=root,
                          capture_output=True, text=True, check=False)
    found = collections.defaultdict(list)
    for path, line in re.findall(r"^(.+?):(\d+):\d+: error:", done.stderr, re.M):
        found[path].append(line)
    wrong = [f"{place(root, pathlib.Path(path), lines[0])}: is not formatted, run clang-format -i on the file"
             for path, lines in found.items()]
    return wrong or ([f".clang-format:1: clang-format failed: {done.stderr}"] if done.returncode else [])


# -------------------------------------------------------------------- tidy


def is_heavy(root, path, known):
    """Whether a file includes one of the heavy libraries, directly or through our own headers."""
    if path not in known:
        known[path] = False
        for _, sign, name in source.includes(read(path)):
            ours = root / "src" / name
            if name.split("/")[0] in HEAVY or sign == '"' and ours.exists() and is_heavy(root, ours, known):
                known[path] = True
    return known[path]


def clang_arguments(command):
    """A command of the build without the launcher, and without gcc's precompiled header,
    which clang cannot read."""
    arguments, kept = shlex.split(command), []
    if pathlib.Path(arguments[0]).name in ("ccache", "sccache"):
        arguments.pop(0)
    for argument in arguments:
        if argument.endswith("cmake_pch.hxx") and kept[-1] == "-include":
            kept.pop()
        elif argument not in ("-Winvalid-pch", "-Wno-subobject-linkage"):  # which clang does not know
            kept.append(argument)
    return kept


def commands(root, build):
    """One command for each source of src. Those that the build compiles in a group with others have no
    command of their own and take that of another one: all are compiled alike."""
    listed = json.loads(read(pathlib.Path(build, "compile_commands.json")))
    own = {pathlib.Path(entry["file"]): entry for entry in listed
           if pathlib.Path(entry["file"]).is_relative_to(root / "src")}
    if not own:
        return []
    model_file, model = next(iter(sorted(own.items())))
    entries = []
    for path in sorted({*own, *(root / "src").glob("*/*.cpp")}):
        entry = own.get(path, model)
        arguments = [str(path) if argument == str(model_file) and entry is model else argument
                     for argument in clang_arguments(entry["command"])]
        entries.append({"directory": entry["directory"], "file": str(path), "arguments": arguments})
    return entries


def tidy_one(root, directory, path):
    command = ["clang-tidy", "-p", directory, "--quiet", f"--config-file={root / '.clang-tidy'}", path]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    found = re.findall(r"^(/.+?):(\d+):\d+: (?:error|warning): (.+)$", done.stdout, re.M)
    wrong = [f"{place(root, pathlib.Path(file), line)}: {what.replace(',-warnings-as-errors', '')}, "
             "do as clang-tidy says" for file, line, what in found if pathlib.Path(file).is_relative_to(root)]
    if done.returncode != 0 and not wrong:
        wrong = [f"{place(root, pathlib.Path(path), 1)}: clang-tidy failed: {done.stdout}{done.stderr}"]
    return wrong


def tidy(root, arguments):
    if not arguments.build:
        sys.exit("tidy needs --build, a build directory with compile_commands.json")
    entries, known = commands(root, arguments.build), {}
    paths = sorted(entry["file"] for entry in entries
                   if arguments.full or not is_heavy(root, pathlib.Path(entry["file"]), known))
    if not paths:
        return [f"src:1: {arguments.build} compiles nothing of it, build with the tree's own CMakeLists.txt"]
    with tempfile.TemporaryDirectory() as directory:
        pathlib.Path(directory, "compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(lambda path: tidy_one(root, directory, path), paths))
    # What is in a header is found once for every source that includes it.
    return list(dict.fromkeys(line for result in results for line in result))


RULES = {"includes": includes, "names": names, "lengths": lengths, "tests": tests, "format": format_kept,
         "tidy": tidy}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("rule", choices=RULES)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="the tree to check")
    parser.add_argument("--build", help="a build directory of the tree, for tidy")
    parser.add_argument("--full", action="store_true", help="tidy reads every source")
    arguments = parser.parse_args()
    wrong = RULES[arguments.rule](arguments.root.resolve(), arguments)
    print("\n".join([*wrong, f"{len(wrong)} violations"]))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
