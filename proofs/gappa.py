#!/usr/bin/env python3
"""Runs Gappa on a folder of scripts and compares what it proves with gappa.toml, or writes that file.

    gappa.py FOLDER           # exit 1 if a bound is larger than the file's, or missing in either
    gappa.py FOLDER --write   # writes the file
"""

import re
import resource
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
FILE = HERE / "gappa.toml"
HEADING = """\
# What Gappa proves of the tapes, written by gappa.py: the largest error of any number of the answer, in units of u.
# Rotations have lengths within 2^-9 of 1, all other arguments are no longer than 1. "." is what Gappa finds no bound of.
"""


def proved(script):
    """The largest bound in units of u; None without one."""
    run = subprocess.run(["gappa", script], capture_output=True, text=True, check=False)
    text = run.stdout + run.stderr
    goals = script.read_text().count(" in ?")
    bounds = [float(a or b) for a, b in
              re.findall(r"\|n\d+ - M\d+\| in \[.*?(?:\{([^,]*),|, ?(\d+)\])", text)]
    return max(bounds) / 2.0 ** (-24 if ".f32." in script.name else -53) if len(bounds) == goals else None


def main():
    folder = Path(sys.argv[1])
    table, wrong = {}, []
    for script in sorted(folder.glob("*.g")):
        bound = proved(script)
        table[script.stem] = "." if bound is None else -(-bound * 1000 // 1) / 1000
        print(f"{script.stem}: {table[script.stem]}", flush=True)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    without = [name for name, bound in table.items() if bound == "."]
    print(f"{len(table)} scripts, {len(without)} without a bound, {used.ru_utime + used.ru_stime:.0f} s of CPU")
    if "--write" in sys.argv:
        lines = [f'"{name}" = {repr(bound) if bound != "." else chr(34) + "." + chr(34)}' for name, bound in table.items()]
        FILE.write_text(HEADING + "\n".join(lines) + "\n", encoding="utf-8")
        return
    known = tomllib.loads(FILE.read_text(encoding="utf-8"))
    for name in sorted(known.keys() | table.keys()):
        if known.get(name) != table.get(name):
            wrong.append(f"{name}: {table.get(name)}, and {known.get(name)} in gappa.toml")
    if wrong:
        sys.exit("\n".join(wrong))


main()
