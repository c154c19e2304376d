import { move, place } from "./motion.js";
import { Scene, colour } from "./scene.js";

const STEPS = 49,
  BODY = [[-0.25, 0, 0], [0.25, 0, 0], [0, 0, 0], [0, 0.45, 0], [0, 0, 0], [0, 0, 0.25]];

const pose = (angle, slide) => {
  const half = angle / 2;
  return [0, Math.sin(half), 0, Math.cos(half), 1.5 * Math.cos(angle), slide, -1.5 * Math.sin(angle)];
};

export function between(dq8, section) {
  const [way, turn] = ["#way", "#turn"].map((id) => section.querySelector(id));
  const [a, b, path] = [0, 0, 0].map(() => dq8.motions(STEPS)),
    t = dq8.floats(Float32Array.from({ length: STEPS }, (_, i) => i / (STEPS - 1))),
    ends = dq8.motions(2),
    poses = dq8.floats(14);
  let ways, from, to;
  const draw = () => {
    const project = scene.project(),
      line = (points, tint, width) => scene.line(points.map((p) => project(...p)), tint, width);
    const body = (at, tint, width) => {
      for (let i = 0; i < BODY.length; i += 2) line([at(BODY[i]), at(BODY[i + 1])], tint, width);
    };
    scene.clear();
    line([[0, -0.6, 0], [0, 1.6, 0]], colour("--soft"), 1);
    line(Array.from({ length: STEPS }, (_, i) => place(path.view, i)), colour("--b"), 2);
    line([from, to], colour("--a"), 2);
    for (const i of [0, 1]) body((p) => move(ends.view, i, p), colour("--soft"), 2);
    for (let i = 6; i < STEPS - 1; i += 6) body((p) => move(path.view, i, p), colour("--line"), 2);
    for (const [name, at] of Object.entries(ways)) body(at, colour(`--${name}`), 4);
  };
  const scene = new Scene(section, { yaw: 0.5, pitch: 0.9, size: 3.2, centre: [0, 0.35, -0.6], solid: false, draw }),
    state = { scene };
  const update = (aloud) => {
    const angle = (Number(turn.value) * Math.PI) / 180,
      now = Number(way.value) / 100;
    poses.view.set([...pose(0, 0), ...pose(angle, 0.7)]);
    dq8.fromRotationsTranslations(poses, ends);
    for (let i = 0; i < STEPS; i++) {
      a.view.set(ends.view.subarray(0, 8), 8 * i);
      b.view.set(ends.view.subarray(8, 16), 8 * i);
    }
    t.view[0] = now;
    dq8.sclerpEach(a, b, t, path);
    const screw = path.view.slice(0, 8);
    t.view[0] = 0;
    dq8.sclerpEach(a, b, t, path);
    [from, to] = [place(ends.view, 0), place(ends.view, 1)];
    // Slerp and lerp apart, about the one axis that there is; matrices number by number.
    const straight = from.map((x, k) => x + now * (to[k] - x)),
      [c, s] = [Math.cos(now * angle), Math.sin(now * angle)];
    ways = {
      b: (p) => move(screw, 0, p),
      a: ([x, y, z]) => [c * x + s * z, y, c * z - s * x].map((value, k) => value + straight[k]),
      c: (p) => move(ends.view, 0, p).map((x, k) => x + now * (move(ends.view, 1, p)[k] - x)),
    };
    const radius = ([x, , z]) => Math.hypot(x, z) / 1.5,
      size = Math.hypot(...ways.c(BODY[0]).map((x, k) => x - ways.c(BODY[1])[k])) / 0.5;
    Object.assign(state, { radii: Object.values(ways).map((at) => radius(at([0, 0, 0]))), size });
    const [first, second] = state.radii,
      percent = (x) => `<b>${(100 * x).toFixed(1)} %</b>`;
    scene.tell(
      `From the axis: <span class="b">screw ${percent(first)}</span>, ` +
        `<span class="a">slerp and lerp ${percent(second)}</span>; ` +
        `<span class="c">of its length, the lerp of matrices leaves ${percent(size)}</span>`,
      aloud,
    );
    scene.ask();
  };
  for (const input of [way, turn]) input.addEventListener("input", () => update(true));
  update(false);
  return state;
}
