// What the tests ask, the same for the module and for the native library: see ../examples/answers.rs.
export const JOINTS = 23,
  INSTANCES = 21,
  FRAMES = 5,
  VERTICES = 333,
  CONFIGURATIONS = 9;
export const parents = Int32Array.from({ length: JOINTS }, (_, joint) => ((joint + 1) >> 1) - 1);

let state = 0x2545f491;
/** In [0, 1), on every machine. */
export function random() {
  state ^= state << 13;
  state ^= state >>> 17;
  state ^= state << 5;
  return (state >>> 8) / 2 ** 24;
}
export const numbers = (count, of = () => 2 * random() - 1) => Float32Array.from({ length: count }, of);
/** Keys and poses: rotation x y z w, translation. */
const poses = (count) => {
  const all = numbers(7 * count);
  for (let i = 0; i < all.length; i += 7) {
    const length = Math.hypot(...all.subarray(i, i + 4));
    for (let k = 0; k < 4; k++) all[i + k] /= length;
  }
  return all;
};
const weights = (vertices) => {
  const all = numbers(4 * vertices, random);
  for (let i = 0; i < all.length; i += 4) {
    const sum = all[i] + all[i + 1] + all[i + 2] + all[i + 3];
    for (let k = 0; k < 4; k++) all[i + k] /= sum;
  }
  return all;
};

/** In the order in which the native program reads them. */
export const given = {
  locals: poses(INSTANCES * JOINTS),
  roots: poses(INSTANCES),
  binds: poses(JOINTS),
  clipA: poses(FRAMES * JOINTS),
  clipB: poses(FRAMES * JOINTS),
  atA: numbers(INSTANCES, () => 6 * random() - 1),
  atB: numbers(INSTANCES, () => 4 * random()),
  weights: numbers(INSTANCES, random),
  mask: numbers(JOINTS, random),
  clips: numbers(INSTANCES, () => Math.floor(2 * random())),
  t: numbers(INSTANCES * JOINTS, random),
  points: numbers(3 * INSTANCES * JOINTS),
  rest: numbers(3 * VERTICES),
  normals: numbers(3 * VERTICES),
  joints: numbers(4 * VERTICES, () => Math.floor(JOINTS * random())),
  skinWeights: weights(VERTICES),
  shares: numbers(VERTICES, random),
  values: numbers(9 * CONFIGURATIONS, () => 0.02 * random()),
};
