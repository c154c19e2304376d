import { Rods } from "./gl.js";
import { place } from "./motion.js";
import { Scene, arrows, colour, dragged, rgb } from "./scene.js";

/** How far from its middle, in pixels, a finger takes hold of the ring. */
const GRIP = 44;
/** URDF has z up, the page y. */
const up = ([x, y, z]) => [x, z, -y];
const far = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

function words({ outcome, linearError }) {
  const off = `${(1000 * linearError).toFixed(0)} mm`;
  return {
    converged: "The hand is there.",
    outOfReach: `Too far: the arm is stretched toward it, and ${off} are missing.`,
    atLimits: `Joints are at their limits: as near as they let it, ${off} away.`,
    stalled: `As near as it gets: ${off} away.`,
    unfinished: `Not there yet: ${off} away.`,
    invalid: "That is no place.",
  }[outcome];
}

/** Moves the hand to the goal; from where it is, and where that stalls, from elsewhere too. */
function aim({ it, hand, goal, target, values, poses }) {
  target.view.set([0, 0, 0, 1, goal[0] / 2, goal[1] / 2, goal[2] / 2, 0]);
  const before = values.view.slice();
  let report = it.reach(hand, target, values, { position: true, restarts: false });
  if (report.outcome === "stalled") {
    values.view.set(before);
    report = it.reach(hand, target, values, { position: true });
  }
  it.poses(values, poses);
  return report;
}

/** All that is shown of a robot, or an error and nothing. */
function read(robots, urdf) {
  const own = [],
    keep = (thing) => (own.push(thing), thing);
  try {
    const it = keep(robots.robot(urdf));
    if (!it.valueNames.length) throw new Error("none of its joints moves");
    const start = it.valueLimits.map(([low, high]) => {
      const middle = 0.3 * (low + high) + 0.2;
      return Number.isFinite(middle) ? Math.max(low, Math.min(high, middle)) : 0.2;
    });
    const values = keep(robots.floats(start)),
      poses = keep(robots.floats(8 * it.linkNames.length)),
      target = keep(robots.floats(8));
    it.poses(values, poses);
    const depth = [];
    it.parents.forEach((parent, j) => (depth[j] = parent < 0 ? 0 : depth[parent] + 1));
    const hand = it.link("hand") ?? depth.indexOf(Math.max(...depth)),
      all = it.parents.map((_, j) => place(poses.view, j)),
      reach = Math.max(0.2, ...all.map((p) => far(p, all[0])));
    const made = { own, it, values, poses, target, depth, hand, goal: all[hand].slice() };
    made.report = aim(made);
    // In view are all links, and as high above the first as the farthest is from it.
    const points = [...all, [all[0][0], all[0][1], all[0][2] + reach]].map(up),
      ends = [0, 1, 2].map((k) => [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))]);
    made.centre = ends.map(([low, high]) => (low + high) / 2);
    made.size = 1.2 * Math.max(...ends.map(([low, high]) => high - low));
    made.rods = new Rods(it.parents.length);
    return made;
  } catch (error) {
    for (const thing of own) thing.free();
    throw error;
  }
}

export function robot(robots, section, urdf) {
  let made;
  const draw = () => {
    const { it, poses, rods, hand, goal, depth, size } = made,
      at = it.parents.map((_, j) => up(place(poses.view, j))),
      project = scene.project();
    scene.clear();
    const [x, , z] = at[0],
      r = 0.25 * size,
      around = Array.from({ length: 65 }, (_, i) => (i * Math.PI) / 32);
    scene.line(around.map((a) => project(x + r * Math.cos(a), 0, z + r * Math.sin(a))), colour("--line"), 1);
    const thick = (j) => 0.035 * size * (1 - (0.7 * depth[j]) / Math.max(...depth));
    rods.set(it.parents.map((parent, j) => [at[Math.max(parent, 0)], at[j], thick(Math.max(parent, 0)), thick(j)]));
    scene.solid(rods.corners, rods.indices, rgb("--b"));
    scene.ring(project(...up(goal)), 14, colour("--a"));
    scene.ring(project(...at[hand]), 3, colour("--a"));
  };
  const scene = new Scene(section, { yaw: 0.7, pitch: 0.25, orbit: false, draw }),
    state = { show, scene };
  const update = (aloud) => {
    const { report, hand, goal, poses } = made;
    Object.assign(state, { report, hand: place(poses.view, hand), goal: goal.slice() });
    scene.tell(`<b>${words(report)}</b> ${report.iterations} steps`, aloud);
    scene.ask();
  };
  /** Throws before anything has changed. */
  function show(name, file) {
    const next = read(robots, file),
      { linkNames, valueNames, warnings } = next.it;
    for (const thing of made?.own ?? []) thing.free();
    made = next;
    Object.assign(scene, { size: made.size, centre: made.centre });
    section.querySelector(".of").textContent = `${valueNames.length} joints of ${name}`;
    update(false);
    return (
      `${linkNames.length} links, ${valueNames.length} values` +
      (warnings.length ? `; ${warnings.length} things in it are not read` : "")
    );
  }
  /** By pixels right and down, in the plane of the screen, and toward the viewer. */
  function drag(right, down, near = 0) {
    const { canvas } = scene,
      scale = canvas.width / canvas.clientWidth / scene.scale,
      [r, u, f] = scene.axes(),
      by = [0, 1, 2].map((k) => scale * (right * r[k] - down * u[k] + near * f[k])),
      [x, y, z] = made.goal;
    made.goal = [x + by[0], y - by[2], z + by[1]];
    made.report = aim(made);
    update(true);
  }
  /** A finger on the ring drags it; elsewhere it scrolls. */
  const grips = ({ clientX, clientY }) => {
    const { left, top, width } = scene.canvas.getBoundingClientRect(),
      pixels = scene.canvas.width / width,
      [x, y] = scene.project()(...up(made.goal));
    return Math.hypot(clientX - left - x / pixels, clientY - top - y / pixels) < GRIP;
  };
  const hold = (event) => grips(event.touches[0]) && event.preventDefault();
  scene.canvas.addEventListener("touchstart", hold, { passive: false });
  dragged(scene.canvas, drag, grips);
  arrows(scene.canvas, (right, down, shift) => (shift ? drag(0, 0, 12 * down) : drag(12 * right, 12 * down)));
  show("an arm", urdf);
  return state;
}
