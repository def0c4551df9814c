#!/usr/bin/env python3
"""Compares the bindings with the header, one line for each difference.

fortran     amst_c_*.f90: functions as gfortran's -fc-prototypes prints them, constants, struct
julia       LibAlphaMST.jl: functions as the @ccall lines say, constants, struct; every
            @cfunction is like a callback of the header
python      module.cpp: a line for each function, whose arguments the compiler takes from the header; the tables
            of the package: constants
rust        bindings.rs is what generate.sh makes of the header today

Of a function: its name, and of each argument name, place, width and kind; the names, since
a swap of two arguments of one type shows in nothing else. Then, in all four, that the
idiomatic layer uses every function of the raw one, and where its documentation gives the
defaults of options, that they are those of the header.
"""

import argparse
import ast
import difflib
import pathlib
import re
import shutil
import sys
import tempfile

from header import ROOT, Function, Interface, defaults, interface, must_run

BINDINGS = ROOT / "bindings"
FORTRAN = BINDINGS / "fortran" / "src"
JULIA = BINDINGS / "julia" / "src"
PYTHON = BINDINGS / "python"
RUST = BINDINGS / "rust"
COMMENTS = {".f90": r"!.*", ".jl": r'"""(?s:.*?)"""|#.*', ".rs": r"//.*",
            ".cpp": r"//.*", ".py": r'(?s:""".*?""")|#.*'}
# Naming a function there is not yet using it.
IMPORTS = {".f90": r"(?im)^\s*use\b(?:.*&\s*\n)*.*$",
           ".jl": r"(?m)^\s*(?:using|import|export)\b(?:.*,\s*\n)*.*$", ".rs": r"(?s)\buse\s.*?;",
           ".py": r"(?m)^\s*(?:from|import)\b.*$"}


def source(path):
    return re.sub(COMMENTS[path.suffix], "", path.read_text(encoding="utf-8"))


# ------------------------------------------------------------------ comparison

def matches(wanted, found):
    """Languages without C's pointer types have ?* for a pointer to anything."""
    if found == "?**":
        return wanted.endswith("**")
    if found == "?*":
        return wanted.endswith("_fn") or wanted in ("void*", "char*") or re.fullmatch(r"amst_\w+\*", wanted)
    return found == wanted


def compare_function(name, wanted, found):
    if not matches(wanted.result, found.result):
        yield f"{name}: returns {found.result}, not {wanted.result}"
    if len(wanted.arguments) != len(found.arguments):
        yield f"{name}: {len(found.arguments)} arguments, not {len(wanted.arguments)}"
        return
    for place, (argument, other) in enumerate(zip(wanted.arguments, found.arguments), 1):
        if argument[0] and argument[0] != other[0]:
            yield f"{name}: argument {place} is named {other[0]}, not {argument[0]}"
        if not matches(argument[1], other[1]):
            yield f"{name}: argument {place}, {other[0]}, is {other[1]}, not {argument[1]}"


def sentinel(name, value):
    """A member that only keeps its enumeration signed and 32 bits wide."""
    return (name.endswith("_INVALID") and value == -1) or (name.endswith("_MAX") and value == 0x7fffffff)


def compare(wanted, found):
    for name in sorted(wanted.functions.keys() | found.functions.keys()):
        if name not in found.functions:
            yield f"{name}: missing"
        elif name not in wanted.functions:
            yield f"{name}: no such function in the header"
        else:
            yield from compare_function(name, wanted.functions[name], found.functions[name])
    for name, callback in found.callbacks.items():
        yield from compare_function(name, wanted.callbacks[name], callback)
    values = {**wanted.constants, **wanted.versions}
    for name, value in wanted.constants.items():
        if name not in found.constants and not sentinel(name, value):
            yield f"{name}: missing"
    for name, value in found.constants.items():
        if name not in values:
            yield f"{name}: no such constant in the header"
        elif value != values[name]:
            yield f"{name}: {value}, not {values[name]}"
    for name, members in wanted.structs.items():
        if found.structs.get(name) != members:
            yield f"{name}: members {found.structs.get(name)}, not {members}"


def wrong_defaults(path, pattern):
    """Of options in a documentation; the pattern has the groups name and value."""
    matches = re.finditer(pattern, path.read_text(encoding="utf-8"))
    found = {"AMST_OPT_" + match["name"].upper(): float(match["value"]) for match in matches}
    return [f"{name}: default {found.get(name)}, not {default.value}"
            for name, default in defaults().items() if found.get(name) != default.value]


def unused(functions, paths):
    words = {word for path in paths
             for word in re.findall(r"\w+", re.sub(IMPORTS[path.suffix], "", source(path)))}
    return [f"{name}: not used by the idiomatic layer" for name in sorted(functions - words)]


# --------------------------------------------------------------------- Fortran

FORTRAN_TYPES = {"int": "int32", "long": "int64", "void": "?"}


def fortran_argument(text, references):
    """One argument of a prototype; c_ptr and c_funptr are printed alike with value and without."""
    callback = re.fullmatch(r"\w+ \(\*(\w+)\)\(\)", text)
    base, stars, name = (("void", "*", callback[1]) if callback else
                         re.fullmatch(r"(\w[\w ]*?) ?(\**)(\w+)", text).groups())
    if base == "void" and name in references:
        stars += "*"
    return name, FORTRAN_TYPES.get(base, base) + stars


def fortran_bodies(text):
    """Of each bind(c) procedure: its name, the name in C, its declarations."""
    text = re.sub(r"&\s*&?", " ", text.lower())
    pattern = (r"^[ \w()]*\b(function|subroutine) +(\w+)([^\n]*\bbind\s*\(\s*c\b[^\n]*)\n"
               r"(.*?)\bend +\1")
    for _, name, head, body in re.findall(pattern, text, flags=re.S | re.M):
        bound = re.search(r"\bname\s*=\s*[\"'](\w+)", head)
        yield name, bound[1] if bound else name, re.findall(r"([^\n]+)::([^\n]+)", body)


def fortran_references(declarations):
    """The c_ptr and c_funptr arguments without value."""
    return {entry.strip() for attributes, entries in declarations
            if re.search(r"\bc_(fun)?ptr\b", attributes) and not re.search(r"\bvalue\b", attributes)
            for entry in entries.split(",")}


def fortran_not_in_c(declarations):
    """What gfortran prints like a plain argument of C, but passes by descriptor."""
    for attributes, entries in declarations:
        if re.search(r"\(\s*:|\ballocatable\b|\bpointer\b|\blen\s*=", attributes + entries):
            yield f"{attributes.strip()} :: {entries.strip()}"


def fortran(header):
    raw = [FORTRAN / f"amst_c_{part}.f90" for part in ("types", "context", "mesh", "operations")]
    whole = FORTRAN / "amst_c.f90"  # which uses them
    text = "\n".join(source(path) for path in raw + [whole])
    bodies = list(fortran_bodies(text))
    references = {bound: fortran_references(declarations) for _, bound, declarations in bodies}
    wrong = [f"{name}: calls {bound}" for name, bound, _ in bodies if name != bound]
    wrong += [f"{name}: is no argument of C: {declaration}" for name, _, declarations in bodies
              for declaration in fortran_not_in_c(declarations)]
    wrong += [f"{kind}: not of one width everywhere"
              for kind in sorted(set(re.findall(r"\bc_(?:int|long|long_long|size_t)\b", text.lower())))]
    with tempfile.TemporaryDirectory() as directory:
        printed = must_run(["gfortran", "-fc-prototypes", "-fsyntax-only", *raw], cwd=directory)
    printed = re.sub(r"\bconst |\s*/\*.*?\*/\s*", "", printed)
    found = Interface({}, {}, fortran_constants(text), {}, {})
    for base, stars, name, arguments in re.findall(r"^(\w+) (\**)(amst_\w+) ?\((.*)\);$", printed,
                                                   flags=re.M):
        base = "void" if (base, stars) == ("void", "") else FORTRAN_TYPES.get(base, base)
        arguments = [fortran_argument(entry, references.get(name, ()))
                     for entry in arguments.split(", ") if entry]
        place = found.callbacks if name in header.callbacks else found.functions
        place[name] = Function(base + stars, arguments)
    for members, name in re.findall(r"^typedef struct \w+ \{(.*?)\} (\w+);", printed, flags=re.S | re.M):
        found.structs[name] = [(member, FORTRAN_TYPES.get(base, base))
                               for base, member in re.findall(r"(\w+) (\w+);", members)]
    idiomatic = set(FORTRAN.rglob("*.f90")) - {*raw, whole}
    return wrong + list(compare(header, found)) + unused(header.functions.keys(), idiomatic)


def fortran_constants(text):
    """As gfortran evaluates them."""
    names = re.findall(r"\b(amst_\w+)\s*=", text, flags=re.I)
    lines = "\n".join(f"print '(a, 1x, i0)', '{name.upper()}', {name}" for name in names)
    with tempfile.TemporaryDirectory() as directory:
        program = pathlib.Path(directory, "constants.f90")
        program.write_text(f"{text}\nprogram constants\nuse amst_c\nimplicit none\n{lines}\nend program\n",
                           encoding="utf-8")
        must_run(["gfortran", program, "-o", "constants"], cwd=directory)
        printed = must_run(["./constants"], cwd=directory).split()
    return dict(zip(printed[::2], map(int, printed[1::2])))


# ----------------------------------------------------------------------- Julia

JULIA_TYPES = {"Int32": "int32", "Cint": "int32", "Int64": "int64", "Clonglong": "int64",
               "Float64": "double", "Cdouble": "double", "Cchar": "char", "Cstring": "char*", "Cvoid": "void"}


def julia_type(text):
    pointer = re.fullmatch(r"(?:Ptr|Ref)\{(.*)\}", text.strip())
    return julia_type(pointer[1]) + "*" if pointer else JULIA_TYPES.get(text.strip(), text.strip())


def julia_function(arguments, result):
    """Of "mesh::Ptr{amst_mesh}, dim::Ptr{Int32}" or, in @cfunction, of the types alone."""
    pairs = [entry.rpartition("::") for entry in arguments.split(",") if entry.strip()]
    return Function(julia_type(result), [(name.strip(), julia_type(kind)) for name, _, kind in pairs])


def julia_thunks(header, text):
    for name, result, arguments in re.findall(r"@cfunction\(\s*\$?(\w+),\s*(\w+),\s*\((.*?)\)\s*\)", text):
        thunk = julia_function(arguments, result)
        if all(list(compare_function(name, callback, thunk)) for callback in header.callbacks.values()):
            yield f"{name}: like no callback of the header"


def julia(header):
    raw = JULIA / "LibAlphaMST.jl"
    idiomatic = set(JULIA.rglob("*.jl")) - {raw}
    text = source(raw)
    constants = re.findall(r"^\s*const (AMST_\w+)\s*=\s*(?:Int32|Cint)?\(?(-?\w+)\)?\s*$", text, flags=re.M)
    found = Interface({}, {}, {name: int(value, 0) for name, value in constants}, {}, {})
    wrong = []
    calls = re.findall(r"^\s*(\w+)\((.*?)\) = @ccall (?:.*\.)?(\w+)\((.*)\)::(\w+)\s*$", text, flags=re.M)
    for name, given, called, arguments, result in calls:
        function = julia_function(arguments, result)
        found.functions[called] = function
        if name != called:
            wrong.append(f"{name}: calls {called}")
        if given != ", ".join(argument for argument, _ in function.arguments):
            wrong.append(f"{name}: takes {given} and passes something else")
    for name, members in re.findall(r"^struct (\w+)\n(.*?)^end", text, flags=re.S | re.M):
        found.structs[name] = [(member, julia_type(kind))
                               for member, kind in re.findall(r"(\w+)::(\w+)", members)]
    for path in idiomatic:
        wrong += julia_thunks(header, source(path))
    wrong += wrong_defaults(JULIA / "options.jl", r"(?m)^\| `(?P<name>\w+)` \| (?P<value>[-\d.]+) \|")
    return wrong + list(compare(header, found)) + unused(header.functions.keys(), idiomatic)


# ---------------------------------------------------------------------- Python

# Where each enumeration is: the file, the table or class in it, the prefix that its names have in the header.
PYTHON_TABLES = [
    ("error.py", "ENTITIES", "AMST_"), ("flag.py", "Flag", "AMST_FLAG_"), ("field.py", "CARRIES", "AMST_CARRY_"),
    ("patches.py", "Defect", "AMST_DEFECT_"), ("patches.py", "DECOMPOSITIONS", "AMST_DECOMPOSE_"),
    ("patches.py", "ALL", "AMST_"), ("chord.py", "PROPERTIES", "AMST_CHORD_"), ("chord.py", "Refusal", "AMST_REFUSAL_"),
    ("geometry.py", "GEOMETRIES", "AMST_GEOMETRY_"),
    ("quality.py", "METRICS", "AMST_METRIC_"), ("options.py", "KEYS", "AMST_OPT_"), ("report.py", "KEYS", "AMST_RESULT_"),
    ("report.py", "ALL", "AMST_"), ("context.py", "LOG_LEVELS", "AMST_LOG_")]
# A number without a name in Python: nothing, done, in part.
PYTHON_UNNAMED = {"AMST_ENTITY_NONE", "AMST_OK", "AMST_PARTIAL"}


def python_table(path, name):
    """Names and numbers of a dictionary, of the constants of a class, or of one constant."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ClassDef) and node.name == name:
            return {entry.targets[0].id: entry.value.value for entry in node.body if isinstance(entry, ast.Assign)}
        if isinstance(node, ast.Assign) and node.targets[0].id == name:
            value = ast.literal_eval(node.value)
            return value if isinstance(value, dict) else {name: value}
    return {}


def python_constants(header):
    found = {}
    for file, table, prefix in PYTHON_TABLES:
        for name, value in python_table(PYTHON / "alphamst" / file, table).items():
            found[prefix + name.upper()] = value
    # Names of exceptions are not those of statuses; a test asks the library for them.
    classes = re.search(r"(?s)^CLASSES = \{(.*?)^\}", source(PYTHON / "alphamst" / "error.py"), flags=re.M)[1]
    statuses = {int(number) for number in re.findall(r"(-\d+):", classes)}
    for name, value in header.constants.items():
        if name in PYTHON_UNNAMED or name.startswith("AMST_ERR_") and value in statuses:
            found[name] = value
    return found


def python(header):
    extension = PYTHON / "src"
    module = source(extension / "module.cpp")
    named = re.findall(r'\b(?:QUICK|SLOW|FREE)\((amst_\w+)\)|[{(]"(amst_\w+)"', module)
    named = {one or other for one, other in named}
    # Of these closing and failing are made.
    inner = {name for name in header.functions if name.endswith("_destroy") or name.startswith("amst_last_error")}
    functions = header.functions.keys() - inner
    wrong = [f"{name}: missing" for name in sorted(functions - named)]
    wrong += [f"{name}: no such function in the header" for name in sorted(named - functions)]
    # What is not in module.cpp by its own name alone, the compiler holds to the header where it is called.
    called = {word for path in extension.glob("*.cpp")
              for word in re.findall(r"\bamst_\w+", re.sub(r'"\w+"', "", source(path)))}
    wrong += [f"{name}: not called" for name in sorted(header.functions.keys() - called)]
    tables = header._replace(functions={}, structs={})
    wrong += compare(tables, Interface({}, {}, python_constants(header), {}, {}))
    package = PYTHON / "alphamst"
    wrong += wrong_defaults(package / "options.py", r"(?m)^ *\| `(?P<name>\w+)` \| (?P<value>[-\d.]+) \|")
    return wrong + unused(functions, package.glob("*.py"))


# ------------------------------------------------------------------------ Rust

def rust(header):
    crate = RUST / "alphamst-sys"
    if not shutil.which("rustfmt"):
        return ["generate.sh needs rustfmt"]
    with tempfile.TemporaryDirectory() as directory:
        generated = pathlib.Path(directory, "bindings.rs")
        must_run(["sh", crate / "generate.sh", generated])
        wanted = generated.read_text(encoding="utf-8").splitlines()
    found = (crate / "src" / "bindings.rs").read_text(encoding="utf-8").splitlines()
    changes = list(difflib.unified_diff(wanted, found, lineterm="", n=0))[2:]
    wrong = [f"bindings.rs: {'missing' if line[0] == '-' else 'unexpected'} '{line[1:].strip()}'"
             for line in changes if line[0] != "@"]
    wrong += wrong_defaults(RUST / "alphamst" / "src" / "options.rs",
                            r"/// (?:Integer|Real)(?: 0 or 1)?, (?P<value>[-\d.]+):(?:.*\n\s*///)*.*\n"
                            r"\s*\w+ = AMST_OPT_(?P<name>\w+),")
    return wrong + unused(header.functions.keys(), (RUST / "alphamst" / "src").rglob("*.rs"))


LANGUAGES = {"fortran": fortran, "julia": julia, "python": python, "rust": rust}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("languages", nargs="*", metavar="language",
                        help=f"of {', '.join(LANGUAGES)}; all if none")
    arguments = parser.parse_args()
    header = interface()
    wrong = []
    for language in arguments.languages or LANGUAGES:
        lines = LANGUAGES[language](header)
        print("\n".join(f"{language}: {line}" for line in lines or ["ok"]))
        wrong += lines
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
