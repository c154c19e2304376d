// A person of boxes, and how it walks and runs.

// Of each joint: its parent, where it is in its parent, the middle of its box, half the box's size.
const BODY = [
  [-1, [0, 0.95, 0], [0, 0.05, 0], [0.15, 0.09, 0.1]],
  [0, [0, 0.12, 0], [0, 0.12, 0], [0.13, 0.13, 0.09]],
  [1, [0, 0.24, 0], [0, 0.12, 0], [0.18, 0.13, 0.1]],
  [2, [0, 0.26, 0], [0, 0.04, 0], [0.05, 0.05, 0.05]],
  [3, [0, 0.09, 0], [0, 0.11, 0.01], [0.09, 0.12, 0.1]],
  [2, [0.22, 0.2, 0], [0, -0.14, 0], [0.05, 0.15, 0.05]],
  [5, [0, -0.29, 0], [0, -0.12, 0], [0.04, 0.13, 0.04]],
  [6, [0, -0.25, 0], [0, -0.07, 0], [0.03, 0.08, 0.05]],
  [2, [-0.22, 0.2, 0], [0, -0.14, 0], [0.05, 0.15, 0.05]],
  [8, [0, -0.29, 0], [0, -0.12, 0], [0.04, 0.13, 0.04]],
  [9, [0, -0.25, 0], [0, -0.07, 0], [0.03, 0.08, 0.05]],
  [0, [0.1, 0, 0], [0, -0.21, 0], [0.075, 0.22, 0.08]],
  [11, [0, -0.43, 0], [0, -0.2, 0], [0.055, 0.22, 0.06]],
  [12, [0, -0.42, 0], [0, -0.03, 0.05], [0.05, 0.035, 0.1]],
  [13, [0, -0.04, 0.14], [0, 0, 0.03], [0.05, 0.025, 0.05]],
  [0, [-0.1, 0, 0], [0, -0.21, 0], [0.075, 0.22, 0.08]],
  [15, [0, -0.43, 0], [0, -0.2, 0], [0.055, 0.22, 0.06]],
  [16, [0, -0.42, 0], [0, -0.03, 0.05], [0.05, 0.035, 0.1]],
  [17, [0, -0.04, 0.14], [0, 0, 0.03], [0.05, 0.025, 0.05]],
];

export const JOINTS = BODY.length,
  FRAMES = 31,
  ANKLE = 0.1;
/** Hip, knee and ankle of each leg, and the joints after all that hang from each. */
export const LIMBS = [[11, 12, 13], [15, 16, 17]],
  ENDS = [[15, 15, 15], [19, 19, 19]];
export const parents = Int32Array.from(BODY, ([parent]) => parent),
  sizes = BODY.flatMap(([, , , half]) => half),
  binds = Float32Array.from(BODY.flatMap(([, , middle]) => [0, 0, 0, 1, ...middle]));

/** Keys of a gait, by how far legs and arms swing. */
function gait(leg, knee, arm, elbow, lean, bounce) {
  const keys = new Float32Array(7 * FRAMES * JOINTS);
  for (let f = 0; f < FRAMES; f++) {
    const phase = (2 * Math.PI * f) / (FRAMES - 1),
      bend = new Float64Array(JOINTS);
    for (const [first, shoulder, at] of [[11, 8, phase], [15, 5, phase + Math.PI]]) {
      bend[first] = -leg * Math.sin(at);
      bend[first + 1] = knee * (0.15 + Math.max(0, Math.cos(at)));
      bend[first + 2] = -(bend[first] + bend[first + 1]) * 0.7;
      bend[shoulder] = -arm * Math.sin(at);
      bend[shoulder + 1] = -elbow;
    }
    bend[1] = lean;
    bend[4] = -lean;
    BODY.forEach(([, [x, y, z]], j) => {
      const half = bend[j] / 2,
        higher = j ? 0 : bounce * Math.cos(2 * phase);
      keys.set([Math.sin(half), 0, 0, Math.cos(half), x, y + higher, z], 7 * (f * JOINTS + j));
    });
  }
  return keys;
}
export const WALK = gait(0.45, 0.6, 0.4, 0.3, 0.03, 0.015),
  RUN = gait(0.85, 1.3, 0.8, 1.3, 0.2, 0.04);

/** How high the ground is. */
export const ground = (x, z) =>
  0.2 * Math.sin(0.8 * x) * Math.cos(0.6 * z) + 0.03 * Math.sin(2.3 * x + 1.7 * z);
