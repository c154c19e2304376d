import { Rods } from "./gl.js";
import { place } from "./motion.js";
import { Scene, escaped, rgb } from "./scene.js";

/** How many poses have to fit into the picture. */
const POSES = 16;

/** What plays a file, or an error and nothing. */
function read(dq8, { parents, keys, seconds, mesh }) {
  const own = [],
    keep = (thing) => (own.push(thing), thing),
    joints = parents.length,
    made = { own, parents, seconds, mesh, frames: keys.length / 7 / joints };
  try {
    made.skeleton = keep(dq8.skeleton(parents));
    made.clip = keep(made.skeleton.clip(keys));
    made.at = keep(dq8.floats(1));
    made.models = keep(dq8.motions(joints));
    if (mesh) {
      made.binds = keep(dq8.motions(mesh.inverseBinds));
      made.motions = keep(dq8.motions(joints));
      made.skin = keep(dq8.skin({ jointCount: joints, ...mesh }));
      made.rest = keep(dq8.floats(mesh.rest));
      made.posed = keep(dq8.floats(mesh.rest.length));
    } else made.rods = new Rods(joints);
    pose(dq8, made, 0);
    if (made.models.view.some((x) => !Number.isFinite(x))) throw new Error("a number in it is not finite");
    return made;
  } catch (error) {
    for (const thing of own) thing.free();
    throw error;
  }
}

function pose(dq8, { skeleton, clip, at, models, skin, binds, motions, rest, posed }, frame) {
  at.view[0] = frame;
  skeleton.localToModel(clip.sample(at), models);
  if (!skin) return;
  dq8.mul(models, binds, motions);
  skin.pose({ motions, rest, posed });
}

/** Where the joints are; a skeleton may walk away, so the first joint stays in the middle. */
function joints({ models, parents }) {
  const [x, , z] = place(models.view, 0);
  return parents.map((_, j) => place(models.view, j)).map(([a, b, c]) => [a - x, b, c - z]);
}

/** Lowest and highest numbers on each axis, of some poses from the first to the last. */
function bounds(dq8, made) {
  const ends = [0, 1, 2].map(() => [Infinity, -Infinity]);
  for (let k = 0; k < POSES; k++) {
    pose(dq8, made, (k / (POSES - 1)) * (made.frames - 1));
    const points = made.posed?.view ?? joints(made).flat();
    for (let i = 0; i < points.length; i++) {
      const [low, high] = ends[i % 3];
      ends[i % 3] = [Math.min(low, points[i]), Math.max(high, points[i])];
    }
  }
  return ends;
}

export function yours(dq8, section) {
  const state = { show },
    stop = section.querySelector("#stop");
  let scene,
    made,
    time = 0;
  function step(seconds) {
    if (stop.checked) return false;
    time += seconds;
    pose(dq8, made, (time / made.seconds) % Math.max(1, made.frames - 1));
    return true;
  }
  function draw() {
    const { posed, parents, mesh, rods } = made;
    scene.clear();
    if (mesh) return scene.solid(posed.view, mesh.indices, rgb("--b"));
    const at = joints(made),
      thick = 0.012 * scene.size;
    rods.set(parents.map((parent, j) => [at[Math.max(parent, 0)], at[j], thick, 0.6 * thick]));
    return scene.solid(rods.corners, rods.indices, rgb("--b"));
  }
  /** Throws before anything has changed. */
  function show(name, file) {
    const next = read(dq8, file);
    for (const thing of made?.own ?? []) thing.free();
    made = next;
    section.hidden = false;
    section.querySelector("h2").textContent = name;
    scene ??= state.scene = new Scene(section, { yaw: 0.4, pitch: 0.15, draw, step });
    time = 0;
    const { parents, frames } = made,
      ends = bounds(dq8, made);
    scene.centre = ends.map(([low, high]) => (low + high) / 2);
    scene.size = 1.3 * Math.max(1e-3, ...ends.map(([low, high]) => high - low));
    scene.tell(escaped(file.what));
    Object.assign(state, { name, joints: parents.length, frames });
    section.scrollIntoView();
    scene.ask();
    return file.what;
  }
  stop.addEventListener("change", () => scene.ask());
  return state;
}
