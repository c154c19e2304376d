"""Clips of motion capture: a reader and a writer of BVH of our own, and the same motion in other conventions."""

import dataclasses
import re

import numpy as np
from scipy.spatial.transform import Rotation


@dataclasses.dataclass
class Clip:
    names: list
    parents: list  # −1 for the root
    offsets: np.ndarray  # [joint, 3]
    channels: list  # of each joint, such as ["Xposition", "Zrotation"]; empty at tips
    values: np.ndarray  # [frame, channel]
    step: float

    def __post_init__(self):
        """Computes the motion of each joint relative to its parent: `turns` and `ways`, [frame][joint]."""
        self.turns, self.ways, column = [], [], 0
        frames = len(self.values)
        for offset, channels in zip(self.offsets, self.channels):
            way, turn = np.tile(offset, (frames, 1)), Rotation.identity(frames)
            for channel in channels:
                value = self.values[:, column]
                if channel[1:] == "position":
                    way[:, "XYZ".index(channel[0])] = value
                else:
                    turn = turn * Rotation.from_euler(channel[0].lower(), value[:, None], degrees=True)
                column += 1
            self.turns.append(turn)
            self.ways.append(way)

    def places(self):
        """Returns where joints are, [frame, joint, 3]."""
        turns, places = [], []
        for joint, parent in enumerate(self.parents):
            if parent < 0:
                turns.append(self.turns[joint])
                places.append(self.ways[joint])
            else:
                turns.append(turns[parent] * self.turns[joint])
                places.append(places[parent] + turns[parent].apply(self.ways[joint]))
        return np.stack(places, axis=1)

    def rewritten(self, offsets, turns, ways, six=False, step=None):
        """Returns this clip with other offsets and motions, with channels in another order."""
        channels, columns = [], []
        for joint, own in enumerate(self.channels):
            channels.append([])
            if not own:
                continue
            if six or self.parents[joint] < 0:
                channels[-1] += ["Xposition", "Yposition", "Zposition"]
                columns.append(ways[joint])
            channels[-1] += ["Zrotation", "Yrotation", "Xrotation"]
            columns.append(turns[joint].as_euler("ZYX", degrees=True))
        values = np.concatenate(columns, axis=1)
        return Clip(self.names, self.parents, np.array(offsets), channels, values, step or self.step)

    def write(self, path):
        lines, depth, close = ["HIERARCHY"], [], []
        for joint, (name, parent) in enumerate(zip(self.names, self.parents)):
            depth.append(0 if parent < 0 else depth[parent] + 1)
            while len(close) > depth[joint]:
                lines.append(close.pop())
            tip = not self.channels[joint]
            lines += ["End Site" if tip else ("ROOT " if parent < 0 else "JOINT ") + name, "{"]
            lines.append("OFFSET " + " ".join(map(repr, map(float, self.offsets[joint]))))
            if not tip:
                lines.append(f"CHANNELS {len(self.channels[joint])} " + " ".join(self.channels[joint]))
            close.append("}")
        lines += [*close, "MOTION", f"Frames: {len(self.values)}", f"Frame Time: {self.step!r}"]
        lines += [" ".join(f"{value:.9g}" for value in frame) for frame in self.values]
        path.write_text("\n".join(lines) + "\n")
        return path


def read(path):
    head, motion = re.split(r"\bMOTION\b", path.read_text(errors="replace"), maxsplit=1)
    names, parents, offsets, channels, stack = [], [], [], [], [-1]
    words = iter(head.split())
    for word in words:
        if word in ("ROOT", "JOINT", "End"):
            names.append(next(words) if word != "End" else f"{names[-1]}_tip")
            parents.append(stack[-1])
            channels.append([])
        elif word == "{":
            stack.append(len(names) - 1)
        elif word == "}":
            stack.pop()
        elif word == "OFFSET":
            offsets.append([float(next(words)) for _ in range(3)])
        elif word == "CHANNELS":
            channels[-1] = [next(words) for _ in range(int(next(words)))]
    frames, step, numbers = re.match(r"\s*Frames:\s*(\d+)\s*Frame Time:\s*(\S+)(.*)", motion, re.S).groups()
    values = np.array(numbers.split(), float).reshape(int(frames), -1)
    return Clip(names, parents, np.array(offsets), channels, values, float(step))


def along_bones(clip):
    """Returns the motion with axes along the bones, as LAFAN1 has them: all channels zero are a straight line."""
    axes = []
    for joint in range(len(clip.names)):
        bones = [clip.offsets[child] for child, parent in enumerate(clip.parents) if parent == joint]
        bone = bones[0] if bones and np.linalg.norm(bones[0]) > 0 else np.array([1.0, 0, 0])
        axes.append(Rotation.align_vectors([bone], [[1.0, 0, 0]])[0])
    above = [Rotation.identity() if parent < 0 else axes[parent] for parent in clip.parents]
    offsets = [turn.inv().apply(offset) for turn, offset in zip(above, clip.offsets)]
    turns = [up.inv() * turn * own for up, turn, own in zip(above, clip.turns, axes)]
    ways = [turn.inv().apply(way) for turn, way in zip(above, clip.ways)]
    return clip.rewritten(offsets, turns, ways)


def six_channels(clip):
    return clip.rewritten(clip.offsets, clip.turns, clip.ways, six=True)


def at_rate(clip, rate):
    """Returns the motion with so many frames a second; between frames joints turn the shortest way."""
    old = np.arange(len(clip.values)) * clip.step
    new = np.arange(int(old[-1] * rate + 1e-6) + 1) / rate
    first = np.minimum((new / clip.step + 1e-6).astype(int), len(old) - 2)
    share = (new / clip.step - first)[:, None]
    turns = [a[first] * Rotation.from_rotvec(share * (a[first].inv() * a[first + 1]).as_rotvec()) for a in clip.turns]
    ways = [a[first] + share * (a[first + 1] - a[first]) for a in clip.ways]
    return clip.rewritten(clip.offsets, turns, ways, step=1 / rate)


def repeated(clip, times):
    """Returns a walk repeated, each time from where it ended; its last frame comes before its first."""
    ways = [np.tile(way, (times, 1)) for way in clip.ways]
    turns = [Rotation.concatenate([turn] * times) for turn in clip.turns]
    root = clip.ways[0]
    stride = (root[-1] - root[0]) * len(root) / (len(root) - 1)
    stride[1] = 0.0
    ways[0] += np.repeat(np.arange(times), len(root))[:, None] * stride
    return clip.rewritten(clip.offsets, turns, ways)


def swaying(clip, seed=3):
    """Returns the motion with a trunk that sways and arms that swing widely."""
    time = np.arange(len(clip.values))[:, None] * clip.step
    random = np.random.default_rng(seed)
    turns = list(clip.turns)
    for name, wide in (("Chest", 25), ("Abdomen", 15), ("Head", 20), ("LeftUpperArm", 60), ("RightUpperArm", 60)):
        rate, phase = random.uniform(2.5, 7.0, 3), random.uniform(0, 6.3, 3)
        sway = wide * np.sin(time * rate + phase) * np.minimum(time, 1.0)
        joint = clip.names.index(name)
        turns[joint] = turns[joint] * Rotation.from_euler("xyz", sway, degrees=True)
    return clip.rewritten(clip.offsets, turns, clip.ways)


def shaken(clip, degrees=0.5, seed=5):
    """Returns the motion with the shakes of joints that cameras see."""
    random = np.random.default_rng(seed)
    shakes = np.radians(degrees) * random.normal(size=(len(clip.turns), len(clip.values), 3))
    turns = [turn * Rotation.from_rotvec(shake) for turn, shake in zip(clip.turns, shakes)]
    return clip.rewritten(clip.offsets, [clip.turns[0], *turns[1:]], clip.ways)
