// A robot in the worker that has read its file: where its links are when its hand goes to a goal.
import load from "../package/robots.js";
import { place } from "./motion.js";

/** How many links are drawn while a hand is dragged. */
const MOST = 2000;
const far = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

/** What the page is told of a robot, and `aim`, which moves its hand to a goal. */
export async function arm(file) {
  const [robots, urdf] = await Promise.all([load(), file.arrayBuffer()]),
    it = robots.robot(urdf),
    { parents } = it;
  if (parents.length > MOST) throw new Error(`it has ${parents.length} links, of which at most ${MOST} are drawn here`);
  if (!it.valueNames.length) throw new Error("none of its joints moves");
  const start = it.valueLimits.map(([low, high]) => {
    const middle = 0.3 * (low + high) + 0.2;
    return Number.isFinite(middle) ? Math.max(low, Math.min(high, middle)) : 0.2;
  });
  const values = robots.floats(start),
    poses = robots.floats(8 * parents.length),
    target = robots.floats(8),
    depth = [];
  parents.forEach((parent, j) => (depth[j] = parent < 0 ? 0 : depth[parent] + 1));
  const deepest = Math.max(...depth),
    hand = it.link("hand") ?? depth.indexOf(deepest);
  const places = () => {
    it.poses(values, poses);
    return parents.map((_, j) => place(poses.view, j));
  };
  /** From where the hand is, and where that stalls, from elsewhere too. */
  function aim(goal) {
    target.view.set([0, 0, 0, 1, goal[0] / 2, goal[1] / 2, goal[2] / 2, 0]);
    const before = values.view.slice();
    let report = it.reach(hand, target, values, { position: true, restarts: false });
    if (report.outcome === "stalled") {
      values.view.set(before);
      report = it.reach(hand, target, values, { position: true });
    }
    return { report, places: places() };
  }
  // In view are all links, and as high above the first as the farthest is from it.
  const all = places(),
    [x, y, z] = all[0],
    points = [...all, [x, y, z + Math.max(0.2, ...all.map((p) => far(p, all[0])))]],
    ends = [0, 1, 2].map((k) => [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))]);
  const made = {
    parents,
    hand,
    goal: all[hand],
    thick: depth.map((d) => 0.035 * (1 - (0.7 * d) / deepest)),
    centre: ends.map(([low, high]) => (low + high) / 2),
    size: 1.2 * Math.max(...ends.map(([low, high]) => high - low)),
    values: start.length,
    warnings: it.warnings.length,
    ...aim(all[hand]),
  };
  return { made, aim };
}
