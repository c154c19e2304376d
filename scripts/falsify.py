#!/usr/bin/env python3
"""Whether the tests behind docs/claims.md would notice if the claims were false.

lab/mutations.toml has changes of one constant, sign or factor that falsify claims, each with the tests that must
fail of it. In a copy of the tree (target/falsify) all of them are built at once, each behind a switch, so that one
build of a test binary serves all: `if dq8::mutant() == 17 { changed } else { as it is }`. What is no expression (a constant)
is built alone. Then each test runs without a change, where it must pass, and with each of its own, where it must not.

  scripts/falsify.py             everything
  scripts/falsify.py jia 37_43   what has all of these words in its tests or its file
  scripts/falsify.py --switched  leaves out what needs a build of its own
  scripts/falsify.py --check     nothing is built: each old text is there exactly once, each test exists, and each row
                                 whose claim holds or is wrong has a test in the table, or is in its list of those without
  scripts/falsify.py --rows      the rows of claims.md without a change
"""

import json
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

from switched import ROOT, SWITCH, copy, write

COPY = ROOT / "target" / "falsify"
TABLE = ROOT / "lab" / "mutations.toml"


def table():
    with TABLE.open("rb") as file:
        data = tomllib.load(file)
    return data["mutation"], data.get("without", [])


def claims():
    """(line, section, verdict, tests) of every row whose verdict is on the matter."""
    source = None
    for number, line in enumerate((ROOT / "docs/claims.md").read_text().splitlines(), 1):
        if line.startswith("## "):
            source = line[3:].split(",")[0]
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if source and len(cells) == 4 and cells[3].startswith(("holds", "wrong")):
            yield number, f"{source} {cells[0]}", cells[3], re.findall(r"`([^`]+)`", cells[2])


def uncovered(mutations):
    tried = {test for mutation in mutations for test in mutation["tests"]}
    return [row for row in claims() if not tried & set(row[3])]


def check(mutations, without):
    wrong = []
    for mutation in mutations:
        path = ROOT / mutation["file"]
        text = path.read_text() if path.exists() else ""
        if (count := text.count(mutation["old"])) != 1:
            wrong.append(f"{mutation['file']}: {count} times: {mutation['old']}")
        if mutation["old"] == mutation["new"]:
            wrong.append(f"{mutation['file']}: no change: {mutation['old']}")
        for test in mutation["tests"]:
            file, _, name = test.partition("::")
            if not (ROOT / file).exists() or f"fn {name}(" not in (ROOT / file).read_text():
                wrong.append(f"no such test: {test}")
    listed = {entry["row"] for entry in without}
    rows = {row[1] for row in uncovered(mutations)}
    wrong += [f"no change falsifies: {row}" for row in sorted(rows - listed)]
    wrong += [f"needs not be listed as without: {row}" for row in sorted(listed - rows)]
    return wrong


def target(test):
    """(package, arguments of cargo test, path of the test in its binary)."""
    file, _, name = test.partition("::")
    parts = Path(file).with_suffix("").parts
    if parts[0] == "lab":
        module = "::".join((*parts[3:], name))
        return "lab", ("--test", parts[2]), module
    if parts[0] == "tests":
        return "dq8", ("--test", parts[1]), "::".join((*parts[2:], name))
    raise SystemExit(f"do not know the binary of {test}")


def module_of(binary, path):
    """The test as the binary calls it: modules in macros and `main` have names of their own."""
    names = subprocess.run([binary, "--list"], capture_output=True, text=True, check=True).stdout
    names = [line.removesuffix(": test") for line in names.splitlines() if line.endswith(": test")]
    *modules, name = path.split("::")
    found = [full for full in names if full == path]
    found = found or [full for full in names if full.endswith(f"::{name}") and {*modules} <= {*full.split("::")}]
    if not found:
        raise SystemExit(f"{binary} has no test {path}")
    return found


def apply(mutations, alone=None):
    """The tree with all switched changes, or with a single one of those that are none."""
    changes = {}
    # The one that is alone comes last, and replaces what overlaps it.
    for number, mutation in sorted(enumerate(mutations), key=lambda pair: pair[0] == alone):
        name = mutation["file"]
        spans = changes.setdefault(name, [])
        if mutation.get("alone") and number != alone:
            continue
        changed = mutation["new"]
        if not mutation.get("alone"):
            crate = "crate" if name.startswith("src/") else "dq8"
            changed = f"(if {crate}::mutant() == {number} {{ {changed} }} else {{ {mutation['old']} }})"
        start = (ROOT / name).read_text().index(mutation["old"])
        end = start + len(mutation["old"])
        others = [span for span in spans if span[0] < end and start < span[1]]
        if others and number != alone:
            raise SystemExit(f"{name}: changes overlap: {mutation['old']}")
        spans[:] = [span for span in spans if span not in others]
        spans.append((start, end, changed))
    changes.setdefault("src/lib.rs", [])
    for name, spans in changes.items():
        text = (ROOT / name).read_text()
        for start, end, changed in sorted(spans, reverse=True):
            text = text[:start] + changed + text[end:]
        write(COPY / name, (text + SWITCH if name == "src/lib.rs" else text).encode())


def build(package, arguments):
    """The path of the binary."""
    command = ["cargo", "test", "-p", package, *arguments, "--no-run", "--message-format=json"]
    run = subprocess.run(command, cwd=COPY, capture_output=True, text=True)
    if run.returncode:
        messages = [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]
        errors = [m["message"]["rendered"] for m in messages if m.get("reason") == "compiler-message" and m["message"]["level"] == "error"]
        raise SystemExit("a change does not compile:\n" + "\n".join(errors) + run.stderr[-2000:])
    for line in run.stdout.splitlines():
        message = json.loads(line) if line.startswith("{") else {}
        if message.get("reason") == "compiler-artifact" and message.get("executable") and message["target"]["name"] == arguments[1]:
            return message["executable"]
    raise SystemExit(f"no binary of {package} {arguments}")


def passes(binary, package, names, number=None):
    environment = os.environ | ({} if number is None else {"DQ8_MUTANT": str(number)})
    environment |= {"RUST_BACKTRACE": "0", "PROPTEST_FAILURE_PERSISTENCE": "off"}
    cwd = COPY / "lab" if package == "lab" else COPY
    try:
        run = subprocess.run([binary, "--exact", *names], cwd=cwd, env=environment, capture_output=True, timeout=300)
    except subprocess.TimeoutExpired:
        # What never ends does not pass.
        return False
    return run.returncode == 0


def main():
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    if set(sys.argv[1:]) - {*words, "--check", "--rows", "--switched"}:
        raise SystemExit(__doc__)
    mutations, without = table()
    if "--rows" in sys.argv:
        for line, row, verdict, _ in uncovered(mutations):
            print(f"{line}: {row}: {verdict}")
        return 0
    if wrong := check(mutations, without):
        print("\n".join(wrong))
        return 1
    if "--check" in sys.argv:
        rows = sum(1 for _ in claims())
        print(f"{len(mutations)} changes falsify {rows - len(without)} of {rows} rows")
        return 0
    os.environ.setdefault("CARGO_PROFILE_DEV_DEBUG", "0")
    os.environ.setdefault("CARGO_INCREMENTAL", "1")
    copy(COPY)
    apply(mutations)
    survivors, binaries = [], {}
    is_chosen = lambda mutation, test: all(word in test + " " + mutation["file"] for word in words)
    tries = [(number, mutation, test) for number, mutation in enumerate(mutations) for test in mutation["tests"]
             if is_chosen(mutation, test) and not (mutation.get("alone") and "--switched" in sys.argv)]

    def program(test, again=False):
        package, arguments, path = target(test)
        if again or (package, arguments) not in binaries:
            binaries[package, arguments] = build(package, arguments)
        binary = binaries[package, arguments]
        return binary, package, module_of(binary, path)

    for test in sorted({test for _, _, test in tries}):
        if not passes(*program(test)):
            raise SystemExit(f"fails without any change: {test}")
    # Those with a build of their own come last.
    for number, mutation, test in sorted(tries, key=lambda one: bool(one[1].get("alone"))):
        alone = bool(mutation.get("alone"))
        if alone:
            apply(mutations, number)
        if passes(*program(test, alone), None if alone else number):
            survivors.append(test)
            print(f"survives in {test}\n    {mutation['file']}: {mutation['old']}  ->  {mutation['new']}", flush=True)
    print(f"{len(tries)} tries, {len(survivors)} survive")
    return 1 if survivors or not tries else 0


if __name__ == "__main__":
    sys.exit(main())
