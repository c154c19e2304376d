#!/usr/bin/env python3
"""Whether the tests notice small wrong changes: an operator, a sign, a comparison, a constant, an index.

In a copy of the tree (target/mutants) a few changes per function are built at once, each behind a switch: a function
becomes `match crate::mutant_in(17) { 17 => { changed } … _ => { as it is } }`. Changes that do not compile are dropped.
Every test then runs once with nothing changed, and says which of these functions it calls. For each change those tests run
that call its function, first those that see most per second, until one fails.

  scripts/mutants.py build [--most N] FILE…      N changes per function (4), chosen by a fixed seed
  scripts/mutants.py run SECONDS [TEST…]         every change without a result; TEST: binaries of tests, without any: all
  scripts/mutants.py report                      the survivors, but for those that no test can see
  scripts/mutants.py check                       whether the lines that scripts/mutants.toml quotes are still there

scripts/mutants.toml lists the changes that no test can see (`[[equivalent]]`: file, function, line as it is, changed, reason).
"""

import itertools
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import time
import tomllib
from concurrent.futures import ThreadPoolExecutor

from switched import ROOT, SWITCH, copy, write

# Which functions have been called goes to the file DQ8_CALLED, if there is one.
CALLED = """
/// What `mutant` says, called by the function whose first change has this number.
#[doc(hidden)]
#[allow(missing_docs, clippy::all)]
pub fn mutant_in(first: usize) -> usize {
    use std::{fs::File, io::Write, sync::OnceLock, sync::atomic::{AtomicBool, Ordering}};
    static SEEN: [AtomicBool; 1 << 14] = [const { AtomicBool::new(false) }; 1 << 14];
    static FILE: OnceLock<Option<File>> = OnceLock::new();
    let file = FILE.get_or_init(|| Some(File::create(std::env::var_os("DQ8_CALLED")?).unwrap()));
    if let Some(mut file) = file.as_ref() && !SEEN[first].swap(true, Ordering::Relaxed) {
        writeln!(file, "{first}").unwrap();
    }
    mutant()
}
"""
COPY = ROOT / "target" / "mutants"
PACKAGES = ["-p", "dq8", "-p", "dq8-robot", "--features", "dq8-robot/urdf,dq8-robot/rayon"]
STATE = COPY / "state.json"
EQUIVALENT = ROOT / "scripts/mutants.toml"
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
            first = len(found)
            for a, b, new in sorted(sites[:most]):
                line = text.count("\n", 0, a) + 1
                found.append({"id": len(found), "first": first, "file": file, "line": line, "function": function, "body": [begin, end],
                              "at": [a, b], "new": new, "text": text.splitlines()[line - 1].strip()})
    return found


def place_changes(changes):
    """Writes the files, and says in which lines each change is: {file: [(first, last, ids)]}."""
    lines = {}
    for file, of_file in itertools.groupby(changes, lambda change: change["file"]):
        text, out, position, spans = (ROOT / file).read_text(), "", 0, []
        for (begin, end), group in itertools.groupby(of_file, lambda change: change["body"]):
            group = list(group)
            out += text[position:begin] + f" match crate::mutant_in({group[0]['first']}) {{\n"
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
    write(COPY / "src/lib.rs", (ROOT / "src/lib.rs").read_bytes() + (SWITCH + CALLED).encode())
    write(COPY / "robot/src/lib.rs", (ROOT / "robot/src/lib.rs").read_bytes() + b"#[doc(hidden)] pub use dq8::mutant_in;\n")
    changes = find(files, most)
    print(f"{len(changes)} changes")
    while True:
        lines = place_changes(changes)
        check = subprocess.run(["cargo", "check", *PACKAGES, "--lib", "--message-format", "json"],
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
    built = subprocess.run(["cargo", "test", *PACKAGES, *chosen, "--no-run", "--message-format", "json"],
                           cwd=COPY, stdout=subprocess.PIPE, text=True, check=True, env=ENVIRONMENT)
    messages = [json.loads(line) for line in built.stdout.splitlines()]
    # Of both packages some have the same name.
    return {m["target"]["src_path"]: m["executable"] for m in messages if m.get("executable") and m["target"]["kind"] == ["test"]}


def tests_of(program):
    return re.findall(r"^(.+): test$", subprocess.run([program, "--list"], stdout=subprocess.PIPE, text=True).stdout, re.M)


def calls(test):
    """The functions that a test calls, by their first change, and how long it takes; it must pass."""
    name, program, case = test
    with tempfile.NamedTemporaryFile("r") as file:
        begin = time.time()
        if fails(test, {"DQ8_CALLED": file.name}, 600):
            raise SystemExit(f"{name} {case} fails without a change")
        return set(map(int, file.read().split())), time.time() - begin


def fails(test, variables, seconds):
    _, program, case = test
    return subprocess.run([program, "--exact", case], cwd=COPY, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          env={**os.environ, **variables, "RUST_BACKTRACE": "0"}, timeout=seconds).returncode


def run(seconds, names):
    changes, listed = json.loads(STATE.read_text()), equivalent()
    for change in changes:
        if key(change) in listed:
            change["result"] = "listed"
    tests = [(name, program, case) for name, program in binaries(names).items() for case in tests_of(program)]
    seen, deadline = {}, time.time() + seconds
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        called = dict(zip(tests, pool.map(calls, tests)))
    print(f"{len(tests)} tests, {sum(took for _, took in called.values()):.0f} s", flush=True)

    def try_one(change):
        if "result" in change or time.time() > deadline:
            return
        able = [test for test in tests if change["first"] in called[test][0]]
        worth = lambda test: (seen.get((change["file"], test), 0) + 0.3) / (called[test][1] + 0.05)
        for test in sorted(able, key=worth, reverse=True):
            variables = {"DQ8_MUTANT": str(change["id"]), "PROPTEST_MAX_SHRINK_ITERS": "0"}
            try:
                failed = fails(test, variables, 20 + 12 * called[test][1])
            except subprocess.TimeoutExpired:
                change["result"] = "timeout"
                return
            if failed:
                seen[change["file"], test] = seen.get((change["file"], test), 0) + 1
                change["result"] = f"{test[0]} {test[2]}"
                return
        change["result"] = "survived" if able else "not called"
        print(change["result"], describe(change), flush=True)

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


def key(change):
    """As in the list: where, the line, and the line with the change."""
    (a, b), text = change["at"], (ROOT / change["file"]).read_text()
    changed = text[text.rfind("\n", 0, a) + 1:a] + change["new"] + text[b:].partition("\n")[0]
    return change["file"], change["function"], change["text"], changed.strip()


def equivalent():
    """The changes that no test can see. Each has a reason, and quotes a line that its function has."""
    listed, errors = set(), []
    for entry in tomllib.loads(EQUIVALENT.read_text())["equivalent"]:
        file, function, line, new, reason = (entry[key].strip() for key in ("file", "function", "line", "changed", "reason"))
        text = (ROOT / file).read_text() if (ROOT / file).is_file() else ""
        # A function within another belongs to the outer one.
        own = [text[begin:end] for name, begin, end in bodies(without_words(text)) if name == function]
        if not any(line in (one.strip() for one in body.splitlines()) for body in own):
            errors.append(f"{file}, {function}: this line is gone: {line}")
        if not reason or new == line or (file, function, line, new) in listed:
            errors.append(f"{file}, {function}: no reason, no change, or a change that is listed: {new}")
        listed.add((file, function, line, new))
    if errors:
        raise SystemExit("\n".join(errors))
    return listed


def report():
    listed = equivalent()
    tried = [change for change in json.loads(STATE.read_text()) if "result" in change]
    for change in tried:
        if key(change) in listed:
            change["result"] = "listed"
    for result in ("survived", "not called", "timeout"):
        for change in (change for change in tried if change["result"] == result):
            print(f"{result}: {describe(change)}")
    count = lambda result: sum(change["result"] == result for change in tried)
    print(f"{len(tried)} changes tried, {count('survived')} survived, {count('not called')} are called by no test, "
          f"{count('timeout')} took too long to say, {count('listed')} are equivalent by {EQUIVALENT.name}")


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
        case ["check"]:
            equivalent()
        case _:
            raise SystemExit(__doc__)
