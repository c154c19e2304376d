import { Scene, colour, rgb } from "./scene.js";

const RINGS = 41,
  AROUND = 24,
  LENGTH = 4,
  RADIUS = 0.6;
const BLENDS = [
  ["linear", "--a", "Blended matrices"],
  ["dual", "--b", "Blended dual quaternions"],
  ["mixed", "--c", "Half and half"],
];

/** A tube of two joints: positions, joints, weights and triangles. */
function tube() {
  const vertices = RINGS * AROUND,
    made = { rest: new Float32Array(3 * vertices), joints: [], weights: [], indices: [] };
  for (let v = 0; v < vertices; v++) {
    const ring = Math.floor(v / AROUND),
      angle = (2 * Math.PI * (v % AROUND)) / AROUND,
      along = ring / (RINGS - 1),
      weight = Math.min(1, Math.max(0, 1.6 * along - 0.3));
    made.rest.set([LENGTH * (along - 0.5), RADIUS * Math.sin(angle), RADIUS * Math.cos(angle)], 3 * v);
    made.joints.push(0, 1);
    made.weights.push(1 - weight, weight);
    const next = ring * AROUND + ((v + 1) % AROUND);
    if (ring + 1 < RINGS) made.indices.push(v, next, v + AROUND, next, next + AROUND, v + AROUND);
  }
  return { ...made, indices: Uint32Array.from(made.indices) };
}

/** Of triangles, and of a fan over each end: six times their parts to the origin. */
function volume(p, indices) {
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    sum +=
      p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) +
      p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
      p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  for (const [ring, sign] of [[0, -1], [RINGS - 1, 1]])
    for (let k = 0; k < AROUND; k++) {
      const [a, b] = [3 * (ring * AROUND + k), 3 * (ring * AROUND + ((k + 1) % AROUND))];
      sum += sign * p[a] * (p[a + 1] * p[b + 2] - p[a + 2] * p[b + 1]);
    }
  return Math.abs(sum) / 6;
}

export function sleeve(dq8, section) {
  const { rest, joints, weights, indices } = tube(),
    vertices = rest.length / 3,
    twist = section.querySelector("#twist");
  const skin = dq8.skin({ jointCount: 2, influences: 2, joints, weights }),
    from = dq8.floats(rest),
    shares = dq8.floats(new Float32Array(vertices).fill(0.5)),
    motions = dq8.motions(2),
    posed = BLENDS.map(() => dq8.floats(rest.length)),
    whole = volume(rest, indices);
  const percent = (i) => `${(100 * state.volumes[i]).toFixed(1)} %`;
  const draw = () => {
    const { width, height } = scene.canvas,
      slot = height / 3,
      label = 1.7 * scene.letters;
    // Each tube and its label have a third of the height; a tube that is turned is 1.75 high.
    scene.scale = Math.min((slot - 1.6 * label) / 1.75, (0.9 * width) / (LENGTH + RADIUS));
    scene.clear();
    BLENDS.forEach(([, tint, name], i) => {
      scene.solid(posed[i].view, indices, rgb(tint), (1 - i) * slot - 0.5 * label);
      scene.words(`${name}: ${percent(i)}`, width / 2, i * slot + label, colour(tint));
    });
  };
  const scene = new Scene(section, { yaw: 0.35, pitch: 0.3, draw }),
    state = { scene, volumes: [] };
  const pose = (aloud) => {
    const half = (Number(twist.value) * Math.PI) / 360;
    motions.view.set([Math.sin(half), 0, 0, Math.cos(half)], 8);
    BLENDS.forEach(([blend], i) => {
      skin.pose({ blend, motions, shares, rest: from, posed: posed[i] });
      state.volumes[i] = volume(posed[i].view, indices) / whole;
    });
    const parts = BLENDS.map(([, tint, name], i) => {
      return `<span class="${tint.slice(2)}">${name} <b>${percent(i)}</b></span>`;
    });
    scene.tell(`Of the volume is left: ${parts.join(", ")}`, aloud);
    scene.ask();
  };
  twist.addEventListener("input", () => pose(true));
  pose(false);
  return state;
}
