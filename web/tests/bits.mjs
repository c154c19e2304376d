// One hash of the answers to everything that simd128 computes, which no engine may change: of input that all engines
// make alike, without sines.
import { JOINTS as FEW, numbers, random } from "./given.mjs";

const COUNT = 9;

/** Poses x y z w tx ty tz, by operations that IEEE 754 says how to round. */
function poses(count) {
  const all = numbers(7 * count);
  for (let i = 0; i < all.length; i += 7) {
    let sum = 0;
    for (let k = i; k < i + 4; k++) sum += all[k] * all[k];
    for (let k = i; k < i + 4; k++) all[k] /= Math.sqrt(sum);
  }
  return all;
}

export function bits({ dq8, robots, urdf }) {
  let hash = 0x811c9dc5;
  const add = (floats) => {
    const { buffer, byteOffset, byteLength } = floats.view;
    for (const byte of new Uint8Array(buffer, byteOffset, byteLength)) hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
  };
  const motions = (count) => {
    const made = dq8.motions(count);
    dq8.fromRotationsTranslations(dq8.floats(poses(count)), made);
    return made;
  };
  const total = FEW * COUNT,
    skeleton = dq8.skeleton(Array.from({ length: FEW }, (_, joint) => ((joint + 1) >> 1) - 1));
  const [locals, roots, inverseBinds] = [total, COUNT, FEW].map(motions),
    [models, palette] = [dq8.motions(total), dq8.floats(16 * total)];
  skeleton.localToModel(locals, models, { roots });
  add(models);
  const [walk, run] = [0, 1].map(() => skeleton.clip(poses(5 * FEW)));
  const at = dq8.floats(numbers(COUNT, () => 4 * random())),
    weights = dq8.floats(numbers(COUNT, random));
  for (const law of ["nlerp", "slerp"]) {
    skeleton.palette(walk.sample(at).blend(run.sample(at), weights, { law }), { roots, inverseBinds, palette });
    add(palette);
  }
  skeleton.locals(walk.sample(at).add(run.sample(at), weights), locals);
  add(locals);
  const crowd = skeleton.crowd(COUNT);
  crowd.set(locals);
  crowd.localToModel();
  crowd.copyTo(models);
  add(models);
  const between = dq8.motions(total);
  dq8.sclerpEach(locals, models, dq8.floats(numbers(total, random)), between);
  add(between);
  const vertices = 101,
    joints = numbers(4 * vertices, () => Math.floor(FEW * random()));
  const skin = dq8.skin({ jointCount: FEW, influences: 4, joints, weights: joints.map(() => 0.25) });
  const [rest, posed] = [dq8.floats(numbers(3 * vertices)), dq8.floats(3 * vertices)],
    moved = dq8.floats(models.view.slice(0, 8 * FEW));
  for (const blend of ["dual", "linear"]) {
    skin.pose({ blend, motions: moved, rest, posed });
    add(posed);
  }
  const robot = robots.robot(urdf),
    values = robots.floats(numbers(robot.valueNames.length * COUNT, () => 0.02 * random())),
    links = robots.motions(robot.linkNames.length * COUNT);
  robot.poses(values, links);
  add(links);
  const last = robot.linkNames.length - 1,
    targets = robots.motions(COUNT);
  for (let i = 0; i < COUNT; i++) targets.view.set(links.view.subarray(8 * last, 8 * last + 8), 8 * i);
  robot.reachEach(last, targets, values);
  add(values);
  return hash.toString(16).padStart(8, "0");
}
