#!/usr/bin/env python3
"""Runs Gappa on a folder of scripts and compares what it proves with gappa.toml, or writes that file.

    gappa.py FOLDER             # exit 1 if a bound is not the file's, or missing in either
    gappa.py FOLDER --write     # writes the file
    gappa.py FOLDER --missing   # runs what the file lacks, and adds it
"""

import os
import re
import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FILE = Path(__file__).resolve().parent / "gappa.toml"
HEADING = """\
# What Gappa proves of the tapes, written by gappa.py: the largest error of any number of the answer, in units of u.
# Rotations have lengths within 2^-9 of 1, all other arguments are no longer than 1, and
# functions are of one number in the range of their polynomials. "none": not within 20 s of CPU.
"""


def proved(script):
    """The bound in units of u, to the next thousandth, if there is one."""
    run = subprocess.run(["bash", "-c", f"ulimit -t 20; exec gappa '{script}'"], capture_output=True, text=True, check=False)
    found = re.search(r"\|n\d+ - M\d+\| in \[.*?(?:\{([^,]*),|, ?(\d+)\])", run.stdout + run.stderr)
    unit = 2.0 ** (-24 if ".f32." in script.name else -53)
    return -(-float(found[1] or found[2]) / unit * 1000 // 1) / 1000 if found else None


def all_proved(name, scripts):
    """That of the whole answer."""
    bounds = [proved(script) for script in scripts]
    bound = "none" if None in bounds else max(bounds)
    print(f"{name}: {bound}", flush=True)
    return name, bound


def main():
    known = tomllib.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    scripts = {}
    for script in sorted(Path(sys.argv[1]).glob("*.g")):
        scripts.setdefault(script.stem.rpartition(".")[0], []).append(script)
    if "--missing" in sys.argv:
        scripts = {name: script for name, script in scripts.items() if name not in known}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        table = dict(pool.map(all_proved, scripts, scripts.values()))
    print(f"{len(table)} operations, {list(table.values()).count('none')} without a bound")
    if "--write" in sys.argv or "--missing" in sys.argv:
        table = table if "--write" in sys.argv else known | table
        lines = [f'"{name}" = ' + (f'"{bound}"' if bound == "none" else str(bound)) for name, bound in sorted(table.items())]
        FILE.write_text(HEADING + "\n".join(lines) + "\n", encoding="utf-8")
        return
    wrong = [f"{name}: {table.get(name)}, and {known.get(name)} in gappa.toml"
             for name in sorted(known.keys() | table.keys()) if known.get(name) != table.get(name)]
    if wrong:
        sys.exit("\n".join(wrong))


main()
