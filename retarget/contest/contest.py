"""Measures dq8-retarget by MuJoCo's kinematics, and beside mink with the same goals: contest.py [--quick] PROGRAM CLIP…

`PROGRAM` is the example `retarget`. Prints tables in Markdown; ends with an error if MuJoCo and dq8 disagree.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

import clips
import measures
import numpy as np
import robots

WALK = robots.HERE.parent.parent / "examples/mocap/walk.bvh"
# Rows of dq8's own report, and by how much MuJoCo may differ: one part in twenty, and this.
REPORT = {
    "residual": (r"residual, mm +(\S+)", 0.1),
    "feet": (r"residual of feet, mm +(\S+)", 0.1),
    "slide": (r"slide of feet, mm/s +(\S+)", 1.5),
    "ground": (r"ground, mm +(\S+)", 0.3),
    "sink": (r"sink, mm +(\S+)", 0.3),
    "jerk": (r"jerk, rad/s³ +(\S+)", 1.0),
}
SPEEDS = {
    "one clip": r"tracking +(\d+)",
    "16 clips": r"tracking .*?f32 lanes +(\d+)",
    "whole": r"passes +(\d+)",
}


def solve(program, robot, path, folder, *options):
    """Returns the scene, the motion and dq8's own measures of a clip on a robot."""
    values, targets = folder / "values.csv", folder / "targets.json"
    command = [program, robot.urdf, path, "--csv", values, "--targets", targets, *options]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{robot.name}, {path.name}: {done.stderr}")
    columns = values.read_text().split("\n", 1)[0].split(",")[1:]
    rows = np.loadtxt(values, delimiter=",", skiprows=1, ndmin=2)[:, 1:]
    scene = measures.Scene(robot, json.loads(targets.read_text()), clips.read(path), columns)
    own = {name: float(re.search(pattern, done.stdout).group(1)) for name, (pattern, _) in REPORT.items()}
    own |= {name: float(re.search(pattern, done.stdout, re.S).group(1)) for name, pattern in SPEEDS.items()}
    own["edges"] = "edges are not known" not in done.stdout
    own["hits"] = (re.search(r"self-hits, % of frames +([\d.]+)", done.stdout) or [0, "–"])[1]
    return scene, scene.values(rows), own


def table(heads, rows):
    print("\n| " + " | ".join(heads) + " |\n" + "|---" * len(heads) + "|")
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)


def conventions(program, all_robots, all_clips, folder):
    for robot in all_robots:
        for title, clip in all_clips.items():
            found = {}
            for name, other in (
                ("as it is", clip),
                ("axes along bones", clips.along_bones(clip)),
                ("six channels", clips.six_channels(clip)),
                ("120 Hz", clips.at_rate(clip, 120)),
                ("60 Hz", clips.at_rate(clip, 60)),
            ):
                scene, rows, _ = solve(program, robot, other.write(folder / "other.bvh"), folder)
                found[name] = scene.measure(rows)["residual"]
            least, most = min(found.values()), max(found.values())
            yield [robot.name, title, *(f"{mm:.2f}" for mm in found.values()), f"{100 * (most / least - 1):.1f} %"]


def main():
    words = sys.argv[1:]
    quick = "--quick" in words
    program, *files = [word for word in words if word != "--quick"]
    folder = pathlib.Path(tempfile.mkdtemp())
    walk = clips.repeated(clips.read(WALK), 2 if quick else 6)
    known = {"walk": walk}
    if not quick:
        known |= {"walk with shakes": clips.shaken(walk), "walk, wide arms": clips.swaying(walk)}
        known |= {pathlib.Path(file).stem: clips.read(pathlib.Path(file)) for file in files}
    all_robots = list(robots.all_of_them(folder))[: 1 if quick else None]

    print("## The same motion in other conventions of files, mean mm")
    longest = [known["walk"], *([clips.read(pathlib.Path(files[-1]))] if files and not quick else [])]
    titles = ["walk", *([pathlib.Path(files[-1]).stem] if len(longest) > 1 else [])]
    heads = ["robot", "clip", "as it is", "axes along bones", "six channels", "120 Hz", "60 Hz", "spread"]
    rows = list(conventions(program, all_robots[:2], dict(zip(titles, longest)), folder))
    table(heads, rows)
    # Fractions of a millimetre are much where nearly nothing is left. With axes along bones, files do not say what the
    # rest pose is, so targets are others: nearer ones, or up to 1.31 times as far where a person kneels.
    same = [(row, [float(mm) for mm in (row[2], *row[4:7])]) for row in rows]
    wrong = [f"{row[:2]}: {mm}" for row, mm in same if max(mm) / min(mm) > 1.05 and np.ptp(mm) > 0.5]
    wrong += [f"{row[:2]}: {row[3]} along bones" for row, mm in same if float(row[3]) > 1.35 * mm[0]]

    rows, beside, ratios = [], [], []
    for robot in all_robots:
        for title, clip in known.items():
            path = clip.write(folder / "clip.bvh")
            scene, motion, own = solve(program, robot, path, folder)
            found = scene.measure(motion)
            for name, (_, slack) in REPORT.items():
                # MuJoCo knows edges of soles from meshes.
                if not own["edges"] and name in ("slide", "ground", "sink"):
                    continue
                if abs(found[name] - own[name]) > slack + 0.05 * abs(own[name]):
                    wrong.append(f"{robot.name}, {title}: {name} is {found[name]:.2f}, and {own[name]} says dq8")
            rows.append([robot.name, title, *(f"{found[n]:.1f}" for n in ("residual", "high", "feet", "slide", "corners", "ground", "sink")),
                         f"{found['jerk']:.0f}", f"{found['hits']:.1f}", own["hits"], f"{found['beyond']:.0e}"])
            print(f"{robot.name}, {title}", file=sys.stderr)
            if quick or "," in robot.name:
                continue
            rough_scene, rough, _ = solve(program, robot, path, folder, "--smooth", "0")
            before = rough_scene.measure(rough)
            other, seconds = scene.mink(motion[0])
            theirs, rate = scene.measure(other), len(other) / seconds
            ratio = [before["residual"] / theirs["residual"], found["residual"] / theirs["residual"],
                     before["jerk"] / theirs["jerk"], found["jerk"] / theirs["jerk"],
                     *(own[name] / rate for name in SPEEDS)]
            ratios.append(ratio)
            beside.append([robot.name, title, f"{theirs['residual']:.1f}", f"{theirs['feet']:.1f}", f"{theirs['jerk']:.0f}", f"{rate:.0f}",
                           *(f"{number:.2f}" for number in ratio[:4]), *(f"{number:.0f}" for number in ratio[4:])])
    print("\n## The whole pipeline by MuJoCo")
    table(["robot", "clip", "residual, mm", "a twentieth above", "feet", "slide, mm/s", "of corners", "ground, mm", "sink, mm",
           "jerk, rad/s³", "self-hits by MuJoCo, %", "by dq8", "beyond limits, rad"], rows)
    if ratios:
        mean = np.exp(np.log(ratios).mean(axis=0))
        print("\n## Beside mink, with the same goals, weights and limits: ratios dq8 / mink")
        for name, row in (("geometric mean", mean), ("worst", [*np.max(ratios, axis=0)[:4], *np.min(ratios, axis=0)[4:]])):
            beside.append([name, "", "", "", "", "", *(f"{n:.2f}" for n in row[:4]), *(f"{n:.0f}" for n in row[4:])])
        table(["robot", "clip", "mink: mm", "feet", "jerk", "frames/s", "residual, no passes", "residual", "jerk, no passes", "jerk",
               "frames/s, one clip", "16 clips, f32", "whole pipeline"], beside)
    if wrong:
        sys.exit("\n".join(["", "MuJoCo and dq8 disagree, or conventions differ:", *wrong]))


main()
