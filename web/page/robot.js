import { Scene, colour, place } from "./scene.js";

export async function robot(robots, section, text) {
  const scene = new Scene(section, { yaw: 0.7, pitch: 0.25, size: 2, orbit: false }), state = { show };
  let it, values, poses, target, goal, hand;
  /** Throws before anything has changed. z is up in URDF, y here. */
  function show(urdf) {
    const next = robots.robot(urdf), start = next.valueLimits.map(([low, high]) => Number.isFinite(low + high) ? Math.max(low, Math.min(high, 0.6 * (low + high) / 2 + 0.2)) : 0.2);
    it?.free(); values?.free(); poses?.free(); target?.free();
    it = next;
    [values, poses, target] = [robots.floats(start), robots.floats(8 * it.linkNames.length), robots.floats([0, 0, 0, 1, 0, 0, 0, 0])];
    it.poses(values, poses);
    const depth = []; it.parents.forEach((parent, j) => { depth[j] = parent < 0 ? 0 : depth[parent] + 1; });
    hand = it.link("hand") ?? depth.indexOf(Math.max(...depth));
    const all = it.parents.map((_, j) => place(poses.view, j)), reach = Math.max(0.2, ...all.map((p) => Math.hypot(...p.map((x, k) => x - all[0][k]))));
    scene.size = 2.4 * reach;
    scene.centre = [0, 0.5 * reach, 0];
    goal = all[hand].slice();
    aim();
    return `${it.linkNames.length} links, ${it.valueNames.length} values` + (it.warnings.length ? `; ${it.warnings.length} things in it are not read` : "");
  }
  function aim() {
    target.view.set([0, 0, 0, 1, goal[0] / 2, goal[1] / 2, goal[2] / 2, 0]);
    // From where it is, as for a target that moves; where that stalls, from elsewhere too.
    const before = values.view.slice();
    let report = it.reach(hand, target, values, { position: true, restarts: false });
    if (report.outcome === "stalled") { values.view.set(before); report = it.reach(hand, target, values, { position: true }); }
    it.poses(values, poses);
    const off = `${(1000 * report.linearError).toFixed(0)} mm`;
    const words = { converged: "The hand is there.", outOfReach: `Too far: the arm is stretched toward it, and ${off} are missing.`, atLimits: `Joints are at their limits: as near as they let it, ${off} away.`,
      stalled: `As near as it gets: ${off} away.`, unfinished: `Not there yet: ${off} away.`, invalid: "That is no place." };
    Object.assign(state, { report, hand: place(poses.view, hand), goal: goal.slice() });
    scene.output.innerHTML = `<b>${words[report.outcome]}</b> ${report.iterations} steps`;
    scene.draw();
  }
  const up = ([x, y, z]) => [x, z, -y];
  scene.draw = () => {
    if (!it) return;
    const project = scene.project(), at = it.parents.map((_, j) => project(...up(place(poses.view, j)))), { context } = scene;
    scene.clear();
    const r = scene.size * 0.3, ring = Array.from({ length: 65 }, (_, i) => project(r * Math.cos(i * Math.PI / 32), 0, r * Math.sin(i * Math.PI / 32)));
    scene.line(ring, colour("--line"), 1);
    it.parents.forEach((parent, j) => { if (parent >= 0) scene.line([at[parent], at[j]], colour(j === hand ? "--a" : "--b"), 7); });
    at.forEach(([x, y]) => { context.fillStyle = colour("--ink"); context.beginPath(); context.arc(x, y, 4 * Math.min(2, devicePixelRatio || 1), 0, 7); context.fill(); });
    const [x, y] = project(...up(goal));
    context.strokeStyle = colour("--a"); context.lineWidth = 3; context.beginPath(); context.arc(x, y, 14 * Math.min(2, devicePixelRatio || 1), 0, 7); context.stroke();
  };
  /** By pixels right and down, in the plane of the screen, and toward the viewer. */
  function drag(right, down, near = 0) {
    const { width, height, clientWidth } = scene.canvas, scale = scene.size / Math.min(width / 1.5, height) * width / clientWidth, [r, u, f] = scene.axes();
    const by = [0, 1, 2].map((k) => scale * (right * r[k] - down * u[k] + near * f[k]));
    goal = [goal[0] + by[0], goal[1] - by[2], goal[2] + by[1]];
    aim();
  }
  scene.canvas.addEventListener("pointerdown", (event) => scene.canvas.setPointerCapture(event.pointerId));
  scene.canvas.addEventListener("pointermove", (event) => { if (event.buttons) drag(event.movementX, event.movementY); });
  scene.canvas.addEventListener("keydown", (event) => {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!way) return;
    event.preventDefault();
    if (event.shiftKey) drag(0, 0, way[1] * 12); else drag(way[0] * 12, way[1] * 12);
  });
  show(text);
  return state;
}
