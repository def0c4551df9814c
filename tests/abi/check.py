#!/usr/bin/env python3
"""Holds the C interface to its promises.

matrix      the header compiles alone, without a warning, in every C and C++
symbols     declared in the header = exported by the library = listed in symbols.txt
constants   every value in constants.txt is still the header's, and none is missing there
bindgen     bindgen reads the header and finds every function
update      adds what is new in the header to symbols.txt and constants.txt; refuses to
            change or drop a line, since that breaks programs already compiled
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
INCLUDE = HERE.parent.parent / "include"
HEADER = INCLUDE / "alphamst" / "alphamst.h"
SYMBOLS = HERE / "symbols.txt"
CONSTANTS = HERE / "constants.txt"

WARNINGS = ["-pedantic", "-Wall", "-Wextra", "-Werror"]
C_STANDARDS = ["c90", "c99", "c11", "c17", "c2x"]
CXX_STANDARDS = ["c++98", "c++03", "c++11", "c++14", "c++17", "c++20"]
COMPILERS = [("gcc", "c", C_STANDARDS), ("clang", "c", C_STANDARDS),
             ("g++", "c++", CXX_STANDARDS), ("clang++", "c++", CXX_STANDARDS)]


def run(command, **options):
    return subprocess.run(command, text=True, capture_output=True, check=False, **options)


def must_run(command):
    done = run(command)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def code():
    """The header without its comments."""
    return re.sub(r"/\*.*?\*/", "", HEADER.read_text(encoding="utf-8"), flags=re.S)


def declared():
    return set(re.findall(r"\bAMST_API\b[^;(]*?\b(amst_\w+)\s*\(", code()))


def exported(library):
    """Every name but that of the version node itself, the library's own or not."""
    lines = must_run(["nm", "-D", "--defined-only", "--format=posix", library]).splitlines()
    fields = [line.split() for line in lines]
    return {name.split("@")[0] for name, kind, *_ in fields if kind != "A"}


def constants():
    """Names and values of all enumerators, the values as a compiler sees them."""
    bodies = re.findall(r"\benum\s+amst_\w+\s*\{(.*?)\}", code(), flags=re.S)
    names = [name for body in bodies for name in re.findall(r"\b(AMST_\w+)\s*(?==|,|$)", body)]
    lines = "".join(f'    printf("{name} %ld\\n", (long){name});\n' for name in names)
    with tempfile.TemporaryDirectory() as directory:
        source = os.path.join(directory, "constants.c")
        program = os.path.join(directory, "constants")
        with open(source, "w", encoding="utf-8") as file:
            file.write("#include <alphamst/alphamst.h>\n#include <stdio.h>\n"
                       f"int main(void) {{\n{lines}    return 0;\n}}\n")
        must_run(["cc", f"-I{INCLUDE}", source, "-o", program])
        return must_run([program]).splitlines()


def listed(path):
    return path.read_text(encoding="utf-8").splitlines() if path.exists() else []


def differences(what, expected, found):
    return ([f"{what}: missing {entry}" for entry in sorted(set(expected) - set(found))]
            + [f"{what}: unexpected {entry}" for entry in sorted(set(found) - set(expected))])


def matrix(_):
    wrong = []
    for compiler, language, standards in COMPILERS:
        for standard in standards:
            command = [compiler, f"-std={standard}", *WARNINGS, "-fsyntax-only", f"-I{INCLUDE}",
                       "-x", language, "-"]
            if language == "c":
                command.insert(1, "-Wstrict-prototypes")
            done = run(command, input="#include <alphamst/alphamst.h>\n#include <alphamst/alphamst.h>\n"
                                      "int unused(void);\n")
            print(f"{compiler} -std={standard}: {'ok' if done.returncode == 0 else 'FAILED'}")
            if done.returncode != 0:
                wrong.append(done.stderr)
    return wrong


def symbols(library):
    return (differences("exported", declared(), exported(library))
            + differences("symbols.txt", declared(), listed(SYMBOLS)))


def constants_kept(_):
    return differences("constants.txt", constants(), listed(CONSTANTS))


def bindgen(_):
    bindings = must_run(["bindgen", str(HEADER), "--", "-std=c99"])
    found = set(re.findall(r"pub fn (amst_\w+)\s*\(", bindings))
    return differences("bindgen", declared(), found)


def update(_):
    wrong = []
    for path, now in ((SYMBOLS, sorted(declared())), (CONSTANTS, constants())):
        lost = [line for line in listed(path) if line not in now]
        if lost:
            wrong += [f"{path.name}: the header no longer has '{line}'" for line in lost]
        else:
            path.write_text("\n".join(now) + "\n", encoding="utf-8")
            print(f"{path.name}: {len(now)} lines")
    if wrong:
        wrong.append("Delete a file first if breaking the ABI is meant; then SOVERSION must rise.")
    return wrong


CHECKS = {"matrix": matrix, "symbols": symbols, "constants": constants_kept, "bindgen": bindgen,
          "update": update}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("check", choices=CHECKS)
    parser.add_argument("--library", help="libalphamst.so, for symbols")
    arguments = parser.parse_args()
    if arguments.check == "symbols" and not arguments.library:
        parser.error("symbols needs --library")
    wrong = CHECKS[arguments.check](arguments.library)
    print("\n".join(wrong) if wrong else f"{arguments.check}: ok")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
