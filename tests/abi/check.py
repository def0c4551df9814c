#!/usr/bin/env python3
"""Holds the C interface to its promises.

matrix      the header compiles alone, without a warning, in every C and C++
symbols     declared in the header = exported by the library = listed in symbols.txt
soname      the name that programs look for at run time changes with what may break them
constants   every value in constants.txt is still the header's, and none is missing there
abi         no type, argument or member in libalphamst.abi has changed or moved
defaults    the options of the library begin with what the comments of the header say
bindgen     bindgen reads the header and finds every function
update      adds what is new in the header to the three files; refuses to change or
            drop anything in them, since that breaks programs already compiled

libalphamst.abi is not taken from the library, which has no debug information and, if it
had, would tell of its inner C++ too. It is taken from a C file with an empty body for
every function of the header. That the library is made of the same types is the
compiler's work: what does not see the header is not exported, see symbols, and what
contradicts it does not compile.
"""

import argparse
import ctypes
import os
import pathlib
import re
import sys
import tempfile
import xml.etree.ElementTree

from header import HEADER, HERE, INCLUDE, defaults, interface, must_run, run

SYMBOLS = HERE / "symbols.txt"
CONSTANTS = HERE / "constants.txt"
ABI = HERE / "libalphamst.abi"

WARNINGS = ["-pedantic", "-Wall", "-Wextra", "-Werror"]
C_STANDARDS = ["c90", "c99", "c11", "c17", "c2x"]
CXX_STANDARDS = ["c++98", "c++03", "c++11", "c++14", "c++17", "c++20"]
COMPILERS = [("gcc", "c", C_STANDARDS), ("clang", "c", C_STANDARDS),
             ("g++", "c++", CXX_STANDARDS), ("clang++", "c++", CXX_STANDARDS)]


def exported(library):
    """Every name but that of the version node itself, the library's own or not."""
    lines = must_run(["nm", "-D", "--defined-only", "--format=posix", library]).splitlines()
    fields = [line.split() for line in lines]
    return {name.split("@")[0] for name, kind, *_ in fields if kind != "A"}


def constants():
    return [f"{name} {value}" for name, value in interface().constants.items()]


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
        command = [compiler, f"-std={standards[-1]}", f"-I{INCLUDE}", "-c", "-o", os.devnull, "-x", language, "-"]
        done = run(command, input="#include <alphamst/alphamst.h>\n"
                                  "int look(void) { amst_options_create(0); return 0; }\n")
        if "amst_options_create" not in done.stderr:
            wrong.append(f"{compiler} does not warn of a status that is not looked at")
    return wrong


def symbols(library):
    declared = interface().functions
    return (differences("exported", declared, exported(library))
            + differences("symbols.txt", declared, listed(SYMBOLS))
            + [f"{name} can fail and is not AMST_TRY" for name in
               re.findall(r"^AMST_API amst_status (\w+)", HEADER.read_text(encoding="utf-8"), flags=re.M)])


def soname(library):
    """Before 1.0 a minor version may break the interface, so that programs have to ask for theirs."""
    versions = dict(re.findall(r"#define AMST_VERSION_(\w+) (\d+)", HEADER.read_text(encoding="utf-8")))
    number = versions["MAJOR"] if versions["MAJOR"] != "0" else f"0.{versions['MINOR']}"
    name = f"libalphamst.so.{number}"
    dynamic = must_run(["readelf", "-d", library])
    return [] if f"[{name}]" in dynamic else [f"the SONAME is not {name}"]


def constants_kept(_):
    return differences("constants.txt", constants(), listed(CONSTANTS))


def stub():
    """A C file that defines every function of the header."""
    code = re.sub(r"/\*.*?\*/|^#.*?$", "", HEADER.read_text(encoding="utf-8"), flags=re.S | re.M)
    heads = re.findall(r"\bAMST_(?:API|TRY)\b([^;]*);", code)
    bodies = ["{}" if head.split()[0] == "void" else "{ return 0; }" for head in heads]
    return "#include <alphamst/alphamst.h>\n" + "".join(map("{} {}\n".format, heads, bodies))


def dump(directory):
    """The header's ABI in libabigail's words; the text is the same wherever it is made."""
    with open(os.path.join(directory, "alphamst.c"), "w", encoding="utf-8") as file:
        file.write(stub())
    must_run(["gcc", "-std=c99", "-gdwarf-4", "-fPIC", "-shared", f"-I{INCLUDE}", "alphamst.c",
              "-o", "stub.so"], cwd=directory)
    return must_run(["abidw", "--no-corpus-path", "--no-comp-dir-path", "--no-show-locs",
                     "--no-elf-needed", "--no-architecture", "stub.so"], cwd=directory)


def argument_names(path):
    functions = xml.etree.ElementTree.parse(path).iter("function-decl")
    return {function.get("name"): [entry.get("name") for entry in function.iter("parameter")]
            for function in functions}


def abi_differences(directory):
    """Of the header against libalphamst.abi. Additions are none; a swap of two arguments
    of one type, which abidiff does not see, shows in their names."""
    now = os.path.join(directory, "now.abi")
    pathlib.Path(now).write_text(dump(directory), encoding="utf-8")
    done = run(["abidiff", "--no-added-syms", str(ABI), now])
    wrong = [done.stdout + done.stderr] if done.returncode != 0 else []
    found = argument_names(now)
    return wrong + [f"{name}: arguments were {', '.join(names)}; are {', '.join(found[name])}"
                    for name, names in argument_names(ABI).items()
                    if name in found and names != found[name]]


def abi(_):
    with tempfile.TemporaryDirectory() as directory:
        return abi_differences(directory)


def defaults_kept(library):
    told, loaded, options = defaults(), ctypes.CDLL(str(library)), ctypes.c_void_p()
    wrong = [f"{name}: no default in its comment" for name in interface().constants
             if name.startswith("AMST_OPT_") and name not in told]
    loaded.amst_options_create(ctypes.byref(options))
    for name, (key, kind, value) in told.items():
        begins = ctypes.c_double(-1) if kind == "real" else ctypes.c_int64(-1)
        ask = loaded.amst_options_get_real if kind == "real" else loaded.amst_options_get_int
        status = ask(options, ctypes.c_int32(key), ctypes.byref(begins))
        if status != 0 or begins.value != value:
            wrong.append(f"{name}: {value:g} in the header, the library has {begins.value:g}, status {status}")
    loaded.amst_options_destroy(options)
    return wrong


def bindgen(_):
    bindings = must_run(["bindgen", str(HEADER), "--", "-std=c99"])
    found = set(re.findall(r"pub fn (amst_\w+)\s*\(", bindings))
    return differences("bindgen", interface().functions, found)


def update_abi():
    with tempfile.TemporaryDirectory() as directory:
        wrong = abi_differences(directory) if ABI.exists() else []
        if not wrong:
            text = dump(directory)
            ABI.write_text(text, encoding="utf-8")
            print(f"{ABI.name}: {text.count('<function-decl ')} functions")
        return wrong


def update(_):
    wrong = update_abi()
    for path, now in ((SYMBOLS, sorted(interface().functions)), (CONSTANTS, constants())):
        lost = [line for line in listed(path) if line not in now]
        if lost:
            wrong += [f"{path.name}: the header no longer has '{line}'" for line in lost]
        else:
            path.write_text("\n".join(now) + "\n", encoding="utf-8")
            print(f"{path.name}: {len(now)} lines")
    if wrong:
        wrong.append("Delete a file first if breaking the ABI is meant; then SOVERSION must rise.")
    return wrong


CHECKS = {"matrix": matrix, "symbols": symbols, "soname": soname,
          "constants": constants_kept, "abi": abi,
          "defaults": defaults_kept, "bindgen": bindgen, "update": update}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("check", choices=CHECKS)
    parser.add_argument("--library", help="libalphamst.so, for symbols, soname and defaults")
    arguments = parser.parse_args()
    if arguments.check in ("symbols", "soname", "defaults") and not arguments.library:
        parser.error(f"{arguments.check} needs --library")
    wrong = CHECKS[arguments.check](arguments.library)
    print("\n".join(wrong) if wrong else f"{arguments.check}: ok")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
