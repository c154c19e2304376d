"""Fails for a test, or a part of one, behind `#[cfg(feature = "…")]` that no step of .ci/run or .ci/beside compiles.

The steps are read from the two scripts: Cargo says for each of their `cargo test` commands which targets it compiles with
which features (--unit-graph, which compiles nothing). The conditions are read from the sources of all targets of all
workspaces, module by module. What is neither `test` nor a feature (a target, a flag) is taken to hold either way.
"""

import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STEPS = [".ci/run", ".ci/beside"]
# Its test needs a peer of hundreds of crates: .github/workflows/check.yml builds it weekly.
ELSEWHERE = ("benches/mechanism/",)
ENVIRONMENT = {**os.environ, "RUSTC_BOOTSTRAP": "1"}


def commands():
    """(directory, arguments) of each `cargo test` that compiles tests."""
    for script in STEPS:
        where, arrays = ".", {}
        text = (ROOT / script).read_text().replace("\\\n", " ")
        for line in map(str.strip, text.splitlines()):
            if array := re.fullmatch(r"(\w+)=\((.*)\)", line):
                arrays[array[1]] = array[2]
            elif line.startswith("cd ") and "$" not in line:
                where = line.removeprefix("cd ")
            elif line.startswith(")"):
                where = "."
            elif test := re.match(r"(?:[\w]+=(?:\"[^\"]*\"|\S*) +)*cargo test\b(.*)", line):
                written = re.sub(r'"\$\{(\w+)\[@\]\}"', lambda name: arrays[name[1]], test[1])
                arguments = []
                for word in shlex.split(written, comments=True):
                    if word in ("--", "||", "&&", "|", ";") or re.match(r"\d?>", word):
                        break
                    arguments.append(word)
                if "--doc" not in arguments:
                    yield where, arguments


def compiled(where, arguments):
    """(root file, features) of each test that a command compiles."""
    command = ["cargo", "test", *arguments, "--unit-graph", "-Zunstable-options"]
    told = subprocess.run(command, cwd=ROOT / where, env=ENVIRONMENT, capture_output=True, text=True)
    if told.returncode:
        sys.exit(f"{' '.join(command)}:\n{told.stderr}")
    for unit in json.loads(told.stdout)["units"]:
        if unit["mode"] == "test":
            yield unit["target"]["src_path"], frozenset(unit["features"])


def targets():
    """All targets of the tree that have tests, or may have: kind, root file, features that they require."""
    listed = subprocess.run(["git", "ls-files", "*Cargo.toml"], cwd=ROOT, capture_output=True, text=True, check=True)
    for name in listed.stdout.split():
        if "[workspace]" not in (ROOT / name).read_text() or name.startswith(ELSEWHERE):
            continue
        command = ["cargo", "metadata", "--no-deps", "--format-version", "1", "--manifest-path", name]
        told = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
        for package in json.loads(told.stdout)["packages"]:
            for target in package["targets"]:
                if target["test"]:
                    yield target["kind"][0], target["src_path"], target.get("required-features", [])


SPOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|\bb?r(#*)".*?"\1|b?"(?:\\.|[^"\\])*"|b?'(?:\\.[^']*|[^\\'])'""", re.S)


def code(text):
    """The text without comments and literals, of the same length; what attributes name is left."""

    def blank(found):
        named = re.search(r"(feature|path)\s*=\s*$", text[max(0, found.start() - 20) : found.start()])
        return found[0] if named else re.sub(r"[^\n]", " ", found[0])

    return SPOKEN.sub(blank, text)


def holds(condition, features):
    """Whether cfg(condition) may hold: True, False, or None for either."""
    words = re.findall(r'\w+|[(),=]|"[^"]*"', condition)

    def term():
        name = words.pop(0)
        if words[:1] == ["="]:
            words.pop(0)
            value = words.pop(0).strip('"')
            return value in features if name == "feature" else None
        if words[:1] != ["("]:
            return True if name == "test" else None
        words.pop(0)
        inner = []
        while words[0] != ")":
            if words[0] == ",":
                words.pop(0)
            else:
                inner.append(term())
        words.pop(0)
        if name == "not":
            return None if inner[0] is None else not inner[0]
        decides = name == "any"
        return decides if decides in inner else None if None in inner else not decides

    return term()


def conditions(attributes):
    """What stands in #[cfg(…)]."""
    found = (re.fullmatch(r"cfg\s*\((.*)\)", attribute.strip(), re.S) for attribute in attributes)
    return [each[1] for each in found if each]


def items(place, outer, tests, folder=None):
    """(place, line, conditions) of each item or statement behind a feature, in tests: those of a file and of its modules."""
    text = code(place.read_text())
    folder = folder or (place.parent if place.name in ("main.rs", "lib.rs", "mod.rs") else place.parent / place.stem)
    # Of each block: what it is behind, whether it is a test, where its modules are; and the attributes before it.
    scopes, waiting, begin = [(outer, tests, folder)], [], 0
    brackets = []
    for token in re.finditer(r"#(!?)\[|[{}()\[\];,]", text):
        at = token.start()
        if at < begin:
            continue
        mark, (behind, of_test, folder) = token[0], scopes[-1]
        if mark.startswith("#"):
            depth, end = 1, token.end()
            while depth:
                depth += {"[": 1, "]": -1}.get(text[end], 0)
                end += 1
            attribute = text[token.end() : end - 1]
            if token[1]:
                inner = conditions([attribute])
                scopes[-1] = (behind + inner, of_test, folder)
                if of_test and any("feature" in each for each in inner):
                    yield place, text.count("\n", 0, at) + 1, behind + inner
            else:
                waiting.append((attribute, at))
            begin = end
            continue
        if mark in "([":
            brackets.append(waiting)
            waiting = []
        elif mark in ")]":
            waiting = brackets.pop()
        elif mark == "}":
            scopes.pop()
            waiting = []
        else:
            attributes = [attribute for attribute, _ in waiting]
            own = conditions(attributes)
            all_of = behind + own
            test = of_test or "test" in own or any(re.fullmatch(r"(\w+::)*test", each) for each in attributes)
            if test and any("feature" in each for each in own):
                yield place, text.count("\n", 0, waiting[0][1]) + 1, all_of
            module = re.search(r"\bmod\s+(\w+)\s*$", text[begin:at])
            path = next((re.search(r'"(.*)"', each)[1] for each in attributes if re.match(r"path\b", each)), None)
            if mark == "{":
                inside = folder / (path or module[1]) if module else folder
                scopes.append((all_of, test, inside))
            elif module:
                # Beside the file itself, not in the folder of its modules, where a path is given and no block is around.
                near = (place.parent if len(scopes) == 1 else folder) / path if path else None
                choices = [near] if path else [folder / f"{module[1]}.rs", folder / module[1] / "mod.rs"]
                file = next((choice for choice in choices if choice.is_file()), None)
                if not file:
                    sys.exit(f"{place}: there is no file of the module {module[1]}")
                yield from items(file, all_of, test)
            waiting = []
        begin = max(begin, token.end())


def main():
    steps, known = list(commands()), {}
    for where, arguments in steps:
        for root, features in compiled(where, arguments):
            known.setdefault(root, set()).add(features)
    count, never = 0, set()
    for kind, root, required in targets():
        choices, file = known.get(root, set()), Path(root)
        if required and not choices:
            never.add((root, 1, f"it requires {', '.join(required)}"))
        for place, line, behind in items(file, [], kind == "test", file.parent):
            count += 1
            if not any(all(holds(each, features) is not False for each in behind) for features in choices):
                never.add((str(place), line, f"cfg({', '.join(behind)})"))
    for place, line, why in sorted(never):
        print(f"{os.path.relpath(place, ROOT)}:{line}: no step of {' or '.join(STEPS)} compiles it: {why}")
    if not count or not steps:
        sys.exit("no condition, or no step, was found: this script reads them wrongly")
    print(f"{count} parts of tests are behind features; {len(steps)} steps compile all but {len(never)}")
    sys.exit(bool(never))


main()
