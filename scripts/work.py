#!/usr/bin/env python3
"""Fails if a reader does more than its share of work for a larger file, whatever is in the file: work.py PROGRAMS [NAME…]

PROGRAMS is the folder of the programs `read` (tests/readers), `skin` and `retarget` (examples); NAMEs choose files. Valgrind
counts their instructions, which but for the seeds of hash tables are the same in every run, for hostile files of two
sizes, four times apart. What a byte takes may grow by a quarter, as sorting does; a square would be four times as much.
Each file must end as is said here, so that none is refused before its reader works. A mesh that many nodes of a glTF
file show is drawn as often, and is not tried.
"""

import base64
import json
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MORE = 1.25
# In seconds, where one takes three to fifteen: a cube of the size would take days.
LONG = 60
# The smaller size, in things of a file; some files have a size of their own.
THINGS = 200


def packed(joints, clips, keys, rows):
    """Packed clips of `clips` (first key, frames, stride, row) and `rows` of entries."""
    head = b"dq8clips" + struct.pack("<6I", 3, joints, len(clips), keys, len(rows), 0)
    body = [struct.pack("<4h", 0, 0, 0, 32767) * keys, struct.pack("<4f", 0, 0, 0, 0) * joints]
    body += [struct.pack("<4I", *clip) for clip in clips] + [struct.pack("<2f2H", 1, 0, 0, 1)] * len(clips)
    return head + b"".join(body + [struct.pack(f"<{len(row)}H", *row) for row in rows])


def robot(parts):
    return '<robot name="r"><link name="l0"/>\n' + "\n".join(parts) + "</robot>"


def link(index, parent, inside="", kind="continuous"):
    return (f'<link name="l{index}"/><joint name="j{index}" type="{kind}"><parent link="l{parent}"/><child link="l{index}"/>'
            f"{inside}</joint>")


def chain(n, inside=lambda i: ""):
    return robot(link(i, i - 1, inside(i)) for i in range(1, n))


def bvh(joints, frames, numbers, announced=None):
    return f"HIERARCHY\n{joints}\nMOTION\nFrames: {announced or frames}\nFrame Time: 0.01\n" + f"{numbers}\n" * frames


def root(inside, name="a"):
    return f"ROOT {name}\n{{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n{inside}}}\n"


END = "End Site\n{\nOFFSET 0 1 0\n}\n"


def gltf(**parts):
    return json.dumps({"asset": {"version": "2.0"}, **parts})


# Three vertices at the origin.
MESH = {
    "buffers": [{"uri": "data:application/octet-stream;base64," + "A" * 48, "byteLength": 36}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
}


def humanoid(n):
    """The humanoid with `n` shapes of collision on each hand."""
    text, ball = (ROOT / "robot/robots/humanoid.urdf").read_text(), '<collision><geometry><sphere radius="0.02"/></geometry></collision>\n'
    return re.sub(r'<link name="(left|right)_hand"/>', rf'<link name="\1_hand">{ball * n}</link>', text)


def fingers(n):
    """The humanoid with `n` fingers of three hinges beside each other."""
    hinge = lambda name, parent, at: (f'<link name="{name}"/><joint name="{name}" type="continuous"><parent link="{parent}"/>'
                                      f'<child link="{name}"/><origin xyz="{at} 0 -0.1"/><axis xyz="0 1 0"/></joint>\n')
    finger = lambda i: hinge(f"a{i}", "pelvis", 0.01 * i) + hinge(f"b{i}", f"a{i}", 0) + hinge(f"c{i}", f"b{i}", 0)
    return humanoid(0).replace("</robot>", "".join(map(finger, range(n))) + "</robot>")


def standing():
    """The first frame of the walk."""
    lines = (ROOT / "examples/mocap/walk.bvh").read_text().splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("Frames:"))
    return "\n".join([*lines[:first], "Frames: 1", *lines[first + 1 : first + 3], ""])


def scene(nodes, **parts):
    nodes[0] = {**nodes[0], "mesh": 0}
    return gltf(nodes=nodes, scene=0, **{"scenes": [{"nodes": [0]}], **MESH, **parts})


def animated(n):
    """As many channels as keys, all of one sampler."""
    numbers = struct.pack(f"<{n}f", *range(n)) + bytes(12 * n)
    accessors = [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                 {"bufferView": 0, "componentType": 5126, "count": n, "type": "SCALAR", "min": [0], "max": [n - 1]},
                 {"bufferView": 1, "componentType": 5126, "count": n, "type": "VEC3"}]
    views = [{"buffer": 0, "byteLength": 4 * n}, {"buffer": 0, "byteOffset": 4 * n, "byteLength": 12 * n}]
    channels = [{"sampler": 0, "target": {"node": i, "path": "translation"}} for i in range(n)]
    return scene([{"children": list(range(1, n))}] + [{} for _ in range(n - 1)], accessors=accessors, bufferViews=views,
                 buffers=[{"uri": "data:application/octet-stream;base64," + base64.b64encode(numbers).decode(), "byteLength": 16 * n}],
                 animations=[{"samplers": [{"input": 1, "output": 2}], "channels": channels}])


SHARED = "more tracks and frames than there are keys"

# What is not counted, as it is in every file of a format.
BASES = {"humanoid": humanoid(0)}

# Name: the format, how many things, what makes the file, and how it ends.
FILES = {
    "clips that share all keys": ("packed", 4, lambda n: packed(n, [(0, 1, 0, 0)] * n, n, [[0] * 2 * n]), SHARED),
    "tracks that share all keys": ("packed", 4, lambda n: packed(n, [(0, n, 1, 0)], n, [[1] * n + [0] * n]), SHARED),
    "clips without joints": ("packed", 8, lambda n: packed(0, [(0, 1, 0, 0)] * n, 0, [[]]), "clips: "),
    "many clips": ("packed", 4, lambda n: packed(1, [(i, 1, 0, 0) for i in range(n)], n, [[0, 0]]), "joints: 1, clips: "),
    "many rows": ("packed", 4, lambda n: packed(1, [(i, 1, 0, i) for i in range(n)], n, [[0, 0]] * n), "joints: 1, clips: "),
    "a chain": ("urdf", 1, chain, "links: "),
    "a chain, the last link first": ("urdf", 1, lambda n: robot(link(i, i - 1) for i in reversed(range(1, n))), "links: "),
    "a star": ("urdf", 1, lambda n: robot(link(i, 0) for i in range(1, n)), "links: "),
    "links that no joint carries": ("urdf", 4, lambda n: robot(f'<link name="k{i}"/>' for i in range(n)), "more than one <link> is the child of no joint"),
    "what is not read": ("urdf", 2, lambda n: robot('<gazebo><a b="c"/></gazebo>' for _ in range(n)), "warnings: "),
    "prefixes": ("urdf", 8, lambda n: robot(f"<p{i}:x/>" for i in range(n)), "more than 1000 prefixes"),
    "names with a prefix": ("urdf", 2, lambda n: robot(f"<p{i % 100}:x/>" for i in range(n)), "warnings: "),
    "comments": ("urdf", 4, lambda n: robot("<!-- <x> -- -->" for _ in range(n)), "links: 1"),
    "comments without an end": ("urdf", 4, lambda n: robot("<!-- <x> " for _ in range(n)), "not a URDF file"),
    "declarations": ("urdf", 4, lambda n: "<?xml version='1.0'?>\n" * n + robot([]), "links: 1"),
    "signs of equality": ("urdf", 1, lambda n: robot(f'<gazebo a="{"=" * 100}"/>' for _ in range(n)), "warnings: "),
    "a value of signs of equality": ("urdf", 20, lambda n: robot([f'<gazebo a="{"=" * n}"/>']), "warnings: 1"),
    "entities of XML": ("urdf", 8, lambda n: robot([f'<gazebo a="{"&amp;" * n}">{"&lt;" * n}</gazebo>']), "warnings: 1"),
    "mimics of mimics": ("urdf", 1, lambda n: chain(n, lambda i: f'<mimic joint="j{i - 1}"/>' if i > 1 else ""), "values: 1"),
    "a long name": ("urdf", 20, lambda n: robot([f"<{'orgin' * n}/>"]), "warnings: 1"),
    "many numbers": ("urdf", 4, lambda n: chain(2, lambda _: f'<origin xyz="{"1 " * n}"/>'), "xyz must be 3 finite numbers"),
    "a deep joint": ("bvh", 1, lambda n: bvh(root("".join(
        f"JOINT j{i}\n{{\nOFFSET 0 1 0\nCHANNELS 0\n" for i in range(n)) + END + "}\n" * n), 1, "0"), "joints"),
    "many joints on one": ("bvh", 1, lambda n: bvh(root("".join(
        f"JOINT j{i}\n{{\nOFFSET 0 1 0\nCHANNELS 0\n{END}}}\n" for i in range(n))), 1, "0"), "joints"),
    "many ends on one joint": ("bvh", 2, lambda n: bvh(root(END * n), 1, "0"), "joints"),
    "many roots": ("bvh", 1, lambda n: bvh("".join(root(END, f"r{i}") for i in range(n)), 1, "0 " * n), "joints"),
    "more frames than there are": ("bvh", 8, lambda n: bvh(root(END), n, "0", 10**18), "line"),
    "many frames": ("bvh", 8, lambda n: bvh(root(END), n, "0"), "2 joints"),
    "nodes in a chain": ("gltf", 1, lambda n: scene([{"children": [i + 1]} for i in range(n)] + [{}]), "vertices"),
    "nodes on one": ("gltf", 1, lambda n: scene([{"children": list(range(1, n))}] + [{}] * (n - 1)), "vertices"),
    "nodes in a circle": ("gltf", 1, lambda n: scene([{"children": [(i + 1) % n]} for i in range(n)]), "is an ancestor of itself"),
    "a node of two parents": ("gltf", 1, lambda n: scene([{"children": [1]}] * n), "is a child of 0 and of 1"),
    "channels of no sampler": ("gltf", 1, lambda n: scene([{}] * n, animations=[{"samplers": [], "channels": [
        {"sampler": 0, "target": {"node": i, "path": "translation"}} for i in range(n)]}]), "channels[199].sampler: Index out of bounds"),
    "channels of one sampler": ("gltf", 1, animated, "vertices"),
    "extensions": ("gltf", 1, lambda n: scene([{}], extensionsUsed=[f"VENDOR_{i}" for i in range(n)]), "vertices"),
    "scenes": ("gltf", 1, lambda n: scene([{}], scenes=[{"nodes": [0]}] * n), "vertices"),
    "deep JSON": ("gltf", 8, lambda n: scene([{}], extras="") [:-1] + ', "x": ' + "[" * n + "]" * n + "}", "recursion limit exceeded"),
    "numbers without an end": ("numbers", 20, lambda n: "1 " * n, "numbers where 8"),
    "brackets": ("numbers", 20, lambda n: "[" * n, "has 1 number where 8"),
    "shapes of two hands": ("humanoid", 2, humanoid, "1 frames in"),
    "fingers": ("humanoid", 1, fingers, "1 frames in"),
}


def counted(programs, form, file):
    """How many instructions it takes, and what is printed."""
    program = [programs / "read", form, file]
    if form == "gltf":
        program = [programs / "skin", file, "--times", "0"]
    elif form == "humanoid":
        clip = file.with_name("stands.bvh")
        clip.write_text(standing())
        program = [programs / "retarget", file, clip, "--out", file.parent, "--jobs", "1"]
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *program]
    try:
        told = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=LONG)
    except subprocess.TimeoutExpired:
        return None, f"no end in {LONG} s"
    count = re.search(r"Collected : (\d+)", told.stderr)
    if not count:
        sys.exit(f"valgrind counted nothing: {told.stderr}")
    said = "\n".join(line for line in told.stderr.splitlines() if not line.startswith("=="))
    return int(count[1]), told.stdout + said


def main():
    programs, wrong, bases = Path(sys.argv[1]), [], {}
    only = sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "file.gltf")

        def work(form, text):
            file.write_bytes(text if isinstance(text, bytes) else text.encode())
            return counted(programs, form, file)

        for name, (form, many, make, end) in FILES.items():
            if only and name not in only:
                continue
            if form not in bases:
                bases[form] = work(form, BASES.get(form, ""))[0]
            each = []
            for things in (THINGS * many, 4 * THINGS * many):
                text = make(things)
                count, said = work(form, text)
                if end not in said:
                    wrong.append(f"{form}, {name}: {end!r} is not in {said[:300]!r}")
                if count is None:
                    break
                each.append((count - bases[form]) / len(text))
            if len(each) < 2:
                continue
            grown = each[1] / max(each[0], 1)
            print(f"{form:8} {name:32} {len(text):8} bytes: {each[0]:9.1f} and {each[1]:9.1f} instructions a byte, {grown:.2f}", flush=True)
            if grown > MORE:
                wrong.append(f"{form}, {name}: four times the file takes {4 * grown:.1f} times the work")
    print(*wrong, sep="\n")
    sys.exit(bool(wrong))


main()
