#!/usr/bin/env python3
"""What firmware must compute -> tests/firmware/jobs/src/answers.rs.

    pip install mpmath                             # the only dependency
    python3 scripts/firmware_answers.py            # writes the file
    python3 scripts/firmware_answers.py --check    # exit 1 if the committed file differs

Inputs are binary32 numbers, answers are computed from them with 60 digits and rounded once. The skeleton is that of
examples/mocap/biped.rs, read from there; its pose and the arm's are invented here. Single operations are rows of
tests/vectors/reference.jsonl.
"""

import json
import re
import struct
import sys
from pathlib import Path

from mpmath import mp, mpf

ROOT = Path(__file__).resolve().parent.parent
OUT = ROOT / "tests/firmware/jobs/src/answers.rs"
BIPED = ROOT / "examples/mocap/biped.rs"
VECTORS = ROOT / "tests/vectors/reference.jsonl"
# Rows of the vectors, by operation and kind; each is a case that firmware meets.
ROWS = {
    "MUL": ("mul", [("general", 4), ("plain", 2), ("far", 2)], ["a", "b"]),
    "NORMALIZE": ("normalize", [("general", 4), ("scaled", 4)], ["a"]),
    "POINT": ("point", [("plain", 4), ("near0", 2), ("far", 2)], ["a", "v"]),
    "SCLERP": ("sclerp", [("plain", 4), ("close", 2), ("translation", 2)], ["a", "b", "t"]),
}
# Six axes in the proportions of a UR5 (Universal Robots): turns about these, at these places in their parents.
ARM_AXES = [[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 0, 1], [0, 1, 0]]
ARM_OFFSETS = [
    ["0", "0", "0.089159"], ["0", "0.13585", "0"], ["0", "-0.1197", "0.425"],
    ["0", "0", "0.39225"], ["0", "0.093", "0"], ["0", "0", "0.09465"],
]  # fmt: skip
ARM_ANGLES = ["0.7", "-1.1", "1.9", "-0.4", "1.3", "-2.8"]
ARM_TOOL = ["0", "0.0823", "0.1"]

mp.dps = 60


def single(x):
    """The nearest binary32 number, as a number that mpmath computes with."""
    return mpf(struct.unpack("<f", struct.pack("<f", float(x)))[0])


def text(x):
    """The shortest decimal that is read as the binary32 number nearest to x."""
    x = float(single(x))
    if abs(x) < 2.0**-126:
        return "0.0"  # below what f32 holds as a normal number
    for digits in range(1, 10):
        short = f"{x:.{digits}g}"
        if single(short) == x:
            return short if any(c in short for c in ".e") else short + ".0"
    raise AssertionError(x)


def array(values):
    return "[" + ", ".join(text(v) for v in values) + "]"


def mul(a, b):
    """The product of quaternions, w first."""
    (w, x, y, z), (e, f, g, h) = a, b
    return [w*e - x*f - y*g - z*h, w*f + x*e + y*h - z*g, w*g - x*h + y*e + z*f, w*h + x*g - y*f + z*e]  # fmt: skip


def dual_mul(a, b):
    cross = [s + t for s, t in zip(mul(a[:4], b[4:]), mul(a[4:], b[:4]))]
    return mul(a[:4], b[:4]) + cross


def turn(axis, angle):
    s = mp.sin(angle / 2)
    return [mp.cos(angle / 2), *(s * c for c in axis)]


def rigid(r, t):
    """r + ½ε t r"""
    return r + [c / 2 for c in mul([mpf(0), *t], r)]


def translation(s):
    """2 q p*"""
    p = s[:4]
    return [2 * c for c in mul(s[4:], [p[0], -p[1], -p[2], -p[3]])][1:]


def rotate(p, v):
    """p v p*"""
    return mul(mul(p, [mpf(0), *v]), [p[0], -p[1], -p[2], -p[3]])[1:]


def cross(a, b):
    (x, y, z), (e, f, g) = a, b
    return [y*g - z*f, z*e - x*g, x*f - y*e]  # fmt: skip


def xyzw(quats):
    """Memory order of one or more quaternions that are w first."""
    out = []
    for i in range(0, len(quats), 4):
        w, x, y, z = quats[i : i + 4]
        out += [x, y, z, w]
    return out


def skeleton():
    """(name, parent, offset, axes) of every joint and end site of the biped, parents first."""
    source = BIPED.read_text()
    scope = {n: float(v) for n, v in re.findall(r"const (\w+): f64 = ([\d.]+);", source)}
    for name, value in re.findall(r"const (\w+): \[f64; 3\] = (\[.*?\]);", source):
        scope[name] = eval(value, {}, scope)
    axes = {n: re.findall(r"Rotation\((\w)\)", v) for n, v in re.findall(r"const (\w+): &\[Channel\] =\s+&\[(.*?)\];", source, re.S)}
    scope["right"] = lambda v: [-v[0], v[1], v[2]]
    joints, index = [], {}
    links = re.findall(r'link\("(\w+)",\s+([\w()]+),\s+(None|Some\([\w()]+\)),\s+(.*?),\s+(\w+),\s+(None|Some\(\w+\))\),', source)
    assert len(links) == 16, len(links)
    for name, part, parent, offset, freedom, tip in links:
        offset = [0.0] * 3 if offset == "[0.0; 3]" else eval(offset, {}, scope)
        index[part] = len(joints)
        joints.append((name, None if parent == "None" else index[parent[5:-1]], offset, axes[freedom]))
        if tip != "None":
            joints.append((name + "_End", index[part], scope[tip[5:-1]], []))
    return joints


def biped(out):
    unit = {"X": [1, 0, 0], "Y": [0, 1, 0], "Z": [0, 0, 1]}
    joints = skeleton()
    rotations, offsets, models, freedom = [], [], [], 0
    for name, parent, offset, axes in joints:
        r = [mpf(1), mpf(0), mpf(0), mpf(0)]
        for axis in axes:
            freedom += 1
            r = mul(r, turn(unit[axis], mpf("0.6") * mp.sin(freedom * freedom)))
        r = [single(c) for c in r]
        t = [single(c) for c in ([0.1, 0.96, -0.2] if parent is None else offset)]
        local = rigid(r, t)
        models.append(local if parent is None else dual_mul(models[parent], local))
        rotations.append(r)
        offsets.append(t)
    parents = ", ".join("ROOT" if p is None else str(p) for _, p, _, _ in joints)
    n = len(joints)
    out += [
        "/// The parent of each joint of the biped; end sites are joints.",
        f"pub const BIPED_PARENTS: [u32; {n}] = [{parents}];",
        f"pub const BIPED_ROTATIONS: [[f32; 4]; {n}] = [", *(f"    {array(xyzw(r))}," for r in rotations), "];",
        f"pub const BIPED_OFFSETS: [[f32; 3]; {n}] = [", *(f"    {array(t)}," for t in offsets), "];",
        f"pub const BIPED_MODELS: [[f32; 8]; {n}] = [", *(f"    {array(xyzw(m))}," for m in models), "];",
    ]  # fmt: skip


def arm(out):
    angles = [single(a) for a in ARM_ANGLES]
    offsets = [[single(c) for c in o] for o in ARM_OFFSETS]
    tool = [single(c) for c in ARM_TOOL]
    model = [mpf(1)] + [mpf(0)] * 7
    hinges = []
    for axis, offset, angle in zip(ARM_AXES, offsets, angles):
        model = dual_mul(model, rigid(turn(axis, angle), offset))
        # A hinge does not move its own axis.
        hinges.append((rotate(model[:4], axis), translation(model)))
    tip = translation(dual_mul(model, rigid([mpf(1), mpf(0), mpf(0), mpf(0)], tool)))
    out += [
        "/// The six joints of the arm: the axis of each, its place in its parent, and how far it is turned.",
        f"pub const ARM_AXES: [[f32; 3]; 6] = [{', '.join(map(array, ARM_AXES))}];",
        "pub const ARM_OFFSETS: [[f32; 3]; 6] = [", *(f"    {array(o)}," for o in offsets), "];",
        f"pub const ARM_ANGLES: [f32; 6] = {array(angles)};",
        "/// The tip of the tool in the last joint, and where it is.",
        f"pub const ARM_TOOL: [f32; 3] = {array(tool)};",
        f"pub const ARM_TIP: [f32; 3] = {array(tip)};",
        "/// How the tip moves with each angle: angular velocity, and linear velocity, in axes of the base.",
        "pub const ARM_JACOBIAN: [[f32; 6]; 6] = [",
        *(f"    {array(axis + cross(axis, [t - o for t, o in zip(tip, origin)]))}," for axis, origin in hinges),
        "];",
    ]  # fmt: skip


def vectors(out):
    rows = [json.loads(line) for line in VECTORS.read_text().splitlines()]
    sizes = {"a": "[f32; 8]", "b": "[f32; 8]", "v": "[f32; 3]", "t": "f32"}
    for name, (op, kinds, inputs) in ROWS.items():
        answer = "[f32; 3]" if op == "point" else "[f32; 8]"
        types = ", ".join([sizes[i] for i in inputs] + [answer])
        lines = []
        for kind, count in kinds:
            found = [row for row in rows if row["op"] == op and row["kind"] == kind]
            # Evenly from the beginning to the end of the kind: rows are sorted by how hard they are.
            for row in found[:: len(found) // count][:count]:
                values = []
                for key, value in [(i, row[i]) for i in inputs] + [("out", row["out"])]:
                    value = [mpf(v) for v in value] if isinstance(value, list) else [mpf(value)]
                    value = xyzw(value) if len(value) == 8 else value
                    values.append(text(value[0]) if key == "t" else array(value))
                lines.append(f"    ({', '.join(values)}),")
        out += [f"/// Rows of `{op}`: {', '.join(inputs)}, answer.", f"pub const {name}: [({types}); {len(lines)}] = [", *lines, "];"]  # fmt: skip


def main():
    out = ["//! Inputs and answers; found by `scripts/firmware_answers.py`, do not edit.", "", "use dq8::Hierarchy;", "", "const ROOT: u32 = Hierarchy::ROOT;"]  # fmt: skip
    for section in (biped, arm, vectors):
        section(out)
    new = "\n".join(out) + "\n"
    if "--check" in sys.argv[1:]:
        if OUT.read_text() != new:
            sys.exit(f"{OUT.relative_to(ROOT)} is not what the script finds")
        print("firmware answers: as committed")
    else:
        OUT.write_text(new)


if __name__ == "__main__":
    main()
