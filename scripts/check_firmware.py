#!/usr/bin/env python3
"""Proofs about the machine code of the kernels for one target, and their sizes.

    python3 scripts/check_firmware.py TARGET libkernels.a IMAGE            # prints; exits 1 if a proof fails
    python3 scripts/check_firmware.py TARGET libkernels.a IMAGE --update   # writes the sizes that are checked, and the guide's
    python3 scripts/check_firmware.py --stack IMAGE FUNCTION…              # how deep functions of any image go, and by which calls

Needs ld.lld and the llvm tools (Debian packages lld and llvm). The library is tests/firmware/kernels. Its functions are
linked in groups, without libc, allocator or panic handler: what links cannot panic and does not allocate. Of each group:
bytes of code and the deepest stack, from the frames of the compiler and the calls in the machine code (a call that cannot be
followed, or a circle, is a failure), which must not grow over tests/firmware/sizes.txt, and of which the guide says the same;
calls of f64 arithmetic, of which there must be none, also not in IMAGE, that of the board.
"""

import bisect
import re
import subprocess
import sys
from pathlib import Path

FIRMWARE = Path(__file__).resolve().parent.parent / "tests/firmware"
SIZES, KERNELS = FIRMWARE / "sizes.txt", FIRMWARE / "kernels/src"
GUIDE = FIRMWARE.parent.parent / "src/guide/firmware.md"
# Half a per cent is what other versions of the compiler may differ by.
GROWTH = 1.005
# How the guide calls the targets, and the groups of its tables.
CALLED = {"thumbv7em-none-eabihf": "Cortex-M4F", "aarch64-unknown-none": "aarch64", "riscv32imac-unknown-none-elf": "rv32imac",
          "x86_64-unknown-linux-gnu": "x86-64"}
TABLES = (("forward", "core", "all", "robot"), ("follow", "ik", "arm"))
# Which functions, by the beginning of their names: see tests/firmware/kernels.
GROUPS = {"forward": ("forward_",), "core": ("forward_", "core_"), "all": ("forward_", "core_", "more_"),
          "clip": ("clip_",), "robot": ("robot_",), "follow": ("ik_follow",), "ik": ("ik_solve",), "arm": ("arm_",)}
# Looked at on this target alone.
ONLY = {"clip": "thumbv7em-none-eabihf"}
CLIP = (ONLY["clip"], "clip")
EMULATION = {
    "thumbv7em-none-eabihf": "armelf",
    "aarch64-unknown-none": "aarch64elf",
    "riscv32imac-unknown-none-elf": "elf32lriscv",
    "x86_64-unknown-linux-gnu": "elf_x86_64",
}
# At most, by target and group: (bytes of code, bytes of stack). These numbers only fall.
LIMITS = {
    ("thumbv7em-none-eabihf", "forward"): (4096, 512),
    ("thumbv7em-none-eabihf", "core"): (4096, 512),
    ("thumbv7em-none-eabihf", "follow"): (49152, 5120),
    ("thumbv7em-none-eabihf", "ik"): (57344, 5120),
    ("thumbv7em-none-eabihf", "arm"): (59392, 5120),
}
# Arithmetic in double precision where it is a library call: Arm's names, and those of libgcc.
DOUBLE = re.compile(r"__aeabi_(d\w+|\w+2d)$|__\w+df[23s]\w*$|__\w+df$")
# What an image may do with them, and kernels that make a mechanism: name the number for which it was refused.
WIDEN = {"__aeabi_f2d", "__extendsfdf2"}
MAKES_MECHANISM = ("follow", "ik", "arm")
PANIC = re.compile(r"panic|unwrap_failed|slice_\w*fail|something_can")
CALL = re.compile(r"\t(?:bl|blx|b|b\.w|call|callq|jmp|jal|j|tail|jalr|blr|br)\b\s+(.*)")

# What the code of the core must contain: an FPU is there to be used.
MUST_HAVE = {"thumbv7em-none-eabihf": "vsqrt.f32"}
BY_REGISTER = re.compile(r"\t(blx|blr|call\w*|jalr)\s+(\*|%?[rx]\d|[ast]\d)")


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def link(target, library, roots, out):
    keep = [argument for root in roots for argument in ("-u", root)]
    command = ["ld.lld", "-m", EMULATION[target], "--gc-sections", "-e", "0", *keep, library, "-o", out]
    return subprocess.run(command, capture_output=True, text=True)


def text_size(image):
    lines = (line.split() for line in run("llvm-size", "-A", image).splitlines())
    return sum(int(line[1]) for line in lines if line and line[0] == ".text")


def functions(image):
    """The names of each function, by address: equal functions are one, of several names."""
    names = {}
    for address, kind, name in re.findall(r"^([0-9a-f]+) (\w) (\S+)$", run("llvm-nm", image), re.M):
        if kind in "tTwW" and not name.startswith("$"):
            # The lowest bit of Arm's addresses says Thumb.
            names.setdefault(int(address, 16) & ~1, []).append(name)
    return names


def frames(image):
    """Bytes of stack of each function, without what it calls."""
    lines = run("llvm-readelf", "--stack-sizes", image).splitlines()
    found = [m for line in lines if (m := re.match(r"\s+(\d+)\s+(\S.*)$", line))]
    return {name: int(m[1]) for m in found for name in m[2].split(", ")}


def calls(image):
    """The functions that each function calls or jumps to; None for a call that names none.

    By address: names of jumps within a function may be those of anything near.
    """
    listing = run("llvm-objdump", "-d", "--no-show-raw-insn", image).splitlines()
    heads = (re.match(r"([0-9a-f]+) <(.*)>:$", line) for line in listing)
    # Symbols that mark code and data among instructions are no functions.
    starts = {int(head[1], 16): head[2] for head in heads if head and not head[2].startswith("$")}
    addresses = sorted(starts)
    graph, inside = {name: set() for name in starts.values()}, None
    for line in listing:
        if head := re.match(r"([0-9a-f]+) <(.*)>:$", line):
            inside = starts.get(int(head[1], 16), inside)
        elif call := CALL.search(line):
            if where := re.search(r"(?:0x)?([0-9a-f]+) <([^>]+)>", call[1]):
                before = bisect.bisect_right(addresses, int(where[1], 16)) - 1
                name = starts[addresses[before]] if before >= 0 else None
                if name != inside or int(where[1], 16) == addresses[before]:
                    graph[inside].add(name)
            elif BY_REGISTER.search(line):
                graph[inside].add(None)
    return graph


class Stack:
    """How deep functions of an image go."""

    def __init__(self, image):
        self.graph, own = calls(image), frames(image)
        self.name, self.own, self.known = {}, {}, {}
        for aliases in functions(image).values():
            known = [name for name in aliases if name in self.graph]
            sizes = [own[name] for name in aliases if name in own]
            for name in aliases:
                if known:
                    self.name[name] = known[0]
                if sizes:
                    self.own[name] = max(sizes)

    def deepest(self, function):
        return self.way(function)[0]

    def way(self, function, above=()):
        """Bytes, and the functions on the way down, each with its own."""
        name = self.name.get(function)
        if name is None or name not in self.own:
            raise SystemExit(f"{' > '.join((*above, str(function)))}: a call that cannot be followed")
        if name in above:
            raise SystemExit(f"{' > '.join((*above, name))}: a circle, so the stack has no bound")
        if name not in self.known:
            below = (self.way(to, (*above, name)) for to in self.graph[name])
            bytes_below, calls_below = max(below, key=lambda way: way[0], default=(0, []))
            self.known[name] = self.own[name] + bytes_below, [(name, self.own[name]), *calls_below]
        return self.known[name]


def unwanted(image):
    """Symbols that say that something can panic or computes in f64."""
    names = run("llvm-nm", image).split()
    return {
        "panics": [name for name in names if PANIC.search(name)],
        "double": [name for name in names if DOUBLE.match(name)],
    }


def examine(target, library, group):
    sources = "".join(path.read_text() for path in sorted(KERNELS.glob("*.rs")))
    roots = [name for name in re.findall(r"^fn (\w+)", sources, re.M) if name.startswith(GROUPS[group])]
    image = str(Path(library).with_name(f"kernels-{group}.elf"))
    linked = link(target, library, roots, image)
    if linked.returncode:
        culprits = [root for root in roots if link(target, library, [root], image).returncode]
        print(linked.stderr, file=sys.stderr)
        raise SystemExit(f"{target}: can panic or needs what is not there: {', '.join(culprits)}")
    stack = Stack(image)
    return {
        "text": text_size(image),
        "stack": max(stack.deepest(root) for root in roots),
        "has": MUST_HAVE.get(target, "") in run("llvm-objdump", "-d", image),
        **unwanted(image),
    }


def committed():
    lines = (line.split() for line in SIZES.read_text().splitlines() if not line.startswith("#"))
    return {(target, group): tuple(map(int, numbers)) for target, group, *numbers in lines}


def replaced(pattern, by, text):
    text, count = re.subn(pattern, by, text, flags=re.M)
    if count != 1:
        raise SystemExit(f"{GUIDE.name} has {count} places with {pattern}, not one")
    return text


def guide_with(sizes):
    """The guide with these sizes in its tables and its sentence on clips."""
    text = GUIDE.read_text()
    for target, name in CALLED.items():
        for groups in TABLES:
            known = [sizes[target, group] for group in groups if len(sizes.get((target, group), ())) == 2]
            if len(known) == len(groups):
                cells = [f" {code} ({stack}) |" for code, stack in known]
                old = r"( \d+ \(\d+\) \|){%d}$" % len(groups)
                text = replaced(rf"^(\| {name}[^|]*\|){old}", rf"\g<1>{''.join(cells)}", text)
    code, stack = sizes[CLIP]
    return replaced(r"takes \d+ bytes, with \d+ bytes of stack", f"takes {code} bytes, with {stack} bytes of stack", text)


def tell_stack(image, entries):
    stack = Stack(image)
    for entry in entries:
        total, way = stack.way(entry)
        print(f"{total:6} bytes below {entry}:", *(f"{own:12} {name}" for name, own in way), sep="\n")


def main():
    if sys.argv[1] == "--stack":
        return tell_stack(sys.argv[2], sys.argv[3:])
    target, library, image = sys.argv[1:4]
    sizes, failures = committed() if SIZES.exists() else {}, []
    for group in GROUPS:
        if ONLY.get(group, target) != target:
            continue
        found = examine(target, library, group)
        most_text, most_stack = LIMITS.get((target, group), (None, None))
        now, before = (found["text"], found["stack"]), sizes.get((target, group))
        if "--update" in sys.argv:
            sizes[target, group] = now
        elif before is None:
            failures.append(f"{group}: no size in {SIZES.name}; --update writes it")
        else:
            for what, is_now, was in zip(("code", "stack"), now, before, strict=True):
                if is_now > was * GROWTH:
                    failures.append(f"{group}: {is_now} bytes of {what}, {was} before")
        if most_text and found["text"] > most_text:
            failures.append(f"{group}: {found['text']} bytes of code, at most {most_text}")
        if most_stack and found["stack"] > most_stack:
            failures.append(f"{group}: {found['stack']} bytes of stack, at most {most_stack}")
        if group not in ("forward", "clip") and target in MUST_HAVE and not found["has"]:
            failures.append(f"{group}: no {MUST_HAVE[target]}")
        widen = WIDEN if group in MAKES_MECHANISM else set()
        failures += [f"{group}: {name}" for name in found["panics"] + found["double"] if name not in widen]
        print(f"{target:30} {group:8} {found['text']:7} bytes of code {found['stack']:6} of stack, "
              f"{len(found['panics'])} panic symbols, {len(found['double'])} f64 calls")  # fmt: skip
    names = {name for names in unwanted(image).values() for name in names} - WIDEN
    failures += [f"{Path(image).name}: {name}" for name in sorted(names)]
    if "--update" in sys.argv:
        head = "# Target, group, bytes of code and of stack. Written by scripts/check_firmware.py --update.\n"
        lines = (" ".join(map(str, (*key, *numbers))) + "\n" for key, numbers in sorted(sizes.items()))
        SIZES.write_text(head + "".join(lines))
        GUIDE.write_text(guide_with(sizes))
    elif guide_with(sizes) != GUIDE.read_text():
        failures.append(f"{GUIDE.name} has other sizes than {SIZES.name}; --update writes them")
    if failures:
        raise SystemExit("\n".join(f"{target}: {failure}" for failure in failures))


if __name__ == "__main__":
    main()
