#!/usr/bin/env python3
"""Comments as code: at most 100 columns wide, and docs that open with what is documented.

    scripts/comments.py           fails for a line that is wider, or a package whose docs open too often with a clause
    scripts/comments.py --wrap    wraps the paragraphs that are wider (rustfmt does so on nightly alone)
"""

import pathlib
import re
import subprocess
import sys

WIDTH = 100
# The share of doc blocks that may open with "What it does" in place of "The product", and where it is counted.
CLAUSE = re.compile(r"(How|What|Whether|Where|Which|When)\b")
SHARE = {"src": 0.04, "simd": 0.04, "robot": 0.04, "capi": 0.04, "trajectory": 0.04, "retarget": 0.04}

COMMENT = re.compile(r"^( *)(//[/!]?)( ?)(.*)$")
# Words, but what stands in backquotes stays on one line.
WORD = re.compile(r"(?:`[^`]*`|\S)+")
# A line that begins so is not a line of a paragraph of Markdown; a wrapped one must not begin so.
MARKUP = re.compile(r"\||#|>|<|\[[^\]]+\]: \S+$|    ")
ITEM = re.compile(r"([-*+]|\d+[.)]) +")
# What stands under the heading of a section in the docstrings of Python, whose lines are indented and no code.
SECTION = re.compile("-{3,}")


def wide(line):
    return len(line.encode()) > WIDTH


def blocks(lines):
    """Runs of comment lines with one indentation and one marker, and everything else line by line."""
    run, key = [], None
    for line in lines:
        comment = COMMENT.match(line)
        this = comment and comment.group(1, 2)
        if run and this != key:
            yield key, run
            run = []
        key = this
        if this:
            run.append(comment[4])
        else:
            yield None, [line]
    if run:
        yield key, run


def margin(text):
    return len(text) - len(text.lstrip())


def wrapped(prefix, first, rest, words):
    """Lines of at most WIDTH bytes: the first after `first`, the others after `rest`."""
    lines = [[]]
    for word in words:
        before = first if len(lines) == 1 else rest
        if lines[-1] and wide(prefix + before + " ".join([*lines[-1], word])):
            # What would be markup at the start of a line takes the word before it along.
            marks = MARKUP.match(word + " ") or ITEM.fullmatch(word + " ") or word in "+-=*"
            lines.append([lines[-1].pop()] if marks and len(lines[-1]) > 1 else [])
        lines[-1].append(word)
    return [(rest if index else first) + " ".join(line) for index, line in enumerate(lines)]


def wrap(key, texts):
    indent, marker = key
    prefix = f"{indent}{marker} "
    out, paragraph, fenced = [], [], False
    sections = any(map(SECTION.fullmatch, texts))

    def flush():
        if paragraph:
            if any(wide(prefix + text) for text in paragraph):
                item = ITEM.match(paragraph[0].lstrip())
                first = " " * margin(paragraph[0]) + (item[0] if item else "")
                text = " ".join([paragraph[0][len(first):], *paragraph[1:]])
                out.extend(wrapped(prefix, first, " " * len(first), WORD.findall(text)))
            else:
                out.extend(paragraph)
            paragraph.clear()

    for text in texts:
        if text.startswith("```"):
            flush()
            fenced = not fenced
            out.append(text)
        elif SECTION.fullmatch(text) and paragraph:
            heading = paragraph.pop()
            flush()
            out += [heading, text]
        elif fenced or not text.strip() or (MARKUP.match(text) and not paragraph and not sections) or text.startswith(("|", "#", ">")):
            flush()
            out.append(text)
        else:
            if ITEM.match(text.lstrip()) or sections and paragraph and margin(text) != margin(paragraph[-1]):
                flush()
            paragraph.append(text)
    flush()
    return [(prefix + text).rstrip() for text in out]


def main():
    root = pathlib.Path(__file__).parent.parent
    tracked = subprocess.run(["git", "ls-files", "*.rs"], cwd=root, capture_output=True, text=True, check=True).stdout
    faults, opened, docs = [], dict.fromkeys(SHARE, 0), dict.fromkeys(SHARE, 0)
    for name in tracked.split("\n"):
        path = root / name
        if not name or not path.exists():
            continue
        lines = path.read_text().split("\n")
        if "--wrap" in sys.argv:
            lines = [line for key, block in blocks(lines) for line in (wrap(key, block) if key else block)]
            path.write_text("\n".join(lines))
        package, before = name.split("/")[0], ""
        for number, line in enumerate(lines, 1):
            comment = COMMENT.match(line)
            if comment and wide(line):
                faults.append(f"{name}:{number}: a comment of {len(line.encode())} columns")
            if comment and comment[2] != "//" and package in SHARE and not COMMENT.match(before):
                docs[package] += 1
                opened[package] += bool(CLAUSE.match(comment[4]))
            before = line
    for package, share in SHARE.items():
        print(f"{package}: {opened[package]} of {docs[package]} docs open with a clause ({opened[package] / docs[package]:.1%})")
        if opened[package] > share * docs[package]:
            faults.append(f"{package}: at most {share:.0%} of the docs may open with How, What, Whether, Where, Which or When")
    print("\n".join(faults))
    sys.exit(bool(faults))


main()
