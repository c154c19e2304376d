#!/usr/bin/env python3
"""Looks at the machine code of the hot kernels, in a default build for x86-64.

    python3 scripts/check_assembly.py         # needs cargo and objdump (Debian package binutils)

A kernel that is not inlined into its instruction set still gives the right numbers, 35 times slower. So the
innermost loop of each must multiply and add in whole registers of its backend, must call nothing, and must keep
off the stack where there are but 16 registers (AVX2). Of each there is a version more, for `Backend::reproducible()`, which
must hold no fused instruction at all. Prints a line a kernel; exits 1 if one is not as it should be or is missing.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# What the kernel is called here; what names it in its symbol; how often its AVX2 loop may touch the stack. A crowd
# in place keeps all eight results until it has loaded everything, for they go where it loads from: one does not fit.
# ScLERP has more constants than there are registers.
BLOCKS = r"\[f32; {lanes}"
KERNELS = [
    ("pairwise product", r"sweep::Sweep<.*of_each::mul.*" + BLOCKS, 0),
    ("points by one motion", r"sweep::Sweep<.*slices::transform::ByOne.*" + BLOCKS, 0),
    ("normalize", r"sweep::Sweep<.*of_each::normalize.*" + BLOCKS, 0),
    ("ScLERP", r"sweep::Sweep<.*of_each::sclerp\b.*" + BLOCKS, None),
    ("crowd in place", r"blocks::Blocks.*" + BLOCKS, 4),
    ("one instance, planned", r"plan::InOrder<f32>", 0),
    ("plain clips", r"<dq8::hierarchy::clip::Sampled<[^{]*Frames[^{]*::load_batch", 100),
    ("packed clips", r"<dq8::hierarchy::clip::Sampled<[^{]*Playback[^{]*::load_batch", 100),
]
BACKENDS = [("AVX2", "with_avx2", (8, 16)), ("AVX-512", "with_avx512", (8, 16))]
# What else a loop must hold, and must not, by kernel and backend; docs/measured.md has the reasons.
MUST = {
    ("crowd in place", "AVX-512"): r"\tprefetcht0",
    ("one instance, planned", "AVX-512"): r"\tvperm[it]2ps",
}
MUST_NOT = {
    ("one instance, planned", "AVX-512"): r"\(%r\w+,%r.*\{1to8\}",
    # Where rows begin, stored for as many lanes as there are frames: who reads it back waits for memory.
    ("plain clips", "AVX2"): r"\tvp?maskmov[dqp]",
    # Addresses of eight lanes that are added up in vectors and taken apart again.
    ("packed clips", "AVX2"): r"\tvpextr[dq]|\tvpmuludq",
}
# Looked at as a whole, on AVX2: one loop for lanes that are instances and one for joints, and calls for what is rare.
WHOLE = {"plain clips", "packed clips"}
# How often an instruction stands there. Of packed clips: once for each number of a rotation and a translation, in either loop.
COUNTS = {("packed clips", "AVX2"): (r"\tvpmaddwd", 14)}
FUSED = re.compile(r"\tvfn?m(add|sub)\d+ps\b")
APART = re.compile(r"\tvmulps\b")


def build():
    """The program, with symbols that spell out generic arguments, and its disassembly by function."""
    target = ROOT / "target/assembly"
    environment = {
        **os.environ,
        "RUSTFLAGS": "-C symbol-mangling-version=v0",
        "CARGO_TARGET_DIR": str(target),
        "CARGO_PROFILE_RELEASE_STRIP": "none",
    }
    command = ["cargo", "build", "--quiet", "--release", "-p", "dq8-assembly", "--features", "dq8/reproducible"]
    subprocess.run(command, cwd=ROOT, env=environment, check=True)
    command = ["objdump", "-d", "--no-show-raw-insn", "--demangle=rust", target / "release/dq8-assembly"]
    listing = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    functions, body = {}, []
    for line in listing.splitlines():
        if head := re.match(r"^[0-9a-f]+ <(.*)>:$", line):
            body = functions.setdefault(head[1], [])
        elif instruction := re.match(r"^ *([0-9a-f]+):(\t.*)$", line):
            body.append((int(instruction[1], 16), instruction[2]))
    return functions


def hot_loop(body, multiplies=FUSED):
    """Of the innermost loops the one that multiplies most."""
    loops = []
    for end, (_, text) in enumerate(body):
        if jump := re.match(r"\tj\w+ +([0-9a-f]+) ", text):
            to = int(jump[1], 16)
            start = next((i for i, (address, _) in enumerate(body) if address == to), None)
            if start is not None and start <= end:
                loops.append((start, end))
    inner = [a for a in loops if not any(b != a and a[0] <= b[0] and b[1] <= a[1] for b in loops)]
    texts = [[text for _, text in body[start : end + 1]] for start, end in inner]
    return max(texts, key=lambda loop: sum(bool(multiplies.search(text)) for text in loop), default=[])


def looked_at(kernel, bodies, multiplies=FUSED):
    """The longest hot loop of some functions, or the longest of them whole."""
    whole = ([text for _, text in body] for body in bodies)
    loops = whole if kernel in WHOLE else (hot_loop(body, multiplies) for body in bodies)
    return max(loops, key=len, default=[])


def main():
    functions, failures = build(), 0
    print(f"{'kernel':22}{'backend':9}{'lanes':>6}{'fused':>7}{'calls':>7}{'spills':>8}")
    for kernel, symbol, most_spills in KERNELS:
        for backend, level, widths in BACKENDS:
            if kernel in WHOLE and backend != "AVX2":
                continue
            # What is no block is one motion: eight lanes.
            for lanes in widths if BLOCKS in symbol else widths[:1]:
                register = "zmm" if level == "with_avx512" and lanes == 16 else "ymm"
                wanted = re.compile(level + ".*" + symbol.replace("{lanes}", str(lanes)))
                bodies = [body for name, body in functions.items() if wanted.search(name)]
                fusing = [body for body in bodies if any(FUSED.search(text) for _, text in body)]
                apart = [body for body in bodies if body not in fusing]
                loop = looked_at(kernel, fusing)
                fused = sum(bool(FUSED.search(text)) and register in text for text in loop)
                calls = 0 if kernel in WHOLE else sum("\tcall" in text for text in loop)
                spills = sum("mm" in text and ("(%rsp" in text or "(%rbp" in text) for text in loop)
                spilling = backend == "AVX2" and most_spills is not None and spills > most_spills
                must, must_not = MUST.get((kernel, backend), ""), MUST_NOT.get((kernel, backend), "$^")
                lacking = not any(re.search(must, text) for text in loop)
                unwanted = any(re.search(must_not, text) for text in loop)
                counted, wanted_count = COUNTS.get((kernel, backend), ("$^", 0))
                miscounted = sum(bool(re.search(counted, text)) for text in loop) != wanted_count
                bad = not fused or calls or spilling or lacking or unwanted or miscounted
                failures += bool(bad)
                mark = "  <-- not as it should be" if bad else ""
                print(f"{kernel:22}{backend:9}{lanes:6}{fused:7}{calls:7}{spills:8}{mark}")
                loop = looked_at(kernel, apart, APART)
                products = sum(bool(APART.search(text)) and register in text for text in loop)
                calls = 0 if kernel in WHOLE else sum("\tcall" in text for text in loop)
                failures += bool(not products or calls)
                mark = "  <-- not as it should be" if not products or calls else ""
                print(f"{'  unfused':22}{backend:9}{lanes:6}{0:7}{calls:7}{products:8} products{mark}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
