#!/usr/bin/env python3
"""What the compiler says of each mistake in tests/mistakes/lib.rs must hold the words above it."""

import json
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).parent.parent
source = root / "tests/mistakes/lib.rs"

# Each program: its words, and the lines that it is on.
programs, words = [], []
for number, line in enumerate(source.read_text().splitlines(), 1):
    if found := re.match(r"/// SAYS: (.*)", line):
        words.append(found[1])
    elif found := re.match(r"pub fn (\w+)", line):
        programs.append((found[1], words, number))
        words = []

check = ["cargo", "rustc", "--quiet", "--package", "dq8-mistakes", "--profile", "check", "--message-format", "json", "--", "--cfg", "mistakes"]
output = subprocess.run(check, cwd=root, capture_output=True, text=True)
said = [""] * len(programs)
for line in output.stdout.splitlines():
    message = json.loads(line).get("message")
    for span in message["spans"] if message else []:
        inside = [index for index, (*_, first) in enumerate(programs) if first <= span["line_start"]]
        if inside and span["is_primary"] and span["file_name"].endswith("mistakes/lib.rs"):
            said[inside[-1]] += message["rendered"]

faults = [
    f"{name} is not told: {wanted}\n{text or output.stderr}"
    for (name, words, _), text in zip(programs, said)
    for wanted in words or ["anything"]
    if wanted not in text
]
print("\n".join(faults) or f"{len(programs)} mistakes are told in words of dq8")
sys.exit(bool(faults))
