import { Scene, colour, move, place } from "./scene.js";

const STEPS = 49, BODY = [[-0.25, 0, 0], [0.25, 0, 0], [0, 0, 0], [0, 0.45, 0], [0, 0, 0], [0, 0, 0.25]];

export function between(dq8, section) {
  const scene = new Scene(section, { yaw: 0.5, pitch: 0.9, size: 4.4, centre: [0, 0.3, 0] }), [way, turn] = ["#way", "#turn"].map((id) => section.querySelector(id));
  const [a, b, path] = [dq8.motions(STEPS), dq8.motions(STEPS), dq8.motions(STEPS)], t = dq8.floats(Float32Array.from({ length: STEPS }, (_, i) => i / (STEPS - 1)));
  const ends = dq8.motions(2), poses = dq8.floats(14), state = {};
  const pose = (angle, slide) => [0, Math.sin(angle / 2), 0, Math.cos(angle / 2), 1.5 * Math.cos(angle), slide, -1.5 * Math.sin(angle)];
  scene.draw = () => {
    const angle = Number(turn.value) * Math.PI / 180, now = Number(way.value) / 100;
    poses.view.set([...pose(0, 0), ...pose(angle, 0.7)]);
    dq8.fromRotationsTranslations(poses, ends);
    for (let i = 0; i < STEPS; i++) { a.view.set(ends.view.subarray(0, 8), 8 * i); b.view.set(ends.view.subarray(8, 16), 8 * i); }
    t.view[0] = now;
    dq8.sclerpEach(a, b, t, path);
    const screw = path.view.slice(0, 8);
    t.view[0] = 0;
    dq8.sclerpEach(a, b, t, path);
    // Slerp and lerp apart, about the one axis that there is; matrices number by number.
    const from = place(ends.view, 0), to = place(ends.view, 1), line = (s) => from.map((x, k) => x + s * (to[k] - x));
    const turned = (s, [x, y, z]) => { const c = Math.cos(s * angle), d = Math.sin(s * angle); return [c * x + d * z, y, c * z - d * x]; };
    const ways = {
      b: (p) => move(screw, 0, p),
      a: (p) => turned(now, p).map((x, k) => x + line(now)[k]),
      c: (p) => move(ends.view, 0, p).map((x, k) => x + now * (move(ends.view, 1, p)[k] - x)),
    };
    const project = scene.project(), draw = (points, tint, width) => scene.line(points.map((p) => project(...p)), tint, width);
    const body = (at, tint, width) => { for (let i = 0; i < BODY.length; i += 2) draw([at(BODY[i]), at(BODY[i + 1])], tint, width); };
    scene.clear();
    draw([[0, -0.6, 0], [0, 1.6, 0]], colour("--line"), 1);
    draw(Array.from({ length: STEPS }, (_, i) => place(path.view, i)), colour("--b"), 2);
    draw([from, to], colour("--a"), 2);
    for (const i of [0, 1]) body((p) => move(ends.view, i, p), colour("--soft"), 2);
    for (let i = 6; i < STEPS - 1; i += 6) body((p) => move(path.view, i, p), colour("--line"), 1);
    for (const [name, at] of Object.entries(ways)) body(at, colour(`--${name}`), 4);
    const radius = ([x, , z]) => Math.hypot(x, z) / 1.5, length = (at) => Math.hypot(...at(BODY[0]).map((x, k) => x - at(BODY[1])[k])) / 0.5;
    Object.assign(state, { radii: Object.values(ways).map((at) => radius(at([0, 0, 0]))), size: length(ways.c) });
    const percent = (x) => `<b>${(100 * x).toFixed(1)} %</b>`;
    scene.output.innerHTML = `From the axis: <span class="b">screw ${percent(state.radii[0])}</span>, <span class="a">slerp and lerp ${percent(state.radii[1])}</span>; <span class="c">of its length, the lerp of matrices leaves ${percent(state.size)}</span>`;
  };
  for (const input of [way, turn]) input.addEventListener("input", scene.draw);
  scene.draw();
  return state;
}
