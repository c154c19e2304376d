import { animate } from "../bench/plain.js";
import { Scene, place } from "./scene.js";

// A person: parent, where the joint is in its parent, the middle of its box and half its size.
const BODY = [
  [-1, [0, 0.95, 0], [0, 0.05, 0], [0.15, 0.09, 0.1]], [0, [0, 0.12, 0], [0, 0.12, 0], [0.13, 0.13, 0.09]], [1, [0, 0.24, 0], [0, 0.12, 0], [0.18, 0.13, 0.1]],
  [2, [0, 0.26, 0], [0, 0.04, 0], [0.05, 0.05, 0.05]], [3, [0, 0.09, 0], [0, 0.11, 0.01], [0.09, 0.12, 0.1]],
  [2, [0.22, 0.2, 0], [0, -0.14, 0], [0.05, 0.15, 0.05]], [5, [0, -0.29, 0], [0, -0.12, 0], [0.04, 0.13, 0.04]], [6, [0, -0.25, 0], [0, -0.07, 0], [0.03, 0.08, 0.05]],
  [2, [-0.22, 0.2, 0], [0, -0.14, 0], [0.05, 0.15, 0.05]], [8, [0, -0.29, 0], [0, -0.12, 0], [0.04, 0.13, 0.04]], [9, [0, -0.25, 0], [0, -0.07, 0], [0.03, 0.08, 0.05]],
  [0, [0.1, 0, 0], [0, -0.21, 0], [0.075, 0.22, 0.08]], [11, [0, -0.43, 0], [0, -0.2, 0], [0.055, 0.22, 0.06]], [12, [0, -0.42, 0], [0, -0.03, 0.05], [0.05, 0.035, 0.1]], [13, [0, -0.04, 0.14], [0, 0, 0.03], [0.05, 0.025, 0.05]],
  [0, [-0.1, 0, 0], [0, -0.21, 0], [0.075, 0.22, 0.08]], [15, [0, -0.43, 0], [0, -0.2, 0], [0.055, 0.22, 0.06]], [16, [0, -0.42, 0], [0, -0.03, 0.05], [0.05, 0.035, 0.1]], [17, [0, -0.04, 0.14], [0, 0, 0.03], [0.05, 0.025, 0.05]],
];
const JOINTS = BODY.length, FRAMES = 31, SINK = 0.16, LIMBS = [[11, 12, 13], [15, 16, 17]], ENDS = [[15, 15, 15], [19, 19, 19]], ANKLE = 0.1, ROUNDS = 15;
const parents = Int32Array.from(BODY, ([parent]) => parent);
const ground = (x, z) => 0.2 * Math.sin(0.8 * x) * Math.cos(0.6 * z) + 0.03 * Math.sin(2.3 * x + 1.7 * z);

/** Keys of a gait, by how far legs and arms swing. */
function gait(leg, knee, arm, elbow, lean, bounce) {
  const keys = new Float32Array(7 * FRAMES * JOINTS);
  for (let f = 0; f < FRAMES; f++) {
    const phase = 2 * Math.PI * f / (FRAMES - 1), bend = new Float64Array(JOINTS);
    for (const [first, shoulder, at] of [[11, 8, phase], [15, 5, phase + Math.PI]]) {
      bend[first] = -leg * Math.sin(at);
      bend[first + 1] = knee * (0.15 + Math.max(0, Math.cos(at)));
      bend[first + 2] = -(bend[first] + bend[first + 1]) * 0.7;
      bend[shoulder] = -arm * Math.sin(at);
      bend[shoulder + 1] = -elbow;
    }
    bend[1] = lean; bend[4] = -lean;
    BODY.forEach(([, at], j) => keys.set([Math.sin(bend[j] / 2), 0, 0, Math.cos(bend[j] / 2), at[0], at[1] + (j ? 0 : bounce * Math.cos(2 * phase)), at[2]], 7 * (f * JOINTS + j)));
  }
  return keys;
}

const VERTEX = `#version 300 es
layout(location=0) in vec3 corner; layout(location=1) in vec3 normal; layout(location=2) in mat4 pose;
uniform mat4 view; uniform vec3 sizes[${JOINTS}]; out vec3 n; flat out float who;
void main() { int j = gl_InstanceID % ${JOINTS}; n = mat3(pose) * normal; who = float(gl_InstanceID / ${JOINTS}); gl_Position = view * pose * vec4(corner * sizes[j], 1.); }`;
const FRAGMENT = `#version 300 es
precision highp float; in vec3 n; flat in float who; out vec4 colour;
void main() { vec3 tint = .55 + .3 * cos(who * 2.4 + vec3(0., 2., 4.)); colour = vec4(tint * (.45 + .55 * max(0., dot(normalize(n), normalize(vec3(.4, .8, .5))))), 1.); }`;
const GROUND = `#version 300 es
layout(location=0) in vec3 corner; uniform mat4 view; out vec3 p; void main() { p = corner; gl_Position = view * vec4(corner, 1.); }`;
const EARTH = `#version 300 es
precision highp float; in vec3 p; out vec4 colour; void main() { vec3 n = normalize(cross(dFdx(p), dFdy(p))); colour = vec4(vec3(.62, .66, .52) * (.5 + .5 * abs(n.y) * abs(n.y)), 1.); }`;

function program(gl, vertex, fragment) {
  const made = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source); gl.compileShader(shader); gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  return made;
}

export function crowd(dq8, section) {
  const scene = new Scene(section, { yaw: 0.7, pitch: 0.5, flat: false }), state = { people: 0, rounds: 0 }, { canvas } = scene;
  const gl = canvas.getContext("webgl2", { antialias: true });
  const [people, run, pause] = ["#people", "#run", "#pause"].map((id) => section.querySelector(id));
  const skeleton = dq8.skeleton(parents), [walkKeys, runKeys] = [gait(0.45, 0.6, 0.4, 0.3, 0.03, 0.015), gait(0.85, 1.3, 0.8, 1.3, 0.2, 0.04)];
  const [walk, race] = [skeleton.clip(walkKeys), skeleton.clip(runKeys)];
  const binds = Float32Array.from(BODY.flatMap(([, , middle]) => [0, 0, 0, 1, ...middle])), inverseBinds = dq8.motions(JOINTS);
  { const from = dq8.floats(binds); dq8.fromRotationsTranslations(from, inverseBinds); from.free(); }
  let own = [], arrays, plain, times = [], times2 = [];
  /** Memory for so many, in wasm and beside it. */
  function resize(n) {
    for (const array of own) array.free();
    own = [];
    const keep = (array) => (own.push(array), array), side = Math.ceil(Math.sqrt(n)), root = new Float32Array(7 * n);
    for (let i = 0; i < n; i++) {
      const x = 1.1 * (i % side - (side - 1) / 2) + 0.3 * Math.sin(7 * i), z = 1.1 * (Math.floor(i / side) - (side - 1) / 2) + 0.3 * Math.cos(5 * i);
      root.set([0, 0, 0, 1, x, ground(x, z) - SINK, z], 7 * i); // so that a foot lower down is in reach
    }
    const [given, roots] = [dq8.floats(root), keep(dq8.motions(n))];
    dq8.fromRotationsTranslations(given, roots); given.free();
    arrays = { roots, models: keep(dq8.motions(n * JOINTS)), palette: keep(dq8.floats(16 * n * JOINTS)), at: keep(dq8.floats(n)), atRun: keep(dq8.floats(n)), weights: keep(dq8.floats(n)),
      targets: LIMBS.map(() => keep(dq8.floats(3 * n))), poles: keep(dq8.floats(Float32Array.from({ length: 3 * n }, (_, i) => (i % 3 === 2 ? 1 : 0)))) };
    const flat = { palette: new Float32Array(16 * n * JOINTS), models: new Float32Array(7 * JOINTS), at: new Float32Array(n), atRun: new Float32Array(n), weights: new Float32Array(n), poles: arrays.poles.view.slice() };
    plain = { parents, a: walkKeys, b: runKeys, atA: flat.at, atB: flat.atRun, weights: flat.weights, roots: root, binds, palette: flat.palette, models: flat.models,
      limbs: LIMBS.map((joints, k) => ({ joints, ends: ENDS[k], targets: new Float32Array(3 * n), poles: flat.poles })) };
    plain.limbs.forEach((limb) => {
      limb.aim = (M, i) => { const o = 7 * limb.joints[2]; aim(limb.targets, i, M[o + 4], M[o + 5], M[o + 6], root[7 * i + 5]); };
    });
    Object.assign(state, { people: n, rounds: 0 });
    times = []; times2 = [];
    if (gl) { gl.bindBuffer(gl.ARRAY_BUFFER, poses); gl.bufferData(gl.ARRAY_BUFFER, 64 * n * JOINTS, gl.DYNAMIC_DRAW); }
  }
  /** The ankle as high over the ground below it as the clip has it over flat ground. */
  function aim(targets, i, x, y, z, root) { targets[3 * i] = x; targets[3 * i + 1] = y - root + ground(x, z); targets[3 * i + 2] = z; }
  function withDq8(clock) {
    const { roots, models, palette, at, atRun, weights, targets, poles } = arrays, n = state.people;
    for (const [array, values] of [[at, plain.atA], [atRun, plain.atB], [weights, plain.weights]]) array.view.set(values);
    const start = clock();
    skeleton.localToModel(walk.sample(at).blend(race.sample(atRun), weights), models, { roots });
    LIMBS.forEach((limb, k) => {
      const m = models.view, t = targets[k].view, r = plain.roots, foot = limb[2];
      for (let i = 0; i < n; i++) {
        const o = 8 * (i * JOINTS + foot), x = m[o], y = m[o + 1], z = m[o + 2], w = m[o + 3], a = m[o + 4], b = m[o + 5], c = m[o + 6], d = m[o + 7];
        aim(t, i, 2 * (w * a - d * x + y * c - z * b), 2 * (w * b - d * y + z * a - x * c), 2 * (w * c - d * z + x * b - y * a), r[7 * i + 5]);
      }
      skeleton.twoBone(limb, models, targets[k], poles);
    });
    skeleton.modelPalette(models, { inverseBinds, palette });
    return clock() - start;
  }
  function withJavaScript(clock) { const start = clock(); animate(plain); return clock() - start; }
  const median = (of) => of.slice().sort((a, b) => a - b)[of.length >> 1], clock = () => performance.now();
  /** The largest difference between the two palettes. */
  state.difference = () => { const a = arrays.palette.view, b = plain.palette; let most = 0; for (let i = 0; i < a.length; i++) most = Math.max(most, Math.abs(a[i] - b[i])); return most; };
  /** How far ankles are from where they should be, at most. */
  state.feet = () => { let most = 0; LIMBS.forEach((limb, k) => { for (let i = 0; i < state.people; i++) { const p = place(arrays.models.view, i * JOINTS + limb[2]), t = arrays.targets[k].view; most = Math.max(most, Math.hypot(p[0] - t[3 * i], p[1] - t[3 * i + 1], p[2] - t[3 * i + 2])); } }); return most; };
  let poses, draw3d = () => {};
  if (gl) {
    const [body, earth] = [program(gl, VERTEX, FRAGMENT), program(gl, GROUND, EARTH)], cube = [], N = 64, soil = [];
    for (let axis = 0; axis < 3; axis++) for (const side of [-1, 1]) for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) {
      const p = [0, 0, 0], n = [0, 0, 0];
      p[axis] = n[axis] = side; p[(axis + 1) % 3] = u; p[(axis + 2) % 3] = v;
      cube.push(...p, ...n);
    }
    const buffer = (data) => { const made = gl.createBuffer(); gl.bindBuffer(gl.ARRAY_BUFFER, made); if (data) gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW); return made; };
    const bodies = gl.createVertexArray(), field = gl.createVertexArray();
    gl.bindVertexArray(bodies);
    buffer(cube);
    for (const k of [0, 1]) { gl.enableVertexAttribArray(k); gl.vertexAttribPointer(k, 3, gl.FLOAT, false, 24, 12 * k); }
    poses = buffer();
    for (let k = 0; k < 4; k++) { gl.enableVertexAttribArray(2 + k); gl.vertexAttribPointer(2 + k, 4, gl.FLOAT, false, 64, 16 * k); gl.vertexAttribDivisor(2 + k, 1); }
    gl.bindVertexArray(field);
    let size = 0;
    const ground_ = buffer();
    gl.enableVertexAttribArray(0); gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    const place2 = (name) => gl.getUniformLocation(body, name), view2 = gl.getUniformLocation(earth, "view");
    gl.useProgram(body);
    gl.uniform3fv(place2("sizes"), BODY.flatMap(([, , , half]) => half));
    gl.enable(gl.DEPTH_TEST);
    draw3d = () => {
      const side = 1.1 * Math.ceil(Math.sqrt(state.people)) + 1.5;
      if (size !== side) {
        size = side; soil.length = 0;
        const at = (k) => size * (k / N - 0.5), point = (i, k) => soil.push(at(i), ground(at(i), at(k)) - ANKLE / 3, at(k));
        for (let i = 0; i < N; i++) for (let k = 0; k < N; k++) for (const [a, b] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]) point(i + a, k + b);
        gl.bindBuffer(gl.ARRAY_BUFFER, ground_); gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(soil), gl.STATIC_DRAW);
      }
      const [r, u, f] = scene.axes(), wide = canvas.width / canvas.height, far = size * 1.02 * Math.max(1, 1 / wide) + 2, t = 1.7, near = 0.1, back = 4 * far;
      const eye = (row, extra) => -0.8 * row[1] - extra;
      const view = new Float32Array(16), depth = [(back + near) / (near - back), 2 * back * near / (near - back)];
      for (let k = 0; k < 3; k++) { view[4 * k] = t / wide * r[k]; view[4 * k + 1] = t * u[k]; view[4 * k + 2] = depth[0] * f[k]; view[4 * k + 3] = -f[k]; }
      view[12] = t / wide * eye(r, 0); view[13] = t * eye(u, 0); view[14] = depth[0] * eye(f, far) + depth[1]; view[15] = -eye(f, far);
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(0, 0, 0, 0); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.useProgram(earth); gl.uniformMatrix4fv(view2, false, view); gl.bindVertexArray(field); gl.drawArrays(gl.TRIANGLES, 0, soil.length / 3);
      gl.bindBuffer(gl.ARRAY_BUFFER, poses); gl.bufferSubData(gl.ARRAY_BUFFER, 0, arrays.palette.view);
      gl.useProgram(body); gl.uniformMatrix4fv(place2("view"), false, view); gl.bindVertexArray(bodies); gl.drawArraysInstanced(gl.TRIANGLES, 0, cube.length / 6, state.people * JOINTS);
    };
  }
  state.gl = Boolean(gl);
  let time = 0, before = 0, seen = true;
  new IntersectionObserver(([entry]) => { seen = entry.isIntersecting; }).observe(canvas);
  state.frame = (seconds, draws = true) => {
    const n = Math.max(1, Math.round((people.value / 100) ** 2 * 10000));
    if (n !== state.people) resize(n);
    time += seconds;
    for (let i = 0; i < n; i++) {
      const own = 0.8 + 0.4 * ((i * 0.618) % 1);
      plain.atA[i] = (24 * own * time + 7.3 * i) % (FRAMES - 1); plain.atB[i] = (40 * own * time + 11.9 * i) % (FRAMES - 1);
      plain.weights[i] = Math.min(1, Math.max(0, run.value / 50 - 1 + (i * 0.377) % 1));
    }
    times.push(withDq8(clock)); times2.push(withJavaScript(clock));
    if (times.length > 61) { times.shift(); times2.shift(); }
    state.rounds++;
    if (draws) draw3d();
    const [a, b] = [median(times), median(times2)], ready = state.rounds >= ROUNDS;
    state.ratio = ready ? b / a : undefined;
    scene.output.innerHTML = `${gl ? "" : "<b>This browser has no WebGL: nothing can be drawn, the numbers are computed all the same.</b> "}<b>${n.toLocaleString("en")}</b> people, ${(n * JOINTS).toLocaleString("en")} joints: `
      + (ready ? `<span class="b">dq8 <b>${a.toFixed(1)} ms</b></span>, <span class="a">the same loop in JavaScript <b>${b.toFixed(1)} ms</b></span>` + (a >= 0.5 ? `: ${(b / a).toFixed(1)} times` : "; too few to compare: the clock of a page is coarse") : "warming up");
  };
  const loop = (now) => {
    const seconds = Math.min(0.1, (now - before) / 1000);
    before = now;
    if (seen && !pause.checked && !document.hidden) state.frame(seconds); else if (seen) draw3d();
    requestAnimationFrame(loop);
  };
  state.frame(0);
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) pause.checked = true;
  requestAnimationFrame(loop);
  return state;
}
