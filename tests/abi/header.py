"""The C header as clang reads it, in the few words a binding can be compared with.

Types are written without const and without spaces: int32, int64, double, void, char*
(a string), void* (the caller's own pointer), amst_mesh* (a handle), amst_mesh** (where a
handle is written), int32* and the like (arrays and outputs), amst_log_fn (a callback).
"""

import collections
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
INCLUDE = ROOT / "include"
HEADER = INCLUDE / "alphamst" / "alphamst.h"

WIDTHS = {"int32_t": "int32", "int64_t": "int64", "amst_status": "int32", "amst_id": "int32"}

# arguments: list of (name, type)
Function = collections.namedtuple("Function", "result arguments")
# functions: name -> Function; callbacks likewise, their arguments without names;
# constants, versions: name -> int; structs: name -> list of (name, type)
Default = collections.namedtuple("Default", "key kind value")
Interface = collections.namedtuple("Interface", "functions callbacks constants versions structs")


def run(command, **options):
    return subprocess.run(command, text=True, capture_output=True, check=False, **options)


def must_run(command, **options):
    done = run(command, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def plain(c_type):
    """A C type in the words above."""
    words = re.sub(r"\bconst\b|\bstruct\b", " ", c_type).replace("*", " * ").split()
    return "".join(WIDTHS.get(word, word) for word in words)


def signature(c_type):
    """Result and argument types of "int (double, const char *)"."""
    result, arguments = re.fullmatch(r"(.*?)\s*(?:\(\*\))?\((.*)\)", c_type).groups()
    return plain(result), [plain(part) for part in arguments.split(",") if plain(part) != "void"]


def defaults():
    """Of every option of the header as its comment says: the key, int or real, the default."""
    text = HEADER.read_text(encoding="utf-8")
    found = re.findall(r"\b(AMST_OPT_\w+) = (\d+),\s*/\* (int|real)(?: 0/1)?, (\S+): ", text)
    return {name: Default(int(key), kind, float(value)) for name, key, kind, value in found}


def enumerators(enum):
    """Names and values; clang prints a value only where the header has one."""
    value = -1
    for entry in enum.get("inner", []):
        given = [int(inner["value"]) for inner in entry.get("inner", []) if "value" in inner]
        value = given[0] if given else value + 1
        yield entry["name"], value


def interface():
    clang = ["clang", "-std=c99", "-x", "c", f"-I{INCLUDE}", HEADER]
    tree = json.loads(must_run([*clang, "-fsyntax-only", "-Xclang", "-ast-dump=json"]))
    macros = must_run([*clang, "-E", "-dM"])
    versions = re.findall(r"#define (AMST_VERSION_\w+) (\d+)", macros)
    found = Interface({}, {}, {}, {name: int(value) for name, value in versions}, {})
    for node in tree["inner"]:
        name = node.get("name", "")
        if not name.startswith("amst_"):
            continue
        inner = node.get("inner", [])
        if node["kind"] == "FunctionDecl":
            arguments = [(entry["name"], plain(entry["type"]["qualType"]))
                         for entry in inner if entry["kind"] == "ParmVarDecl"]
            found.functions[name] = Function(signature(node["type"]["qualType"])[0], arguments)
        elif node["kind"] == "TypedefDecl" and "(*)" in node["type"]["qualType"]:
            result, types = signature(node["type"]["qualType"])
            found.callbacks[name] = Function(result, [(None, c_type) for c_type in types])
        elif node["kind"] == "EnumDecl":
            found.constants.update(enumerators(node))
        elif node["kind"] == "RecordDecl" and node.get("completeDefinition"):
            found.structs[name] = [(entry["name"], plain(entry["type"]["qualType"]))
                                   for entry in inner]
    return found
