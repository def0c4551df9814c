"""A program that runs whole_run with other arguments, or spoils what it wrote."""
import sys

DAMAGING = """#!{python}
import subprocess, sys
arguments = sys.argv[1:]
{before}
code = subprocess.run([{program!r}, *arguments]).returncode
if len(arguments) == 5:
    lines = open(arguments[1]).read().splitlines()
    {after}
    open(arguments[1], "w").write("\\n".join(lines) + "\\n")
sys.exit(code)
"""


def program(folder, whole_run, before="", after=""):
    """Where it adapts: `before` may change the list `arguments`, `after` the `lines` of the mesh."""
    path = folder / "damaging"
    path.write_text(DAMAGING.format(python=sys.executable, program=str(whole_run), before=before,
                                    after=after or "pass"), encoding="utf-8")
    path.chmod(0o755)
    return path
