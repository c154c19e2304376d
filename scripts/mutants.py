#!/usr/bin/env python3
"""Whether the tests notice small wrong changes: an operator, a sign, a comparison, a constant, an index.

In a copy of the tree (target/mutants) a few changes per function are built at once, each behind a switch: a function
becomes `match crate::mutant() { 17 => { changed } … _ => { as it is } }`. Changes that do not compile are dropped. Then
the test binaries run for each change, those first that see most per second, until one fails; tests of more than half a
second only where all others pass.

  scripts/mutants.py build [--most N] FILE…      N changes per function (4), chosen by a fixed seed
  scripts/mutants.py run SECONDS [TEST…]         every change without a result; TEST: binaries of dq8, without any: all
  scripts/mutants.py report                      the survivors
"""

import itertools
import json
import os
import random
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from switched import ROOT, copy, write

COPY = ROOT / "target" / "mutants"
STATE = COPY / "state.json"
# What is replaced, and by what.
CHANGES = [
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " + "), (r" / ", " * "), (r" \+= ", " -= "), (r" -= ", " += "),
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "),
    (r"\.lt\(", ".ge("), (r"\.le\(", ".gt("), (r"\.gt\(", ".le("), (r"\.ge\(", ".lt("),
    (r" && ", " || "), (r" \|\| ", " && "), (r" & ", " | "), (r" \| ", " & "), (r"if !", "if "),
    (r"(?<=[(\[])-(?=[a-z(])", ""), (r"(?<=, )-(?=[a-z(])", ""), (r"\.abs\(\)", ""), (r"\.conjugate\(\)", ""),
    (r"\b0\.5\b", "1.0"), (r"\b1\.0\b", "0.0"), (r"\b0\.0\b", "1.0"), (r"\b2\.0\b", "1.0"),
    (r"::ZERO\b", "::ONE"), (r"::ONE\b", "::ZERO"), (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
    (r"\[1\]", "[0]"), (r"\[2\]", "[1]"), (r"\.min\(", ".max("), (r"\.max\(", ".min("), (r"\.sin\(\)", ".cos()"),
]
ENVIRONMENT = {**os.environ, "RUSTFLAGS": "--cap-lints allow", "CARGO_TARGET_DIR": str(ROOT / "target/mutants-build")}


def without_words(text):
    """The same text with blanks for comments, strings and attributes."""
    words = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|#!?\[[^\]\n]*\]'
    return re.sub(words, lambda word: re.sub(r"[^\n]", " ", word.group()), text, flags=re.S)


def closing(text, at):
    """Behind the brace that closes the one at `at`."""
    depth = 0
    for place in range(at, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    raise SystemExit("a brace is not closed")


def bodies(code):
    """(name, begin, end) of the functions that can have a switch: not of macros, constant ones, opaque results."""
    macros = [(m.start(), closing(code, m.end() - 1)) for m in re.finditer(r"macro_rules!\s*\w+\s*\{", code)]
    for head in re.finditer(r"(const )?\bfn (\w+)", code):
        depth, at = 0, head.end()
        while at < len(code) and (depth or code[at] not in "{;"):
            depth += {"(": 1, "[": 1, ")": -1, "]": -1}.get(code[at], 0)
            at += 1
        if head.group(1) or at == len(code) or code[at] == ";":
            continue
        end = closing(code, at)
        is_opaque = "impl " in code[head.start():at].rpartition("->")[2]
        if not is_opaque and "$" not in code[at:end] and not any(a <= at < b for a, b in macros):
            yield head.group(2), at + 1, end - 1


def find(files, most):
    generator, found = random.Random(8), []
    for file in files:
        text = (ROOT / file).read_text()
        code, done = without_words(text), 0
        for function, begin, end in bodies(code):
            if begin < done:  # inside the one before
                continue
            done = end
            sites = [(m.start() + begin, m.end() + begin, new)
                     for pattern, new in CHANGES for m in re.finditer(pattern, code[begin:end])]
            generator.shuffle(sites)
            for a, b, new in sorted(sites[:most]):
                line = text.count("\n", 0, a) + 1
                found.append({"id": len(found), "file": file, "line": line, "function": function, "body": [begin, end],
                              "at": [a, b], "new": new, "text": text.splitlines()[line - 1].strip()})
    return found


def place_changes(changes):
    """Writes the files, and says in which lines each change is: {file: [(first, last, ids)]}."""
    lines = {}
    for file, of_file in itertools.groupby(changes, lambda change: change["file"]):
        text, out, position, spans = (ROOT / file).read_text(), "", 0, []
        for (begin, end), group in itertools.groupby(of_file, lambda change: change["body"]):
            group = list(group)
            out += text[position:begin] + " match crate::mutant() {\n"
            for change in group:
                a, b = change["at"]
                first = out.count("\n") + 1
                out += f"{change['id']} => {{{text[begin:a]}{change['new']}{text[b:end]}}}\n"
                spans.append((first, out.count("\n"), [change["id"]]))
            first = out.count("\n") + 1
            out += "_ => {" + text[begin:end] + "}\n}"
            spans.append((first, out.count("\n") + 1, [change["id"] for change in group]))
            position = end
        write(COPY / file, (out + text[position:]).encode())
        lines[file] = spans
    return lines


def build(files, most):
    copy(COPY)
    changes = find(files, most)
    print(f"{len(changes)} changes")
    while True:
        lines = place_changes(changes)
        check = subprocess.run(["cargo", "check", "-p", "dq8", "--lib", "--message-format", "json"],
                               cwd=COPY, capture_output=True, text=True, env=ENVIRONMENT)
        if check.returncode == 0:
            break
        messages = [json.loads(line) for line in check.stdout.splitlines()]
        wrong = {number for message in messages if message.get("message", {}).get("level") == "error"
                 for span in message["message"]["spans"] if span["is_primary"]
                 for first, last, ids in lines.get(span["file_name"], ()) if first <= span["line_start"] <= last
                 for number in ids}
        if not wrong:
            raise SystemExit(check.stderr)
        changes = [change for change in changes if change["id"] not in wrong]
        # What had no change left is written as it is.
        for file in files:
            write(COPY / file, (ROOT / file).read_bytes())
    STATE.write_text(json.dumps(changes, indent=0))
    print(f"{len(changes)} of them compile")


def binaries(tests):
    chosen = [word for test in tests for word in ("--test", test)] or ["--tests"]
    built = subprocess.run(["cargo", "test", "-p", "dq8", *chosen, "--no-run", "--message-format", "json"],
                           cwd=COPY, stdout=subprocess.PIPE, text=True, check=True, env=ENVIRONMENT)
    messages = [json.loads(line) for line in built.stdout.splitlines()]
    return {m["target"]["name"]: m["executable"] for m in messages if m.get("executable") and m["target"]["kind"] == ["test"]}


def slow_tests(program):
    """Those that take more than half a second where nothing is changed, which must not fail."""
    command = [program, "-Zunstable-options", "--report-time"]
    said = subprocess.run(command, cwd=COPY, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          env={**os.environ, "RUSTC_BOOTSTRAP": "1"})
    if said.returncode:
        raise SystemExit(f"{program} fails without a change")
    times = re.findall(r"^test (\S+) .*<([\d.]+)s>", said.stdout, re.M)
    return [name for name, seconds in times if float(seconds) > 0.5]


def run(seconds, tests):
    changes, parts, took = json.loads(STATE.read_text()), {}, {}
    for name, program in binaries(tests).items():
        slow = slow_tests(program)
        parts[name] = [program, "--exact", *(word for test in slow for word in ("--skip", test))]
        if slow:
            parts[f"{name}, slow"] = [program, "--exact", *slow]
    for name, command in parts.items():
        begin = time.time()
        subprocess.run(command, cwd=COPY, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
        took[name] = time.time() - begin
    seen, deadline = {}, time.time() + seconds

    def try_one(change):
        if "result" in change or time.time() > deadline:
            return
        worth = lambda name: (seen.get((change["file"], name), 0) + 0.3) / (took[name] + 0.05)
        for name in sorted(parts, key=lambda name: (name.endswith("slow"), -worth(name))):
            environment = {**os.environ, "DQ8_MUTANT": str(change["id"]), "PROPTEST_MAX_SHRINK_ITERS": "0", "RUST_BACKTRACE": "0"}
            try:
                failed = subprocess.run(parts[name], cwd=COPY, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        env=environment, timeout=60 + 12 * took[name]).returncode
            except subprocess.TimeoutExpired:
                change["result"] = "timeout"
                return
            if failed:
                seen[change["file"], name] = seen.get((change["file"], name), 0) + 1
                change["result"] = name
                return
        change["result"] = "survived"
        print(describe(change), flush=True)

    order = random.Random(5).sample(changes, len(changes))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for number, _ in enumerate(pool.map(try_one, order)):
            if number % 20 == 0:
                STATE.write_text(json.dumps(changes, indent=0))
    STATE.write_text(json.dumps(changes, indent=0))
    report()


def describe(change):
    a, b = change["at"]
    old = (ROOT / change["file"]).read_text()[a:b]
    return f"{change['id']} {change['file']}:{change['line']} {change['function']}: '{old}' to '{change['new']}' in: {change['text']}"


def report():
    tried = [change for change in json.loads(STATE.read_text()) if "result" in change]
    for result in ("survived", "timeout"):
        for change in (change for change in tried if change["result"] == result):
            print(f"{result}: {describe(change)}")
    count = lambda result: sum(change["result"] == result for change in tried)
    print(f"{len(tried)} changes tried, {count('survived')} survived, {count('timeout')} took too long to say")


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["build", "--most", most, *files]:
            build(files, int(most))
        case ["build", *files]:
            build(files, 4)
        case ["run", seconds, *tests]:
            run(float(seconds), tests)
        case ["report"]:
            report()
        case _:
            raise SystemExit(__doc__)
