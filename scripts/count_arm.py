#!/usr/bin/env python3
"""Counts instructions on AArch64, and models cycles, without such a machine: QEMU counts, llvm-mca models.

    python3 scripts/count_arm.py                    # a table of all rows
    python3 scripts/count_arm.py product skin       # of these
    python3 scripts/count_arm.py --no-cycles …      # counts alone: seconds
    python3 scripts/count_arm.py --check            # no count of dq8's is above that of the file by more than 2 %
    python3 scripts/count_arm.py --update           # writes the file, and the table of docs/results.md

`benches/counts` is built as a user builds it, for aarch64-unknown-linux-gnu, by Debian's compiler with a standard
library from source. A plugin of QEMU counts what is executed in eight passes over the data and in one; a seventh of
the difference is a pass. From the longer run windows of instructions are taken as they were executed, across
loops and calls, and llvm-mca says how many cycles each CPU takes for them. It takes loads for hits in the first cache
that wait for no store, and branches for foreseen.

The file is `benches/counts/aarch64.tsv`. All that is missing is installed from Debian.
"""

import argparse
import array
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COUNTS = ROOT / "benches/counts"
FILE = COUNTS / "aarch64.tsv"
PAGE = ROOT / "docs/results.md"
TARGET = "aarch64-unknown-linux-gnu"
# LLVM has a table of its own for the first three, of which it takes the third for the Cortex-A76, too; Apple's cores have
# one in common, that of the first of them.
CPUS = {"N1": "neoverse-n1", "V2": "neoverse-v2", "A57": "cortex-a57", "M1": "apple-m1"}
# Passes that the long run has more than the short one: `PASSES` of the program.
PASSES = 7
# A count may grow by so much.
LOSS = 1.02
# A pass with no more instructions is modelled as a whole; of a longer one, so many windows of so many instructions.
WHOLE, WINDOWS, WINDOW = 20_000, 7, 3_000
# Quick passes are repeated until there is as much.
ENOUGH = 6_000
NEEDS = [
    "/usr/bin/rustc=rustc-web", "/usr/bin/cargo=cargo-web", "/usr/lib/rustlib/src/rust/library=rust-web-src",
    "/usr/bin/qemu-aarch64=qemu-user", "/usr/bin/aarch64-linux-gnu-gcc=gcc-aarch64-linux-gnu",
    "/usr/aarch64-linux-gnu/lib/libc.so.6=libc6-dev-arm64-cross",
]
NEEDS_OF_CYCLES = ["/usr/bin/llvm-mca-22=llvm-22"]
# The rows of docs/results.md: the row, its name there, dq8's contenders, and the peers' of which the best counts.
PAGE_ROWS = [
    ("product", "pairwise product, plain", r"dq8 AoS", r"glam"),
    ("product", "pairwise product, blocks", r"dq8 (8|16) lanes", r"glam"),
    ("crowd in place", "64 skeletons of 64 joints in place, plain", r"dq8 AoS", r"glam"),
    ("crowd in place", "the same, blocks", r"dq8 (8|16) lanes", r"glam"),
    ("skeleton of 64", "one skeleton of 64, planned", r"dq8 plan", r"glam"),
    ("chain of 1000", "one chain of 1000, planned", r"dq8 plan", r"glam"),
    ("points by one motion", "points by one motion, plain", r"dq8 AoS", r"glam"),
    ("points each", "points, each by its own motion, plain", r"dq8 AoS", r"glam"),
    ("points each", "the same, blocks", r"dq8 (8|16) lanes", r"glam"),
    ("NLERP", "NLERP, plain", r"dq8 AoS", r"glam"),
    ("ScLERP", "ScLERP, plain (glam: slerp and lerp)", r"dq8 AoS", r"glam"),
    ("animated crowd", "animated crowd to 3×4 matrices, plain", r"dq8 rotations and translations, AoS", r"glam"),
    ("skin", "skin, linear blend", r"dq8 LBS", r"glam"),
    ("skin", "skin, dual quaternion blend (glam: linear)", r"dq8 DLB p", r"glam"),
    ("arm of 7", "arm of 7 axes, many configurations (nalgebra's `Isometry3`)", r"dq8 all poses, plain$", r"nalgebra Iso"),
    ("arm of 7", "the same, one configuration at a time", r"dq8 all poses, one by one", r"nalgebra Iso"),
]
HEAD = "| dq8 and the best of glam's types, per transform | instructions | " + " | ".join(
    f"cycles, {cpu}" for cpu in CPUS) + " |"


def run(*command, **options):
    return subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE, **options).stdout


def build():
    """The program and the plugin."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", COUNTS / "target"))
    environment = {name: value for name, value in os.environ.items() if not name.startswith("CARGO_PROFILE_")} | {
        "RUSTC": "/usr/bin/rustc", "RUSTC_BOOTSTRAP": "1", "CARGO_TARGET_DIR": str(target),
        "CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER": "aarch64-linux-gnu-gcc",
        # With the library of C in it, at addresses that are known: what is executed is in one file.
        "RUSTFLAGS": "-Ctarget-feature=+crt-static -Crelocation-model=static",
    }
    subprocess.run(["/usr/bin/cargo", "build", "--quiet", "--release", "-Zbuild-std", "--target", TARGET,
                    "--manifest-path", COUNTS / "Cargo.toml"], check=True, env=environment)
    plugin = target / "counter.so"
    emulator = int(re.search(rb"version (\d+)", run("qemu-aarch64", "--version"))[1])
    run("cc", "-shared", "-fPIC", "-O2", "-Wall", f"-DVERSION={2 if emulator >= 9 else 1}", "-o", plugin, COUNTS / "counter.c")
    return target / TARGET / "release/counts", plugin


def contenders(program, plugin, row):
    """Of each who does the job: the name, transforms of a pass, instructions of a pass, and the blocks of the long run."""
    symbols = run("aarch64-linux-gnu-nm", program).decode()
    mark, = (line.split()[0] for line in symbols.splitlines() if re.search(r" t \S*6counts4mark", line, re.IGNORECASE))
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "counted"
        lines = run("qemu-aarch64", "-plugin", f"{plugin},mark=0x{mark},out={out}", program, row).decode().splitlines()
        words = array.array("Q", out.read_bytes())
    at = 0
    for line in lines:
        name, transforms = line.split("\t")
        shorter, longer, blocks = words[at:at + 3]
        yield name, int(transforms), (longer - shorter) / PASSES, words[at + 3:at + 3 + blocks]
        at += 3 + blocks
    assert at == len(words), f"{row}: not a record for each line"


def windows(blocks, a_pass):
    """Addresses of instructions as they were executed, from the middle of the long run on."""
    if a_pass <= WHOLE:
        lengths, starts = round(a_pass) * -(-ENOUGH // round(a_pass)), [0.0]
    else:
        lengths, starts = WINDOW, [number / WINDOWS for number in range(WINDOWS)]
    total = sum(block >> 48 for block in blocks)
    begin = (total - max(lengths, a_pass)) / 2
    starts = [int(begin + a_pass * start) for start in starts]
    found, passed, wanted = [[] for _ in starts], 0, 0
    for block in blocks:
        address, count = block & 0xffff_ffff_ffff, block >> 48
        while wanted < len(starts) and passed + count > starts[wanted] + lengths:
            wanted += 1
        if wanted == len(starts):
            break
        if passed >= starts[wanted]:
            found[wanted].extend(range(address, address + 4 * count, 4))
        passed += count
    return [window for window in found if window]


class Model:
    """What llvm-mca says of sequences of the program's instructions."""

    def __init__(self, program):
        self.text = {}
        for line in run("llvm-objdump-22", "-d", "--no-show-raw-insn", program).decode().splitlines():
            if match := re.match(r"\s*([0-9a-f]+):\s+(.*)", line):
                # Where a branch goes is of no interest: the next instruction is the one that was executed.
                text = re.sub(r"\s*(<.*>|//.*)$", "", match[2])
                self.text[int(match[1], 16)] = re.sub(r"^((?:b|bl|cbn?z|tbn?z|b\.\w+)\s.*?)0x[0-9a-f]+$", r"\1.", text)

    def cycles(self, cpu, addresses):
        code = "".join(self.text[address] + "\n" for address in addresses)
        told = run("llvm-mca-22", "-mtriple=aarch64", f"-mcpu={cpu}", "-iterations=1", "-all-views=false", "-summary-view",
                   input=code.encode(), stderr=subprocess.DEVNULL)
        return int(re.search(rb"Total Cycles:\s+(\d+)", told)[1])


def measure(rows, with_cycles):
    """The table: from row and contender to instructions and cycles a transform."""
    needs = NEEDS + (NEEDS_OF_CYCLES if with_cycles else [])
    subprocess.run([ROOT / "scripts/install_missing.sh", *needs], check=True)
    program, plugin = build()
    model = Model(program) if with_cycles else None
    table = {}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for row in rows or run("qemu-aarch64", program).decode().splitlines():
            for name, transforms, a_pass, blocks in contenders(program, plugin, row):
                numbers = [a_pass / transforms]
                if model:
                    parts = windows(blocks, a_pass)
                    tasks = [pool.submit(model.cycles, cpu, part) for cpu in CPUS.values() for part in parts]
                    each = len(parts)
                    sums = [sum(task.result() for task in tasks[at:at + each]) for at in range(0, len(tasks), each)]
                    numbers += [cycles / sum(map(len, parts)) * numbers[0] for cycles in sums]
                table[row, name] = numbers
                print(f"{row:22} {name:45}" + "".join(f"{number:9.2f}" for number in numbers), flush=True)
    return table


def compiler():
    return re.search(rb"release: (\S+)", run("/usr/bin/rustc", "-vV"))[1].decode()


def read():
    lines = [line for line in FILE.read_text().splitlines() if not line.startswith("#")]
    return {tuple(fields[:2]): [float(field) for field in fields[2:]] for fields in (line.split("\t") for line in lines[1:])}


def write(table):
    lines = [
        "# By scripts/count_arm.py --update: instructions a transform, counted, and cycles, modelled by llvm-mca 22.",
        f"# rustc {compiler()}", "\t".join(["row", "contender", "instructions", *CPUS]),
    ]
    lines += ["\t".join([*key, *(f"{number:.2f}" for number in numbers)]) for key, numbers in table.items()]
    FILE.write_text("\n".join(lines) + "\n")


def page(table):
    """The rows of the page: dq8's best and the peer's, with their ratio."""
    lines = [HEAD, "|---" * (2 + len(CPUS)) + "|"]
    for row, name, own, peer in PAGE_ROWS:
        best = [[min(column) for column in zip(*(numbers for (of, who), numbers in table.items()
                 if of == row and re.match(pattern, who)))] for pattern in (own, peer)]
        cells = (f"{a:.1f} : {b:.1f} = {'**' if a <= b else ''}{a / b:.2f}{'**' if a <= b else ''}" for a, b in zip(*best))
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def update_page(table):
    text = PAGE.read_text()
    start = text.index(HEAD)
    end = text.index("\n\n", start)
    PAGE.write_text(text[:start] + page(table) + text[end:])


def check(table):
    """What is wrong with counts, by the file."""
    before, wrong = read(), []
    for key, (count, *_) in table.items():
        if key not in before:
            wrong.append(f"{': '.join(key)}: not in the file")
        elif key[1].startswith("dq8 ") and count > LOSS * before[key][0]:
            wrong.append(f"{': '.join(key)}: {count:.2f} instructions, {before[key][0]:.2f} in the file")
    wrong += [f"{': '.join(key)}: in the file alone" for key in before if key not in table]
    if page(before) not in PAGE.read_text():
        wrong.append(f"{PAGE.relative_to(ROOT)} has other numbers than the file")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", nargs="*")
    parser.add_argument("--no-cycles", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    if arguments.rows and (arguments.check or arguments.update):
        parser.error("the file is of all rows")
    table = measure(arguments.rows, with_cycles=not (arguments.no_cycles or arguments.check))
    if arguments.update:
        write(table)
        # As the file has the numbers, rounded.
        update_page(read())
    if arguments.check:
        wrong = check(table)
        print("\n".join(wrong) or f"{len(table)} counts are as in {FILE.relative_to(ROOT)}")
        sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
