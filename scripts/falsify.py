#!/usr/bin/env python3
"""Whether the tests behind docs/claims.md would notice if the claims were false.

lab/mutations.toml has changes of one constant, sign or factor that falsify claims, each with the tests that must
fail of it. Those of the library (src/) or of a formula of the laboratory (lab/src/) also name the rows of claims.md that
they falsify, by source and section; a change of a test shows only that the test can fail, and counts for no row. In a copy of the tree (target/falsify) all of them are built at once, each behind a switch, so that one
build of a test binary serves all: `if dq8::mutant() == 17 { changed } else { as it is }`. What is no expression (a constant)
is built alone. Then each test runs without a change, where it must pass, and with each of its own, where it must not.

  scripts/falsify.py             everything (with two free cores about an hour: 25 changes have a build of their own)
  scripts/falsify.py jia 37_43   what has all of these words in its test, its file or its rows
  scripts/falsify.py --switched  leaves out what needs a build of its own
  scripts/falsify.py --check     nothing is built: each old text is there exactly once, each test exists, and each row
                                 whose claim holds or is wrong is named by a change of the library or the laboratory that
                                 one of its tests must fail of, or is in the list of those without
                                 The first row that a change names is its own. Any other counts only with an entry
                                 `checked` that says why that change falsifies it; the rows of before this rule that
                                 nobody has read so are in the list `unread`, which only gets shorter
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
# How many rows count by their name in a change for others that nobody has checked. It only falls.
UNREAD = 145


def table():
    with TABLE.open("rb") as file:
        data = tomllib.load(file)
    return data["mutation"], data.get("without", [])


def readers():
    """The rows that a second reader has checked, with the reason; and those that nobody has read yet, which only get fewer."""
    with TABLE.open("rb") as file:
        data = tomllib.load(file)
    return {entry["row"]: entry["why"] for entry in data.get("checked", [])}, data["unread"]


def is_formula(mutation):
    """Whether it changes what is claimed, and not what tests it."""
    return mutation["file"].startswith(("src/", "lab/src/"))


def own(mutation):
    """The row that a change is made for: the first."""
    return mutation.get("rows", [])[:1]


def claims(text=None):
    """(line, name, verdict, tests) of every row whose verdict is on the matter."""
    source = None
    text = text or (ROOT / "docs/claims.md").read_text()
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("## "):
            source = line[3:].split(",")[0]
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if source and len(cells) == 4 and cells[3].startswith(("holds", "wrong")):
            yield number, f"{source} {cells[0]}", cells[3], re.findall(r"`([^`]+)`", cells[2])


def uncovered(mutations, rows):
    """The rows that no change falsifies by one of their own tests."""
    tried = {(row, test) for mutation in mutations if is_formula(mutation)
             for row in mutation.get("rows", ()) for test in mutation["tests"]}
    return [row for row in rows if not any((row[1], test) in tried for test in row[3])]


def is_there(test):
    file, _, name = test.partition("::")
    return (ROOT / file).exists() and f"fn {name}(" in (ROOT / file).read_text()


def unread(mutations, checked, rows):
    """The rows that no change is made for, and of which no second reader has said why a change for others falsifies them."""
    read = {row for mutation in mutations if is_formula(mutation) for row in own(mutation)} | set(checked)
    named = {row for mutation in mutations for row in mutation.get("rows", ())}
    return sorted(named & {row[1] for row in rows} - read)


def check(mutations, without, rows, checked=(), not_read=None):
    names, wrong = {}, []
    for line, row, _, tests in rows:
        if row in names:
            wrong.append(f"line {line}: two rows are called {row}")
        names[row] = set(tests)
        wrong += [f"line {line}: no such test: {test}" for test in tests if ".rs::" in test and not is_there(test)]
    for mutation in mutations:
        path = ROOT / mutation["file"]
        text = path.read_text() if path.exists() else ""
        if (count := text.count(mutation["old"])) != 1:
            wrong.append(f"{mutation['file']}: {count} times: {mutation['old']}")
        if mutation["old"] == mutation["new"]:
            wrong.append(f"{mutation['file']}: no change: {mutation['old']}")
        wrong += [f"no such test: {test}" for test in mutation["tests"] if not is_there(test)]
        for row in mutation.get("rows", ()):
            if not is_formula(mutation):
                wrong.append(f"{mutation['file']}: a change of a test falsifies no row: {row}")
            if row not in names:
                wrong.append(f"{mutation['file']}: no such row: {row}")
            elif not names[row] & set(mutation["tests"]):
                wrong.append(f"{mutation['file']}: none of its tests is one of {row}")
    if not_read is not None:
        open_rows = set(unread(mutations, checked, rows))
        wrong += [f"no change is made for it, and no `checked` says why another's falsifies it: {row}"
                  for row in sorted(open_rows - set(not_read))]
        wrong += [f"needs not be listed as unread: {row}" for row in sorted(set(not_read) - open_rows)]
        wrong += [f"checked without a reason: {row}" for row, why in sorted(checked.items()) if not why.strip()]
        if len(not_read) > UNREAD:
            wrong.append(f"{len(not_read)} rows are unread, where {UNREAD} were: the list only gets shorter")
    listed = {entry["row"] for entry in without}
    open_rows = {row[1] for row in uncovered(mutations, rows)}
    wrong += [f"no change falsifies: {row}" for row in sorted(open_rows - listed)]
    wrong += [f"needs not be listed as without: {row}" for row in sorted(listed - open_rows)]
    return wrong


def target(test):
    """(package, arguments of cargo test, path of the test in its binary)."""
    file, _, name = test.partition("::")
    parts = Path(file).with_suffix("").parts
    if parts[0] == "lab":
        module = "::".join((*parts[3:], name))
        return "lab", ("--test", parts[2]), module
    if parts[0] == "robot":
        return "dq8-robot", ("--test", parts[2]), "::".join((*parts[3:], name))
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
    changes = {mutation["file"]: [] for mutation in mutations}
    # Several may change the same text.
    switched = {}
    for number, mutation in enumerate(mutations):
        if not mutation.get("alone"):
            switched.setdefault((mutation["file"], mutation["old"]), []).append((number, mutation["new"]))
    replaced = []
    for (name, old), news in switched.items():
        crate = "crate" if name.startswith("src/") else "dq8"
        chosen = "".join(f"if {crate}::mutant() == {number} {{ {new} }} else " for number, new in news)
        replaced.append((name, old, f"({chosen}{{ {old} }})"))
    # The one that is alone comes last, and replaces what overlaps it.
    if alone is not None:
        replaced.append(tuple(mutations[alone][key] for key in ("file", "old", "new")))
    for index, (name, old, changed) in enumerate(replaced):
        spans = changes[name]
        start = (ROOT / name).read_text().index(old)
        end = start + len(old)
        others = [span for span in spans if span[0] < end and start < span[1]]
        if others and index < len(switched):
            raise SystemExit(f"{name}: changes overlap: {old}")
        spans[:] = [span for span in spans if span not in others]
        spans.append((start, end, changed))
    changes.setdefault("src/lib.rs", [])
    for name, spans in changes.items():
        text = (ROOT / name).read_text()
        for start, end, changed in sorted(spans, reverse=True):
            text = text[:start] + changed + text[end:]
        write(COPY / name, (text + SWITCH if name == "src/lib.rs" else text).encode())


def home(package):
    """The root of its workspace."""
    return COPY / "lab" if package == "lab" else COPY


def build(package, arguments):
    """The path of the binary."""
    command = ["cargo", "test", "-p", package, *arguments, "--no-run", "--message-format=json", "--target-dir", COPY / "target"]
    run = subprocess.run(command, cwd=home(package), capture_output=True, text=True)
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
    try:
        run = subprocess.run([binary, "--exact", *names], cwd=home(package), env=environment, capture_output=True, timeout=300)
    except subprocess.TimeoutExpired:
        # What never ends does not pass.
        return False
    return run.returncode == 0


def main():
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    if set(sys.argv[1:]) - {*words, "--check", "--rows", "--switched"}:
        raise SystemExit(__doc__)
    (mutations, without), rows = table(), list(claims())
    if "--rows" in sys.argv:
        for line, row, verdict, _ in uncovered(mutations, rows):
            print(f"{line}: {row}: {verdict}")
        return 0
    if wrong := check(mutations, without, rows, *readers()):
        print("\n".join(wrong))
        return 1
    if "--check" in sys.argv:
        formulas = sum(map(is_formula, mutations))
        print(f"{formulas} changes of the library and the laboratory falsify {len(rows) - len(without)} of {len(rows)} rows; "
              f"{len(mutations) - formulas} of tests show that those can fail")
        return 0
    os.environ.setdefault("CARGO_PROFILE_DEV_DEBUG", "0")
    os.environ.setdefault("CARGO_INCREMENTAL", "1")
    copy(COPY)
    apply(mutations)
    survivors, binaries = [], {}
    is_chosen = lambda mutation, test: all(
        word in " ".join((test, mutation["file"], *mutation.get("rows", ()))) for word in words)
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
