import { Scene, rgb } from "./scene.js";

const RINGS = 41, AROUND = 24, LENGTH = 4;
const BLENDS = [["linear", "--a", "Linear"], ["dual", "--b", "Dual quaternions"], ["mixed", "--c", "Half and half"]];

export function sleeve(dq8, section) {
  const scene = new Scene(section, { yaw: 0.35, pitch: 0.3, size: 5.2 }), vertices = RINGS * AROUND, twist = section.querySelector("#twist");
  const rest = new Float32Array(3 * vertices), joints = new Uint16Array(2 * vertices), weights = new Float32Array(2 * vertices), indices = [];
  for (let ring = 0; ring < RINGS; ring++) for (let k = 0; k < AROUND; k++) {
    const v = ring * AROUND + k, angle = 2 * Math.PI * k / AROUND, along = ring / (RINGS - 1), w = Math.min(1, Math.max(0, 1.6 * along - 0.3));
    rest.set([LENGTH * (along - 0.5), 0.6 * Math.sin(angle), 0.6 * Math.cos(angle)], 3 * v);
    joints.set([0, 1], 2 * v);
    weights.set([1 - w, w], 2 * v);
    const a = v, b = ring * AROUND + (k + 1) % AROUND;
    if (ring + 1 < RINGS) indices.push(a, b, a + AROUND, b, b + AROUND, a + AROUND);
  }
  const skin = dq8.skin({ jointCount: 2, influences: 2, joints, weights }), from = dq8.floats(rest), shares = dq8.floats(new Float32Array(vertices).fill(0.5));
  const motions = dq8.motions(2), posed = BLENDS.map(() => dq8.floats(rest.length));
  /** Six times its parts to the origin, with a fan over each end. */
  function volume(p) {
    let sum = 0;
    for (let i = 0; i < indices.length; i += 3) {
      const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
      sum += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
    }
    for (const [ring, sign] of [[0, -1], [RINGS - 1, 1]]) for (let k = 0; k < AROUND; k++) {
      const [a, b] = [3 * (ring * AROUND + k), 3 * (ring * AROUND + (k + 1) % AROUND)];
      sum += sign * p[a] * (p[a + 1] * p[b + 2] - p[a + 2] * p[b + 1]);
    }
    return Math.abs(sum) / 6;
  }
  const whole = volume(rest), state = { volumes: [] };
  scene.draw = () => {
    const half = Number(twist.value) * Math.PI / 360;
    motions.view.set([Math.sin(half), 0, 0, Math.cos(half)], 8);
    const { width, height } = scene.canvas, narrow = width < height * 1.2;
    scene.clear();
    BLENDS.forEach(([blend, tint], i) => {
      skin.pose({ blend, motions, shares, rest: from, posed: posed[i] });
      state.volumes[i] = volume(posed[i].view) / whole;
      const project = scene.project(), shift = (i - 1) * height * 0.3, size = narrow ? 0.8 : 1;
      scene.triangles(posed[i].view, indices, rgb(tint), (x, y, z) => { const [a, b, c] = project(size * x, size * y * 0.9, size * z * 0.9); return [a, b + shift, c]; });
    });
    scene.output.innerHTML = BLENDS.map(([, tint, name], i) => `<span class="${tint.slice(2)}">${name} <b>${(100 * state.volumes[i]).toFixed(1)} %</b></span>`).join(" &nbsp; ") + " &nbsp; of the volume";
  };
  twist.addEventListener("input", scene.draw);
  scene.draw();
  return state;
}
